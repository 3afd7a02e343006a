// Shadow maps of lamps: tiles of one atlas, one for a spot and six for what shines all around. A tile is kept until its
// lamp moves, or something within the lamp's range.
#pragma once

#include "renderer/passes/object_programs.h"
#include "renderer/scenery.h"
#include "renderer/shaders/shared/lamps.h"

namespace renderer {

struct LampShadow {
    std::vector<glm::mat4> atlasFromLamp; // one a face; none: no shadow
    float texelAngle = 0;                 // width of a texel 1 m away, m
};

class LampShadows {
public:
    explicit LampShadows(ShaderLibrary& shaders);

    // Of the nearest and brightest lamps that ask for it, as many as there are tiles; beside `lamps`. Looks at what moved
    // in the scenery also while there are none, so it is to be called in each frame, before that is forgotten.
    std::vector<LampShadow> render(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, std::span<const Lamp> lamps,
                                   const Settings& settings);
    void bind(GpuFrame& gpu) const;
    float texel() const { return m_atlas ? 1.0f / float(m_atlas.size().x) : 1.0f; } // of the atlas' side

private:
    struct Held {
        Lamp lamp; // as it was drawn
        std::vector<int> tiles;
        bool stale = true;
        bool wanted = false;
    };
    struct Key { // of what all tiles are drawn with
        std::uint64_t world = 0, terrain = 0;
        float lodPixels = 0;
        bool operator==(const Key&) const = default;
    };
    void resize(int tile);
    void markStale(const Scenery& scenery, const Settings& settings);
    void choose(std::span<const Lamp> lamps);
    Held* find(io::ObjectId object);
    void draw(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, const Lamp& lamp, int face, int tile, const Settings& settings);

    ShaderLibrary& m_shaders;
    ObjectPrograms m_masked;
    const gl::Program& m_solid;
    gl::VertexArray m_objects;
    gl::Texture m_atlas, m_none;
    gl::Framebuffer m_target;
    int m_tile = 0; // texels along a side
    std::vector<Held> m_held;
    std::vector<int> m_free;
    Key m_key;
};

} // namespace renderer
