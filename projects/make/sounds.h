// The sounds that ship, made of noise and tones: the same bytes every time, small, without a seam where they repeat.
#pragma once

#include "io/base/result.h"
#include "projects/make/wave.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace make {

struct SoundPlan {
    std::string_view name; // sounds/NAME.ogg
    Wave (*make)();
    bool repeats = true;
    double quality = 0.2; // of Vorbis, 0..1
};
std::span<const SoundPlan> soundPlans();

// Ogg Vorbis in mono.
io::Result<std::string> encodeOgg(const Wave& wave, double quality);
io::Status writeSounds(const std::filesystem::path& project); // all of them

Wave makeWindSound();
Wave makeBirdsSound();
Wave makeStreamSound();
Wave makeFireSound();
// Several steps each, with silence between.
Wave makeGrassSteps();
Wave makeGravelSteps();
Wave makeSandSteps();
Wave makeSnowSteps();
Wave makeWoodSteps();

} // namespace make
