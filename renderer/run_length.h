// Pictures with large empty parts in few bytes: texels that repeat are stored once with their count.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace renderer {

void packTexels(std::span<const std::uint32_t> texels, std::string& bytes); // appends
// Takes from the front of `bytes` what fills `texels` exactly; false where it does not fit.
bool unpackTexels(std::string_view& bytes, std::span<std::uint32_t> texels);

} // namespace renderer
