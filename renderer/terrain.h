// The ground on the GPU: heights, normals, layers, and the grids that a view draws.
#pragma once

#include "io/scene/assets.h"
#include "io/scene/changes.h"
#include "io/scene/scene.h"
#include "renderer/eye.h"
#include "renderer/gpu_frame.h"
#include "renderer/terrain_tree.h"

namespace renderer {

using Normals = std::vector<glm::i16vec2>; // x and z, as GL_RG16_SNORM

class Terrain {
public:
    Terrain();
    void update(const io::Scene& scene, const io::Assets& assets, const io::Changes& changes);
    bool present() const { return m_heights.id() != 0; }

    // Chooses the levels of detail that an eye needs, to be seen by another (usually the same).
    void aim(const Eye& eye, const Eye& levelsFor, double leniency = 1); // 1: errors of about a pixel

    // The chosen nodes that a volume (or, without one, everybody) sees; the block and textures are bound.
    struct Draw {
        GpuStream::Piece patches, commands;
        std::uint32_t commandCount = 0;
        std::uint64_t triangles = 0;
    };
    Draw draws(GpuStream& stream, const std::optional<Volume>& volume) const;
    // The same wherever the eye is: of one level that strays at most `error` m. So a shadow map that is kept stays right.
    Draw shadowDraws(GpuStream& stream, const std::optional<Volume>& volume, double error) const;
    void bind(GpuFrame& gpu) const;          // to be shaded
    void bindForShadows(GpuFrame& gpu) const;
    void draw(GpuFrame& gpu, const Draw& draw);

    int layers() const { return m_block.layers; } // at least 1
    bool painted() const { return bool(m_cover); }
    bool holed() const { return m_holed; } // perhaps; what is not is drawn a little faster
    io::WorldBox bounds() const;
    std::uint64_t revision() const { return m_revision; } // counts changes of all of it
    // Where the ground rose or sank since the last forgetTouched(): spheres, m, that hold it as it was and as it is.
    std::span<const glm::dvec4> touched() const { return m_touched; }
    void forgetTouched() { m_touched.clear(); }
    const std::shared_ptr<const io::HeightMap>& heights() const { return m_map; }

private:
    void uploadHeights();
    void updateCover(const std::shared_ptr<const io::CoverMap>& cover, const io::Changes& changes);
    void touch(const io::TexelRect& rect, float low, float high); // what that part can shade is drawn anew; m
    void changeHeights(const io::TexelRect& changed);
    void uploadNormals(const io::TexelRect& changed);
    void uploadLayers(const io::Terrain& terrain, const io::Assets& assets);
    void makeGrid();
    bool sees(const std::optional<Volume>& volume, const GroundNode& node) const;
    Draw drawsOf(GpuStream& stream, std::span<const GroundNode> nodes) const;

    std::shared_ptr<const io::HeightMap> m_map;
    TerrainTree m_tree;
    gl::Texture m_heights; // m
    gl::Texture m_normals; // x and z of the unit normal
    std::vector<Normals> m_normalMips; // as uploaded: a change makes those above it anew
    std::shared_ptr<const io::CoverMap> m_coverMap;
    gl::Texture m_cover; // as io::packed()
    bool m_holed = false;
    gl::Texture m_layerColours; // height of the cover in alpha
    gl::Texture m_layerNormals;
    gl::Buffer m_gridVertices, m_gridIndices;
    gl::VertexArray m_array;
    std::vector<std::shared_ptr<const io::Image>> m_layerImages; // those uploaded
    glsl::Terrain m_block{};
    std::vector<GroundNode> m_nodes;
    std::uint64_t m_revision = 0;
    std::vector<glm::dvec4> m_touched;
};

} // namespace renderer
