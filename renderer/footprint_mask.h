// Where grass must not grow: the footprints of placed things as texels of the world, in a window around the eye that wraps around.
// Only what came into the window, and where something came, went or moved, is looked at.
#pragma once

#include "io/scene/texel_rect.h"
#include "renderer/terrain.h"
#include "renderer/world.h"

#include <vector>

namespace renderer {

class FootprintMask {
public:
    // Once a frame, before others forget what was touched. It knows all to so many metres from the eye.
    void update(const World& world, const Terrain& terrain, const glm::dvec3& eye, double distance);
    void forget() { m_known = false; } // the next update looks at all of it

    const gl::Texture& texture() const { return m_texture; } // R8, above 0: covered
    bool covers(const glm::dvec2& place) const; // within the window

private:
    void redraw(const World& world, const Terrain& terrain, const io::TexelRect& part);
    void draw(const glsl::Instance& instance, const io::FootprintShape& shape, const io::TexelRect& part, const Terrain& terrain);
    void send(const io::TexelRect& part);
    std::size_t indexOf(io::Texel texel) const
    {
        return std::size_t(texel.y & (m_side - 1)) * std::size_t(m_side) + std::size_t(texel.x & (m_side - 1));
    }

    int m_side = 0; // texels of GRASS_CELL, a power of two
    bool m_known = false;
    io::TexelRect m_window; // of the world
    std::uint64_t m_worldRevision = 0, m_terrainRevision = 0;
    std::vector<std::uint8_t> m_texels;
    gl::Texture m_texture;
};

} // namespace renderer
