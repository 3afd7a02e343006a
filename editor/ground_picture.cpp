#include "editor/ground_picture.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

struct Tint {
    float share; // of the heights
    glm::vec3 colour;
};
constexpr Tint kTints[] = {{0, {0.36f, 0.47f, 0.32f}}, {0.2f, {0.50f, 0.58f, 0.36f}}, {0.45f, {0.66f, 0.60f, 0.42f}},
                           {0.7f, {0.60f, 0.53f, 0.46f}}, {0.88f, {0.75f, 0.73f, 0.71f}}, {1, {0.97f, 0.97f, 0.98f}}};
constexpr glm::vec3 kRock{0.52f, 0.49f, 0.46f};

glm::vec3 tintOf(float share)
{
    for (std::size_t i = 1; i < std::size(kTints); ++i)
        if (share <= kTints[i].share)
            return glm::mix(kTints[i - 1].colour, kTints[i].colour, std::max(0.0f, share - kTints[i - 1].share) / (kTints[i].share - kTints[i - 1].share));
    return kTints[std::size(kTints) - 1].colour;
}

} // namespace

std::vector<std::uint32_t> shadedRelief(const io::HeightGrid& heights, float low, float high)
{
    const glm::vec3 toLight = glm::normalize(glm::vec3{-1, 1.2f, -1}); // from the north-west, as on maps
    std::vector<std::uint32_t> colours;
    colours.reserve(heights.metres.size());
    const auto step = float(2 * heights.metresPerTexel);
    for (int z = 0; z < heights.size.y; ++z)
        for (int x = 0; x < heights.size.x; ++x) {
            const glm::vec3 normal = glm::normalize(glm::vec3{(heights.clampedAt(x - 1, z) - heights.clampedAt(x + 1, z)) / step, 1,
                                                              (heights.clampedAt(x, z - 1) - heights.clampedAt(x, z + 1)) / step});
            const float share = high > low ? (heights.at(x, z) - low) / (high - low) : 0;
            const float light = 0.45f + 0.8f * std::max(0.0f, glm::dot(normal, toLight));
            const glm::vec3 colour = glm::mix(tintOf(share), kRock, glm::smoothstep(0.88f, 0.74f, normal.y)) * light;
            const auto byte = [](float v) { return std::uint32_t(std::clamp(v, 0.0f, 1.0f) * 255 + 0.5f); };
            colours.push_back(byte(colour.r) | byte(colour.g) << 8 | byte(colour.b) << 16 | 0xff000000u);
        }
    return colours;
}

} // namespace editor
