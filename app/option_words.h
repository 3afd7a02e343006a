// What the parts of the command line's parser share.
#pragma once

#include "app/options.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <string_view>

namespace app {

inline CLI::ValidationError wrong(std::string_view option, std::string_view value, std::string_view wanted)
{
    return CLI::ValidationError{fmt::format("{} {}: {}", option, value, wanted)};
}

void addImport(CLI::App& app, Options& o); // FILE… and what it says of height maps
void addExport(CLI::App& app, Options& o);

} // namespace app
