// Grass on the GPU: its map and kinds as the scene has them, and what of it may be seen from an eye.
#pragma once

#include "io/scene/changes.h"
#include "io/scene/scene.h"
#include "renderer/cull.h"
#include "renderer/footprint_mask.h"
#include "renderer/settings.h"
#include "renderer/shaders/shared/grass.h"

#include <span>
#include <vector>

namespace renderer {

class Grass {
public:
    void update(const io::Scene& scene, const io::Changes& changes);
    bool present() const { return bool(m_map) && !m_kinds.empty(); }

    // The tiles that a frame looks for grass in: those of each level that lie around the eye and that the volume sees.
    std::vector<glsl::GrassTile> tiles(const Terrain& terrain, const Eye& eye, const std::optional<Volume>& volume, const Settings& settings) const;
    // Of the map, the kinds and the eye; the pass adds what it alone knows.
    glsl::GrassFrame frame(const Eye& eye, const Settings& settings) const;
    // The share of plants that stays where too many may grow around an eye to be drawn. It does not ask which way the eye looks, so that
    // turning it takes none away.
    float kept(const Eye& eye, const Settings& settings) const;
    const gl::Texture& map() const { return m_texels; }
    std::span<const io::TemplateId> plants() const { return m_plants; } // whose models kinds show, by kind; None: blades

private:
    std::shared_ptr<const io::GrassMap> m_map;
    std::vector<io::GrassKind> m_kinds;
    std::vector<io::TemplateId> m_plants;
    gl::Texture m_texels;
    float m_tallest = 0; // m

    void measure(const io::TexelRect& texels);
    glm::ivec2 m_blocks{0};      // of texels of the map
    std::vector<float> m_dense;  // plants a cell that may grow in each, before rules of the ground take from them
};

constexpr float grassFullTo(const Settings& settings) // m, from there on fewer are drawn
{
    return settings.grassDistance * 0.27f;
}

} // namespace renderer
