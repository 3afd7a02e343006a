// Looks of the day: named values for light, air and weather. A look says nothing of the place (where on earth, which day of
// the year, water), so that stays as a scene has it. Those that ship say nothing of shadows and occlusion either; a person's own do.
#pragma once

#include "io/scene/environment.h"

#include <array>
#include <optional>
#include <string_view>

namespace io {

enum class Preset { Dawn, Noon, GoldenHour, Dusk, Overcast, Storm, Night };
constexpr auto enumNames(Preset)
{
    return std::array<std::string_view, 7>{"dawn", "noon", "golden-hour", "dusk", "overcast", "storm", "night"};
}

Environment withPreset(const Environment& own, Preset preset);
Environment withLook(const Environment& own, const Environment& look); // `own`'s place under the light of another

// The hour of the day on which the sun passes this height (degrees) upwards or downwards; none where it does not that day.
std::optional<float> hourOf(const Environment& environment, double elevation, bool rising);

} // namespace io
