#include "renderer/terrain.h"

#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace renderer {
namespace {

constexpr int kSide = TERRAIN_QUADS + 1; // vertices
constexpr std::uint32_t kGridIndices = TERRAIN_QUADS * TERRAIN_QUADS * 6;
// A node's error is that of its worst place, by whose nearest point it is judged: 99.9 % of what is seen strays less than 0.44 of
// that, the rest less than 0.8 (tests/gl/test_cracks.cpp).
constexpr double kErrorLeeway = 2;
constexpr double kSmallestQuad = 2.5;     // times the error allowed: half of it is hardly coarser than what pixels show
constexpr double kSmallestSegment = 1.25; // the same
// Mesa's software tessellation takes a time that grows with the square of what one draw makes.
constexpr std::uint32_t kPatchesAtOnce = 64;
constexpr std::size_t kFewPlaces = 64;

struct DrawElements { // as glMultiDrawElementsIndirect() reads them
    std::uint32_t count = 0, instances = 1, first = 0;
    std::int32_t base = 0;
    std::uint32_t baseInstance = 0;
};
struct DrawArrays {
    std::uint32_t count = 0, instances = 1, first = 0, baseInstance = 0;
};

std::int16_t nearest(float v) // std::lround() takes longer than all the rest of a normal
{
    return std::int16_t(int(v + 32768.5f) - 32768);
}

// Of the texels of `rect`, row by row.
Normals normalsOf(const io::HeightMap& map, const io::TexelRect& rect)
{
    const glm::ivec2 low{rect.low}, high{rect.high};
    const io::TexelRect around{glm::max(rect.low - io::Texel{1}, io::Texel{0}), glm::min(rect.high + io::Texel{1}, io::Texel{map.size})};
    const io::HeightGrid heights = map.read(around);
    const glm::ivec2 first{around.low}, last = heights.size - 1;
    Normals normals;
    normals.reserve(std::size_t(high.x - low.x) * (high.y - low.y));
    const auto step = float(map.metresPerTexel);
    for (int z = low.y - first.y; z < high.y - first.y; ++z)
        for (int x = low.x - first.x; x < high.x - first.x; ++x) {
            const int x0 = std::max(x - 1, 0), x1 = std::min(x + 1, last.x);
            const int z0 = std::max(z - 1, 0), z1 = std::min(z + 1, last.y);
            const float dx = (heights.at(x0, z) - heights.at(x1, z)) / (step * float(x1 - x0));
            const float dz = (heights.at(x, z0) - heights.at(x, z1)) / (step * float(z1 - z0));
            const float scale = 32767 / std::sqrt(dx * dx + dz * dz + 1);
            normals.emplace_back(nearest(dx * scale), nearest(dz * scale));
        }
    return normals;
}

// The mean of four texels of a mip that is `size` large. Of an odd side the last row or column is left out, as of any mip.
glm::i16vec2 halved(const Normals& from, glm::ivec2 size, int x, int z)
{
    const std::size_t right = size.x > 1, below = size.y > 1 ? std::size_t(size.x) : 0;
    const glm::i16vec2* texel = &from[std::size_t(2 * z) * size.x + 2 * x];
    return glm::i16vec2{(glm::ivec2{texel[0]} + glm::ivec2{texel[right]} + glm::ivec2{texel[below]} + glm::ivec2{texel[right + below]}) / 4};
}

bool holeBit(std::uint32_t texel)
{
    return (texel & io::kHoleBit) != 0;
}

bool holes(const std::vector<std::uint32_t>& cover)
{
    return std::ranges::any_of(cover, holeBit);
}

} // namespace

ProgramDesc groundProgram(std::string label, GroundStages stages, std::string fragment, std::vector<std::string> defines)
{
    if (stages == GroundStages::Grid) return {std::move(label), {"terrain.vert.glsl", std::move(fragment)}, std::move(defines)};
    return {std::move(label), {"terrain_patch.vert.glsl", "terrain.tesc.glsl", "terrain.tese.glsl", std::move(fragment)}, std::move(defines)};
}

Terrain::Terrain()
{
    makeGrid();
}

void Terrain::makeGrid()
{
    std::vector<glm::u8vec2> vertices;
    for (int z = 0; z < kSide; ++z)
        for (int x = 0; x < kSide; ++x)
            vertices.emplace_back(x, z);
    std::vector<std::uint16_t> indices;
    for (int z = 0; z < TERRAIN_QUADS; ++z)
        for (int x = 0; x < TERRAIN_QUADS; ++x) {
            const int a = z * kSide + x, b = a + 1, c = a + kSide, d = c + 1;
            for (const int i : {a, c, b, b, c, d}) // the diagonal from (x+1, z) to (x, z+1)
                indices.push_back(std::uint16_t(i));
        }
    m_gridVertices = gl::Buffer{"ground grid", vertices.size() * sizeof(vertices[0])};
    m_gridVertices.write(0, std::as_bytes(std::span{vertices}));
    m_gridIndices = gl::Buffer{"ground grid indices", indices.size() * sizeof(indices[0])};
    m_gridIndices.write(0, std::as_bytes(std::span{indices}));

    m_grids = gl::VertexArray{"ground grids"};
    m_grids.attribute(0, 0, 2, GL_UNSIGNED_BYTE, 0);
    m_grids.perInstance(1);
    m_grids.source(0, m_gridVertices.id(), 0, sizeof(glm::u8vec2));
    m_grids.indices(m_gridIndices.id());
    m_patches = gl::VertexArray{"ground patches"};
    for (gl::VertexArray* array : {&m_grids, &m_patches}) {
        array->attribute(1, 1, 4, GL_FLOAT, 0);
        array->attribute(2, 1, 4, GL_FLOAT, offsetof(glsl::TerrainPatch, edges));
    }
}

void Terrain::update(const io::Scene& scene, const io::Assets& assets, const io::Changes& changes)
{
    const bool fields = changes.terrain || changes.everything;
    if (!fields && changes.heights.empty() && changes.cover.empty()) return;
    const auto& heights = scene.heights();
    const bool usable = heights && heights->size.x >= 2 && heights->size.y >= 2;
    if (!usable) {
        ++m_revision;
        m_map = nullptr;
        m_heights = {};
        m_normals = {};
        m_choice.clear();
        updateCover(nullptr, changes);
        return;
    }
    updateCover(scene.cover(), changes);
    const bool sameShape = m_map && m_map->size == heights->size && m_map->metresPerTexel == heights->metresPerTexel &&
                           m_map->origin == heights->origin;
    const bool another = m_map != heights;
    m_map = heights;
    if (another && (changes.everything || !sameShape)) {
        ++m_revision;
        uploadHeights();
    } else {
        for (const io::TexelRect& changed : changes.heights)
            changeHeights(common(changed, m_map->texels()));
    }
    if (fields || !m_layers.present()) m_layers.update(scene.terrain(), assets, m_block);
}

void Terrain::uploadHeights()
{
    const io::HeightMap& map = *m_map;
    m_tree = TerrainTree{map};
    m_heights = gl::Texture{{.label = "ground heights", .size = map.size, .format = GL_R32F, .filter = GL_NEAREST}};
    m_heights.upload(map.read(map.texels()).metres.data(), GL_RED, GL_FLOAT);
    m_normals = gl::Texture{{.label = "ground normals",
                             .size = map.size,
                             .format = GL_RG16_SNORM,
                             .mips = gl::fullMipCount(map.size)}};
    m_normalMips.clear();
    for (int mip = 0; mip < m_normals.mips(); ++mip)
        m_normalMips.emplace_back(std::size_t(m_normals.size(mip).x) * m_normals.size(mip).y);
    uploadNormals(map.texels());
    m_block.lastTexel = glm::vec2{map.size - 1};
    m_block.texelSize = 1.0f / glm::vec2{map.size};
    m_block.metres = float(map.metresPerTexel);
}

void Terrain::updateCover(const std::shared_ptr<const io::CoverMap>& cover, const io::Changes& changes)
{
    if (cover == m_coverMap) return;
    const std::shared_ptr<const io::CoverMap> before = std::exchange(m_coverMap, cover);
    if (!cover) {
        if (m_holed) ++m_revision;
        m_cover = {};
        m_holed = false;
    } else if (changes.everything || !before || before->size() != cover->size()) {
        m_cover = gl::Texture{{.label = "ground cover", .size = cover->size(), .filter = GL_NEAREST}};
        const std::vector<std::uint32_t> texels = cover->read(cover->rect());
        m_cover.upload(texels.data(), GL_RGBA, GL_UNSIGNED_BYTE);
        m_holed = holes(texels);
        ++m_revision;
    } else {
        for (const io::TexelRect& changed : changes.cover) {
            const io::TexelRect rect = common(changed, cover->rect());
            const std::vector<std::uint32_t> now = cover->read(rect), old = before->read(rect);
            m_cover.uploadPart(rect.low, rect.high - rect.low, now.data(), GL_RGBA, GL_UNSIGNED_BYTE);
            m_holed |= holes(now);
            const bool otherHoles = !std::ranges::equal(now, old, {}, holeBit, holeBit);
            if (otherHoles && m_map) touch(rect, m_map->min, m_map->max);
        }
    }
}

void Terrain::changeHeights(const io::TexelRect& changed)
{
    if (changed.empty()) return;
    const io::HeightMap& map = *m_map;
    const glm::vec2 before = m_tree.rangeOf(changed);
    m_tree.update(map, changed);
    const glm::vec2 after = m_tree.rangeOf(changed);
    const io::HeightGrid part = map.read(changed);
    m_heights.uploadPart(glm::ivec2{changed.low}, part.size, part.metres.data(), GL_RED, GL_FLOAT);
    uploadNormals(changed);

    touch(changed, std::min(before.x, after.x), std::max(before.y, after.y));
}

void Terrain::touch(const io::TexelRect& rect, float low, float high)
{
    const glm::dvec2 first = m_map->origin + glm::dvec2{rect.low} * m_map->metresPerTexel;
    const glm::dvec2 last = m_map->origin + glm::dvec2{rect.high} * m_map->metresPerTexel;
    const glm::dvec3 from{first.x, low, first.y}, to{last.x, high, last.y};
    if (m_touched.size() == kFewPlaces) { // nobody looks at them, or they are everywhere
        ++m_revision;
        m_touched.clear();
    }
    m_touched.emplace_back((from + to) * 0.5, glm::distance(from, to) * 0.5 + m_map->metresPerTexel);
}

// A normal looks at its neighbours, so those around what changed change too.
void Terrain::uploadNormals(const io::TexelRect& changed)
{
    glm::ivec2 low = glm::max(glm::ivec2{changed.low} - 1, glm::ivec2{0}), high = glm::min(glm::ivec2{changed.high} + 1, m_map->size);
    const Normals normals = normalsOf(*m_map, {low, high});
    for (int mip = 0; mip < m_normals.mips(); ++mip) {
        Normals& own = m_normalMips[std::size_t(mip)];
        const glm::ivec2 size = m_normals.size(mip);
        Normals part;
        for (int z = low.y; z < high.y; ++z)
            for (int x = low.x; x < high.x; ++x) {
                const glm::i16vec2 normal = mip == 0 ? normals[part.size()] : halved(m_normalMips[std::size_t(mip) - 1], m_normals.size(mip - 1), x, z);
                own[std::size_t(z) * size.x + x] = normal;
                part.push_back(normal);
            }
        m_normals.uploadPart(low, high - low, part.data(), GL_RG, GL_SHORT, mip);
        const glm::ivec2 above = m_normals.size(mip + 1);
        low = glm::min(low / 2, above - 1);
        high = glm::min((high + 1) / 2, above);
    }
}

void Terrain::aim(const Eye& eye, const Eye& levelsFor, double errorPixels)
{
    m_choice.clear();
    if (!present()) return;
    const io::HeightMap& map = *m_map;
    const auto inTerrain = [&map](const Eye& e) { return glm::dvec3{e.position.x - map.origin.x, e.position.y, e.position.z - map.origin.y}; };
    const glm::dvec3 own = inTerrain(eye), levelsFrom = inTerrain(levelsFor);
    const double pixel = pixelAngle(levelsFor);
    m_choice.choose(m_tree, {.place = levelsFrom,
                             .metresPerTexel = map.metresPerTexel,
                             .errorAngle = kErrorLeeway * errorPixels * pixel,
                             .smallestQuad = kSmallestQuad * errorPixels * pixel});
    m_block.eyeInTerrain = {own.x, own.z};
    m_block.eyeHeight = float(own.y);
    m_block.levelsFrom = levelsFrom;
    m_block.segmentAngle = float(kSmallestSegment * errorPixels * pixel);
}

std::vector<std::string> Terrain::coverDefines() const
{
    std::vector<std::string> defines{"LAYERS " + std::to_string(m_block.layers)};
    if (m_cover) defines.emplace_back("PAINTED");
    if (m_holed) defines.emplace_back("HOLES");
    return defines;
}

bool Terrain::sees(const std::optional<Volume>& volume, const GroundNode& node) const
{
    if (!volume) return true;
    const int side = TERRAIN_QUADS << node.level;
    const glm::ivec2 last = glm::min(node.origin + side, m_map->size - 1);
    const glm::dvec2 low = m_map->origin + glm::dvec2{node.origin} * m_map->metresPerTexel;
    const glm::dvec2 high = m_map->origin + glm::dvec2{last} * m_map->metresPerTexel;
    const glm::dvec3 centre = glm::dvec3{low.x + high.x, double(node.low) + node.high, low.y + high.y} * 0.5;
    const glm::dvec3 half = glm::dvec3{high.x, node.high, high.y} - centre;
    return std::ranges::all_of(volume->planes, [&](const glm::dvec4& p) {
        return glm::dot(glm::dvec3{p}, centre) + p.w + glm::dot(glm::abs(glm::dvec3{p}), half) >= 0;
    });
}

// What rests at the finest level is drawn as grids by both stages: those triangles are the map's, to either side of their diagonals,
// and a tessellator chooses its own. Their edges meet, as both cut them at the same texels.
Terrain::Draws Terrain::draws(GpuStream& stream, const std::optional<Volume>& volume, GroundStages stages) const
{
    if (!present()) return {};
    std::vector<ChosenNode> chosen = m_choice.nodes(m_tree, [&](const GroundNode& node) { return sees(volume, node); });
    if (stages == GroundStages::Grid) return {drawOf(stream, chosen, stages)};
    const auto moving = std::ranges::partition(chosen, [](const ChosenNode& one) {
        const bool edgesRest = glm::all(glm::lessThanEqual(one.edges, glm::vec4{0}) || glm::equal(one.edges, glm::vec4{1}));
        return one.node.level == 0 && one.morph == 0 && edgesRest;
    });
    return {drawOf(stream, {chosen.begin(), moving.begin()}, GroundStages::Grid), drawOf(stream, moving, stages)};
}

Terrain::Draws Terrain::shadowDraws(GpuStream& stream, const std::optional<Volume>& volume, double error, GroundStages stages) const
{
    if (!present()) return {};
    const int level = m_tree.coarsestWithin(error);
    std::vector<ChosenNode> chosen;
    for (const GroundNode& node : m_tree.selectLevel(level, [&](const GroundNode& one) { return sees(volume, one); }))
        chosen.push_back({.node = node});
    return {drawOf(stream, chosen, level == 0 ? GroundStages::Grid : stages)};
}

Terrain::Draw Terrain::drawOf(GpuStream& stream, std::span<const ChosenNode> chosen, GroundStages stages) const
{
    Draw draw{.stages = stages};
    if (chosen.empty()) return draw;
    std::vector<glsl::TerrainPatch> patches;
    for (const ChosenNode& one : chosen)
        patches.push_back({glm::vec2{one.node.origin}, float(1 << one.node.level), one.morph, one.edges});
    const auto count = std::uint32_t(patches.size());
    draw.triangles = count * (kGridIndices / 3);
    draw.patches = stream.put(std::span<const glsl::TerrainPatch>{patches});
    if (stages == GroundStages::Grid) {
        const DrawElements command{.count = kGridIndices, .instances = count};
        draw.commands = stream.put(std::span{&command, 1});
        draw.commandCount = 1;
        return draw;
    }
    std::vector<DrawArrays> commands;
    for (std::uint32_t first = 0; first < count; first += kPatchesAtOnce)
        commands.push_back({.count = std::min(kPatchesAtOnce, count - first), .first = first});
    draw.commands = stream.put(std::span<const DrawArrays>{commands});
    draw.commandCount = std::uint32_t(commands.size());
    return draw;
}

void Terrain::bind(GpuFrame& gpu) const
{
    gpu.constants(TERRAIN_BINDING, m_block);
    gpu.bind({{HEIGHTS_UNIT, &m_heights}, {GROUND_NORMALS_UNIT, &m_normals}});
    if (m_cover) gpu.bind({{COVER_UNIT, &m_cover}});
    m_layers.bind(gpu);
}

void Terrain::bindForShadows(GpuFrame& gpu) const
{
    glsl::Terrain still = m_block; // of no eye, so whole
    still.segmentAngle = 1e-9f;
    gpu.constants(TERRAIN_BINDING, still);
    gpu.bind({{HEIGHTS_UNIT, &m_heights}});
    if (m_cover) gpu.bind({{COVER_UNIT, &m_cover}});
}

void Terrain::draw(GpuFrame& gpu, const Draw& draw)
{
    if (draw.commandCount == 0) return;
    const bool grid = draw.stages == GroundStages::Grid;
    gl::VertexArray& array = grid ? m_grids : m_patches;
    array.source(1, draw.patches.buffer, draw.patches.offset, sizeof(glsl::TerrainPatch));
    glBindVertexArray(array.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, draw.commands.buffer);
    const auto* offset = reinterpret_cast<const void*>(draw.commands.offset);
    if (grid) {
        glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, offset, GLsizei(draw.commandCount), 0);
    } else {
        glPatchParameteri(GL_PATCH_VERTICES, 1);
        glMultiDrawArraysIndirect(GL_PATCHES, offset, GLsizei(draw.commandCount), 0);
    }
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
    gpu.count(draw.commandCount, draw.triangles);
}

io::WorldBox Terrain::bounds() const
{
    io::WorldBox box;
    if (!m_map) return box;
    const glm::dvec2 high = m_map->origin + glm::dvec2{m_map->size - 1} * m_map->metresPerTexel;
    box.add(glm::dvec3{m_map->origin.x, m_map->min, m_map->origin.y});
    box.add(glm::dvec3{high.x, m_map->max, high.y});
    return box;
}

} // namespace renderer
