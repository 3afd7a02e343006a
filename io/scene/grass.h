// Grass: kinds of small plants that stand in such numbers that nobody places one of them, and where they were painted.
#pragma once

#include "io/scene/extra.h"
#include "io/scene/texel_tiles.h"

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

namespace io {

constexpr int kMostGrassKinds = 16;
constexpr double kMostGrass = 64; // plants a square metre, of all kinds together

struct GrassKind {
    std::string name;
    std::string plant;             // the template whose model each of them shows; empty: a blade
    float density = 40;            // a square metre, where it was painted in full
    glm::vec2 height{0.25f, 0.5f}; // m, range from which each plant draws its own
    float width = 0.012f;          // m, of a blade at its root
    glm::vec3 rootColour{0.05f, 0.09f, 0.02f}; // linear
    glm::vec3 tipColour{0.16f, 0.24f, 0.06f};
    float variety = 0.35f;         // how far colours differ: 0 all alike
    float groundColour = 0.5f;     // share that the ground's own colour has in them at the root
    float bend = 0.45f;            // 0 upright, 1 tips hang
    float clump = 0.5f;            // how alike those of one clump lean and grow
    float clumpSize = 0.9f;        // m
    float wind = 1;                // how freely it sways
    glm::vec2 slope{0, 42};        // degrees from level, where it grows
    glm::vec2 altitude{-1e5f, 1e5f}; // m
    glm::vec2 aboveWater{0.05f, 1e5f}; // m of its root above the water's level, where there is water
    Extra extra;
    bool operator==(const GrassKind&) const = default;
};

// What a scene says of its grass.
struct Grass {
    std::string map;           // terrain/….png inside the project; empty: none was painted
    double metresPerTexel = 1; // of the map, whatever the ground's texels are
    glm::dvec2 origin{0};      // world x and z of its texel (0, 0)
    std::vector<GrassKind> kinds;
    Extra extra;
    bool operator==(const Grass&) const = default;
};

// A texel of the map: two kinds that stand beside each other.
struct GrassCover {
    int kind[2] = {0, 0};       // 0..15
    float density[2] = {0, 0};  // shares of the kinds' own
    float height = 1;           // factor of the kinds' own, 0 to 1.99
    bool operator==(const GrassCover&) const = default;
};

// 0 is a texel on which nothing grows. Bytes: both kinds, four bits each; their densities; the height, 128 is 1.
constexpr std::uint32_t packed(const GrassCover& c)
{
    const auto byte = [](float v) { return std::uint32_t(v <= 0 ? 0 : v >= 255 ? 255 : v + 0.5f); };
    const std::uint32_t first = byte(c.density[0] * 255), second = byte(c.density[1] * 255);
    if (first == 0 && second == 0) return 0;
    const std::uint32_t kinds = (first ? std::uint32_t(c.kind[0] & 15) : 0) | (second ? std::uint32_t(c.kind[1] & 15) << 4 : 0);
    return kinds | first << 8 | second << 16 | byte(c.height * 128) << 24;
}
constexpr GrassCover unpackedGrass(std::uint32_t bits)
{
    if (bits == 0) return {};
    return {{int(bits & 15), int(bits >> 4 & 15)}, {float(bits >> 8 & 255) / 255, float(bits >> 16 & 255) / 255}, float(bits >> 24) / 128};
}

// A value that does not change: with() makes another, which shares what is the same.
class GrassMap {
public:
    GrassMap() = default;
    GrassMap(TexelTiles<std::uint32_t> texels, double metres, glm::dvec2 corner) : metresPerTexel{metres}, origin{corner}, m_field{std::move(texels)} {}

    double metresPerTexel = 1;
    glm::dvec2 origin{0}; // world x and z of texel (0, 0)

    const TexelTiles<std::uint32_t>& field() const { return m_field; }
    glm::ivec2 size() const { return m_field.size(); }
    GrassCover at(glm::dvec2 place) const // world x and z; of the nearest texel
    {
        const glm::dvec2 texel = glm::floor((place - origin) / metresPerTexel + 0.5);
        if (texel.x < 0 || texel.y < 0 || texel.x >= size().x || texel.y >= size().y) return {};
        return unpackedGrass(m_field.at(int(texel.x), int(texel.y)));
    }
    GrassMap with(TexelTiles<std::uint32_t> field) const { return {std::move(field), metresPerTexel, origin}; } // of the same size
    bool operator==(const GrassMap&) const = default;

private:
    TexelTiles<std::uint32_t> m_field;
};

} // namespace io
