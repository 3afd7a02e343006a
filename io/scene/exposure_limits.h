// Between which exposures the automatic one stays: the lowest is not above the highest.
#pragma once

#include "io/scene/environment.h"

#include <optional>
#include <string>
#include <string_view>

namespace io {

std::optional<std::string> limitsFault(const AutoExposure& exposure); // what is wrong with "highest"
void pushLimits(AutoExposure& exposure, std::string_view kept);       // the other goes along with the one of that key

} // namespace io
