// The ground on the GPU: heights, normals, layers, and the grids or patches that a view draws.
#pragma once

#include "io/scene/assets.h"
#include "io/scene/changes.h"
#include "io/scene/scene.h"
#include "renderer/eye.h"
#include "renderer/gpu_frame.h"
#include "renderer/ground_horizon.h"
#include "renderer/settings.h"
#include "renderer/shader_library.h"
#include "renderer/terrain_choice.h"
#include "renderer/terrain_layers.h"
#include "renderer/terrain_texels.h"

#include <map>

namespace renderer {

// From which size on a map is held as windows around the eye, and how wide those are; texels.
struct TerrainLimits {
    int whole = 8192, window = 1344;
};

class Terrain {
public:
    explicit Terrain(TerrainLimits limits = {});
    void update(const io::Scene& scene, const io::Assets& assets, const io::Changes& changes);
    bool present() const { return bool(m_map); }

    // Chooses the levels of detail that an eye needs, to be seen by another (usually the same).
    void aim(const Eye& eye, const Eye& levelsFor, double errorPixels = 1);

    // The chosen nodes that a volume sees and that no other ground hides (or, without one, all of them); the block and textures are bound.
    struct Draw {
        GroundStages stages = GroundStages::Grid;
        GpuStream::Piece patches, commands;
        std::uint32_t commandCount = 0;
        std::uint64_t triangles = 0; // at most
    };
    using Draws = std::vector<Draw>; // at most one for each of the stages
    Draws draws(GpuStream& stream, const std::optional<Volume>& volume, GroundStages stages) const;
    // The same wherever the eye is: of one level that strays at most `error` m, so a shadow map that is kept stays right. Grids, as
    // there is nothing to tessellate by. Of a map in windows it is coarser where that level is not there, as the eye last was.
    Draw shadowDraw(GpuStream& stream, const std::optional<Volume>& volume, double error);
    void bind(GpuFrame& gpu) const;          // to be shaded
    void bindForShadows(GpuFrame& gpu) const;
    void draw(GpuFrame& gpu, const Draw& draw);

    // Draws what draws() gave, with a fragment stage that takes `place` (terrain.vert.glsl).
    ProgramDesc program(std::string label, GroundStages stages, std::string fragment, std::vector<std::string> defines = {}) const;
    std::vector<std::string> coverDefines() const; // of fragment stages that ask which layers cover it
    bool holed() const { return m_holed; } // perhaps; what is not is drawn a little faster
    io::WorldBox bounds() const;
    glm::vec2 heightsWithin(const glm::dvec2& from, const glm::dvec2& to) const; // lowest and highest, m; world x and z
    bool windowed() const { return m_windowed; } // not all of it is on the GPU
    // Texels that look other than they did at the last forgetRepainted().
    const io::TexelRect& repainted() const { return m_repainted; }
    void forgetRepainted() { m_repainted = {}; }
    std::uint64_t revision() const { return m_revision; } // counts changes of all of it
    // Where the ground rose or sank since the last forgetTouched(): spheres, m, that hold it as it was and as it is.
    std::span<const glm::dvec4> touched() const { return m_touched; }
    void forgetTouched() { m_touched.clear(); }
    const std::shared_ptr<const io::HeightMap>& heights() const { return m_map; }

private:
    void loadHeights();
    void updateCover(const std::shared_ptr<const io::CoverMap>& cover, const io::Changes& changes);
    void touch(const io::TexelRect& rect, float low, float high); // what that part can shade is drawn anew; m
    void changeHeights(const io::TexelRect& changed);
    void makeGrid();
    void measureFlow();
    GroundHorizon::Box boxOf(const GroundNode& node) const; // from the map's first texel
    bool eyeAboveGround() const;
    std::vector<ChosenNode> chosenBeforeOthers(const Volume& volume) const; // what other ground hides is left out
    bool sees(const std::optional<Volume>& volume, const GroundNode& node) const;
    Draw drawOf(GpuStream& stream, std::span<const ChosenNode> chosen, GroundStages stages) const;

    std::shared_ptr<const io::HeightMap> m_map;
    TerrainTree m_tree;
    TerrainLimits m_limits;
    std::unique_ptr<TerrainTexels> m_texels; // of the map, and of what covers it
    bool m_windowed = false;
    std::shared_ptr<const io::CoverMap> m_coverMap;
    bool m_holed = false;
    TerrainLayers m_layers;
    gl::Texture m_flow; // as io::GroundFlow; empty while no layer asks for it
    gl::Buffer m_gridVertices, m_gridIndices;
    gl::VertexArray m_grids, m_patches;
    glsl::Terrain m_block{};
    TerrainChoice m_choice;
    std::map<int, TerrainChoice> m_shadowChoices; // by level, of a map in windows; made when asked for in a frame
    glm::dvec3 m_levelsFrom{0}; // m, from the map's first texel
    std::uint64_t m_revision = 0;
    io::TexelRect m_repainted;
    std::vector<glm::dvec4> m_touched;
};

} // namespace renderer
