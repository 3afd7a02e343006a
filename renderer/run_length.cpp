#include "renderer/run_length.h"

#include <algorithm>
#include <cstring>

namespace renderer {
namespace {

// A piece is a count and then one texel for all of them, or each of them by itself.
constexpr std::uint32_t kRepeated = 0x80000000u;
constexpr std::size_t kShortest = 3; // of runs: a shorter one would take more than it saves

std::size_t runAt(std::span<const std::uint32_t> texels)
{
    const auto other = std::ranges::find_if(texels, [&](std::uint32_t texel) { return texel != texels[0]; });
    return std::size_t(other - texels.begin());
}

void put(std::uint32_t count, std::span<const std::uint32_t> texels, std::string& bytes)
{
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    bytes.append(reinterpret_cast<const char*>(texels.data()), texels.size_bytes());
}

bool take(std::string_view& bytes, std::span<std::uint32_t> texels)
{
    if (bytes.size() < texels.size_bytes()) return false;
    std::memcpy(texels.data(), bytes.data(), texels.size_bytes());
    bytes.remove_prefix(texels.size_bytes());
    return true;
}

} // namespace

void packTexels(std::span<const std::uint32_t> texels, std::string& bytes)
{
    while (!texels.empty()) {
        std::size_t single = 0, run = 0; // texels that differ, and the run after them
        while (single < texels.size() && (run = runAt(texels.subspan(single))) < kShortest)
            single += run;
        if (single == texels.size()) run = 0;
        if (single > 0) put(std::uint32_t(single), texels.first(single), bytes);
        if (run > 0) put(std::uint32_t(run) | kRepeated, texels.subspan(single, 1), bytes);
        texels = texels.subspan(single + run);
    }
}

bool unpackTexels(std::string_view& bytes, std::span<std::uint32_t> texels)
{
    while (!texels.empty()) {
        std::uint32_t head = 0;
        if (!take(bytes, {&head, 1})) return false;
        const std::size_t count = head & ~kRepeated;
        if (count == 0 || count > texels.size()) return false;
        const std::span<std::uint32_t> piece = texels.first(count);
        if (!take(bytes, head & kRepeated ? piece.first(1) : piece)) return false;
        if (head & kRepeated) std::ranges::fill(piece, piece[0]);
        texels = texels.subspan(count);
    }
    return true;
}

} // namespace renderer
