// How loud a person wants to hear worlds, in play and while editing.
#pragma once

#include "io/base/value.h"
#include "io/scene/template.h"

#include <array>

namespace editor {

struct SoundSettings {
    bool hear = false; // the world sounds while it is edited
    bool muted = false;
    float master = 1;
    std::array<float, 4> groups{1, 1, 1, 1}; // by io::SoundGroup

    bool operator==(const SoundSettings&) const = default;
};

constexpr float kLoudest = 2; // factor of the amplitude

io::Value toValue(const SoundSettings& sound);
void restore(SoundSettings& sound, const io::Value& saved); // what is missing or wrong stays

} // namespace editor
