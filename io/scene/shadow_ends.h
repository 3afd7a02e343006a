// Where shadow cascades end when each end is set by hand: farther one after the other, the last one at the shadows' distance.
#pragma once

#include "io/scene/environment.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace io {

struct EndFault {
    std::string key; // of Shadows: "end_2" or "distance"
    std::string what;
};
std::optional<EndFault> endFault(const Shadows& shadows); // of the ends that count; none where they come from lambda

// None changes ends that rise already.
void pushEnds(Shadows& shadows, std::string_view kept); // out of the way of the one with that key, as far as needed
void spreadEnds(Shadows& shadows); // those that do not rise lie evenly between their neighbours then, by ratio
// The same around those of these keys, which stay, and the distance goes beyond them: a fault where they do not rise themselves.
std::optional<EndFault> spreadEnds(Shadows& shadows, std::span<const std::string_view> kept);

} // namespace io
