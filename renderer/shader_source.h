// The text of a shader stage with its includes put in, and the way back from a compiler's line to a file's.
#pragma once

#include "io/base/result.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace renderer {

struct ShaderSource {
    std::string text;                         // starts with #version and the defines
    std::vector<std::filesystem::path> files; // number i of a #line directive is files[i]
};

// `name` is a file of `folder`. Quoted includes are looked for beside the includer, then in `folder`; each is put
// in once. Includes in angle brackets belong to C++ and stay as they are, behind their #ifdef.
io::Result<ShaderSource> readShader(const std::filesystem::path& folder, std::string_view name,
                                    std::span<const std::string> defines);

// "file:line" of the first message of a compiler's log ("0:12(5): error", "0(12) : error", "ERROR: 0:12:").
std::string placeOf(const ShaderSource& source, std::string_view log);

} // namespace renderer
