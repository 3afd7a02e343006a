// What a landscape is made of: the list that the Generate dialog, scripts and docs/command-line.md read.
#pragma once

#include "io/scene/fields.h"

#include <optional>
#include <string>

namespace editor {

constexpr int kMostSide = 8193; // texels; a map of so many along both sides takes 256 MiB

struct GroundRecipe {
    int seed = 1;
    int width = 1025, depth = 1025; // texels along x and z
    double metresPerTexel = 4;
    float lowest = 0, highest = 700; // m, that the made ground reaches
    float land = 0.75f;         // share of it that is not lowland, 0..1
    float continents = 3600;    // m, size of the largest forms
    float roughness = 0.5f;     // amplitude of each octave against the one before, 0.3..0.7
    float ridges = 0.6f;        // how far mountains make the land, 0..1
    float ridgeScale = 1500;    // m, from crest to crest
    float warp = 0.5f;          // how far forms are bent, 0..1
    float erosion = 0.6f;       // by rivers, 0..1
    float talus = 38;           // degrees; steeper ground slides
    float terraces = 0;         // 0..1
    float terraceStep = 60;     // m
    bool operator==(const GroundRecipe&) const = default;
};

void fields(auto& v, io::Of<GroundRecipe> auto& r)
{
    v("seed", r.seed, io::Hint{.min = 0, .max = 999'999});
    v("width", r.width, io::Hint{.min = 2, .max = kMostSide, .unit = "texels"});
    v("depth", r.depth, io::Hint{.min = 2, .max = kMostSide, .unit = "texels"});
    v("metres_per_texel", r.metresPerTexel, io::Hint{.min = 0.01, .max = 1000, .unit = "m", .style = io::Style::Logarithmic});
    v("lowest", r.lowest, io::Hint{.min = -10'000, .max = 10'000, .unit = "m"});
    v("highest", r.highest, io::Hint{.min = -10'000, .max = 10'000, .unit = "m"});
    v("land", r.land, io::Hint{.min = 0, .max = 1});
    v("continents", r.continents, io::Hint{.min = 1, .max = 1e6, .unit = "m", .style = io::Style::Logarithmic});
    v("roughness", r.roughness, io::Hint{.min = 0.3, .max = 0.7});
    v("ridges", r.ridges, io::Hint{.min = 0, .max = 1});
    v("ridge_scale", r.ridgeScale, io::Hint{.min = 1, .max = 1e6, .unit = "m", .style = io::Style::Logarithmic});
    v("warp", r.warp, io::Hint{.min = 0, .max = 1});
    v("erosion", r.erosion, io::Hint{.min = 0, .max = 1});
    v("talus", r.talus, io::Hint{.min = 5, .max = 80, .unit = "deg"});
    v("terraces", r.terraces, io::Hint{.min = 0, .max = 1});
    v("terrace_step", r.terraceStep, io::Hint{.min = 0.1, .max = 1000, .unit = "m", .style = io::Style::Logarithmic});
}

// What is wrong with it, in words that name the field; empty when ground can be made of it.
std::optional<std::string> faultOf(const GroundRecipe& recipe);

// The same landscape with at most so many texels along its longer side: what a preview makes.
GroundRecipe coarser(GroundRecipe recipe, int side);

} // namespace editor
