// The valley's grass: meadows on the plain with flowers and tall tufts in them, drier ones on its knolls, tufts under the trees, reeds along the stream.
#include "projects/make/noise.h"
#include "projects/make/valley.h"
#include "projects/make/valley_land.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace make {
namespace {

constexpr int kTexels = 2; // of the heights

enum Kind { Meadow, Dry, Woodland, Reeds, Flowers, Tall };

std::vector<io::GrassKind> kinds()
{
    return {{.name = "Meadow",
             .density = 56,
             .height = {0.2f, 0.46f},
             .width = 0.024f,
             .rootColour = {0.045f, 0.070f, 0.014f},
             .tipColour = {0.170f, 0.235f, 0.055f},
             .variety = 0.5f,
             .groundColour = 0.45f,
             .bend = 0.5f,
             .slope = {0, 38}},
            {.name = "Dry grass",
             .density = 24,
             .height = {0.3f, 0.62f},
             .width = 0.013f,
             .rootColour = {0.070f, 0.075f, 0.025f},
             .tipColour = {0.300f, 0.250f, 0.110f},
             .variety = 0.5f,
             .bend = 0.6f,
             .clumpSize = 0.7f,
             .slope = {0, 40}},
            {.name = "Woodland tufts",
             .density = 30,
             .height = {0.12f, 0.3f},
             .width = 0.02f,
             .rootColour = {0.030f, 0.045f, 0.012f},
             .tipColour = {0.095f, 0.130f, 0.035f},
             .bend = 0.7f,
             .clump = 0.8f,
             .clumpSize = 0.6f,
             .slope = {0, 36}},
            {.name = "Reeds",
             .density = 16,
             .height = {0.9f, 1.7f},
             .width = 0.02f,
             .rootColour = {0.060f, 0.080f, 0.030f},
             .tipColour = {0.230f, 0.230f, 0.100f},
             .groundColour = 0.2f,
             .bend = 0.22f,
             .clump = 0.4f,
             .clumpSize = 1.6f,
             .slope = {0, 45},
             .aboveWater = {-0.35f, 0.35f}},
            {.name = "Wild flowers",
             .plant = "flowers",
             .density = 0.9f,
             .height = {0.4f, 0.75f},
             .clumpSize = 2.5f,
             .slope = {0, 30}},
            {.name = "Tall tufts",
             .plant = "grass",
             .density = 0.45f,
             .height = {0.25f, 0.6f},
             .clumpSize = 2,
             .slope = {0, 36}}};
}

float smooth(float low, float high, float x)
{
    return glm::smoothstep(low, high, x);
}

io::GrassCover coverAt(const Stage& stage, glm::vec2 p)
{
    const float forest = forestAt(stage, p), height = heightAt(stage.heights(), p), stream = streamDistance(p);
    if (stream < 14 && noise(p / 11.0f, 971) > -0.05f && height < 29.2f) return {{Reeds, Meadow}, {0.9f, 0.0f}, 1};
    const float open = 1 - smooth(0.12f, 0.42f, forest), high = smooth(150, 185, height);
    const float patch = 0.5f + 0.5f * noise(p / 26.0f, 972), fine = 0.5f + 0.5f * noise(p / 7.0f, 973);
    const float trodden = smooth(2.4f, 6.0f, glm::length(p - kCamp)); // around the fire
    const float bank = smooth(5.0f, 9.0f, stream);
    const float dry = std::clamp(0.12f + 0.9f * smooth(0.45f, 0.8f, patch) + high, 0.0f, 1.0f);
    const float meadow = open * trodden * bank * (0.55f + 0.45f * fine);
    const float tufts = (1 - open) * trodden * smooth(0.5f, 0.85f, fine) * (1 - smooth(0.55f, 0.95f, forest)) * 0.9f;
    const float blooms = open * bank * trodden * smooth(0.56f, 0.68f, 0.5f + 0.5f * noise(p / 17.0f, 974));
    const float tall = open * bank * trodden * smooth(0.6f, 0.7f, 0.5f + 0.5f * noise(p / 13.0f, 975));
    const float others = std::round(std::max(blooms, tall) * 2) / 2; // few steps, as below
    if (others > 0) return {{Meadow, blooms > tall ? Flowers : Tall}, {meadow * (1 - 0.75f * dry), others}, 0.65f + 0.6f * patch};
    if (tufts > meadow) return {{Woodland, Dry}, {tufts, 0.25f * dry * open}, 0.8f + 0.4f * fine};
    return {{Meadow, Dry}, {meadow * (1 - 0.75f * dry), meadow * dry}, 0.65f + 0.6f * patch};
}

// Steps that nobody sees: the file is a third smaller.
io::GrassCover inSteps(io::GrassCover cover)
{
    for (float& density : cover.density)
        density = std::round(density * 20) / 20;
    cover.height = std::round(cover.height * 8) / 8;
    return cover;
}

} // namespace

void growGrass(Stage& stage)
{
    const io::HeightGrid& heights = stage.heights();
    const glm::ivec2 size = (heights.size - 1) / kTexels + 1;
    const double texel = heights.metresPerTexel * kTexels;
    std::vector<std::uint32_t> texels;
    texels.reserve(std::size_t(size.x) * std::size_t(size.y));
    for (int z = 0; z < size.y; ++z)
        for (int x = 0; x < size.x; ++x)
            texels.push_back(io::packed(inSteps(coverAt(stage, glm::vec2{heights.origin + glm::dvec2{x, z} * texel}))));
    io::Grass grass{.map = "terrain/grass.png", .metresPerTexel = texel, .origin = heights.origin, .kinds = kinds()};
    stage.setGrass(std::move(grass), io::TexelTiles<std::uint32_t>{size, texels});
}

} // namespace make
