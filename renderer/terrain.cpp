#include "renderer/terrain.h"

#include "io/scene/ground_flow.h"
#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <array>
#include <cmath>
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
constexpr double kClose = 5 * kNear; // m, to ground of up to 75 degrees

struct DrawElements { // as glMultiDrawElementsIndirect() reads them
    std::uint32_t count = 0, instances = 1, first = 0;
    std::int32_t base = 0;
    std::uint32_t baseInstance = 0;
};
struct DrawArrays {
    std::uint32_t count = 0, instances = 1, first = 0, baseInstance = 0;
};

bool holeBit(std::uint32_t texel)
{
    return (texel & io::kHoleBit) != 0;
}

bool holes(const io::CoverMap& cover, const io::TexelRect& rect)
{
    bool found = false;
    cover.eachRun(rect, [&](const std::uint32_t* texels, std::size_t count) { found = found || std::any_of(texels, texels + count, holeBit); });
    return found;
}

} // namespace

Terrain::Terrain(TerrainLimits limits) : m_limits{limits}
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
        m_texels = nullptr;
        m_coverMap = nullptr;
        m_holed = false;
        m_choice.clear();
        return;
    }
    const bool sameShape = m_map && m_map->size == heights->size && m_map->metresPerTexel == heights->metresPerTexel &&
                           m_map->origin == heights->origin;
    const bool another = m_map != heights;
    m_map = heights;
    if (another && (changes.everything || !sameShape)) {
        ++m_revision;
        loadHeights();
    } else {
        for (const io::TexelRect& changed : changes.heights)
            changeHeights(common(changed, m_map->texels()));
    }
    updateCover(scene.cover(), changes);
    if (fields || !m_layers.present()) m_layers.update(scene.terrain(), assets, m_block);
    const bool otherShape = another || !changes.heights.empty();
    const bool all = fields || m_layers.askForFlow() || changes.everything; // flow changes far from where heights do
    if (all) m_repainted = m_map->texels();
    for (const std::vector<io::TexelRect>* rects : {&changes.heights, &changes.cover})
        for (const io::TexelRect& changed : *rects)
            m_repainted = around(m_repainted, common({changed.low - io::Texel{1}, changed.high + io::Texel{1}}, m_map->texels()));
    if (!m_layers.askForFlow()) m_flow = {};
    else if (otherShape || !m_flow) measureFlow();
}

void Terrain::measureFlow()
{
    const io::GroundFlow flow = io::flowOf(*m_map);
    std::vector<std::uint8_t> values;
    for (const float value : flow.values)
        values.push_back(std::uint8_t(std::lround(value * 255)));
    if (m_flow.size() != flow.size) m_flow = gl::Texture{{.label = "ground flow", .size = flow.size, .format = GL_R8}};
    m_flow.upload(values.data(), GL_RED, GL_UNSIGNED_BYTE);
    m_block.flowScale = glm::vec2{m_map->metresPerTexel / flow.cell / glm::dvec2{flow.size}};
}

void Terrain::loadHeights()
{
    const io::HeightMap& map = *m_map;
    m_tree = TerrainTree{map};
    const bool windowed = std::max(map.size.x, map.size.y) > m_limits.whole;
    if (!m_texels || windowed != m_windowed) {
        m_texels = windowed ? windowedTexels(m_limits.window) : wholeTexels();
        m_windowed = windowed;
        m_coverMap = nullptr; // which is loaded anew, if there is one
        m_holed = false;
    }
    m_texels->load(m_map);
    m_block.lastTexel = glm::vec2{map.size - 1};
    m_block.texelSize = 1.0f / glm::vec2{map.size};
    m_block.metres = float(map.metresPerTexel);
}

void Terrain::updateCover(const std::shared_ptr<const io::CoverMap>& cover, const io::Changes& changes)
{
    if (cover == m_coverMap) return;
    const std::shared_ptr<const io::CoverMap> before = std::exchange(m_coverMap, cover);
    if (!cover || changes.everything || !before || before->size() != cover->size()) {
        m_texels->loadCover(cover);
        m_holed = cover && holes(*cover, cover->rect());
        ++m_revision;
        return;
    }
    for (const io::TexelRect& changed : changes.cover) {
        const io::TexelRect rect = common(changed, cover->rect());
        if (rect.empty()) continue;
        m_texels->changeCover(cover, rect);
        m_holed |= holes(*cover, rect);
        const bool otherHoles = !std::ranges::equal(cover->read(rect), before->read(rect), {}, holeBit, holeBit);
        if (otherHoles) touch(rect, m_map->min, m_map->max);
    }
}

void Terrain::changeHeights(const io::TexelRect& changed)
{
    if (changed.empty()) return;
    const glm::vec2 before = m_tree.rangeOf(changed);
    m_tree.update(*m_map, changed);
    const glm::vec2 after = m_tree.rangeOf(changed);
    m_texels->change(m_map, changed);
    touch(changed, std::min(before.x, after.x), std::max(before.y, after.y));
}

glm::vec2 Terrain::heightsWithin(const glm::dvec2& from, const glm::dvec2& to) const
{
    const io::Texel low{glm::floor((from - m_map->origin) / m_map->metresPerTexel)}, high{glm::ceil((to - m_map->origin) / m_map->metresPerTexel)};
    const io::TexelRect rect = common({low, high + io::Texel{1}}, m_map->texels());
    return rect.empty() ? glm::vec2{1, 0} : m_tree.rangeOf(rect);
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

void Terrain::aim(const Eye& eye, const Eye& levelsFor, double errorPixels)
{
    m_choice.clear();
    for (auto& [level, choice] : m_shadowChoices)
        choice.clear();
    if (!present()) return;
    const io::HeightMap& map = *m_map;
    const auto inTerrain = [&map](const Eye& e) { return glm::dvec3{e.position.x - map.origin.x, e.position.y, e.position.z - map.origin.y}; };
    const glm::dvec3 own = inTerrain(eye);
    m_levelsFrom = inTerrain(levelsFor);
    m_texels->follow(glm::dvec2{m_levelsFrom.x, m_levelsFrom.z} / map.metresPerTexel, m_block);
    const double pixel = pixelAngle(levelsFor);
    m_choice.choose(m_tree, {.place = m_levelsFrom,
                             .metresPerTexel = map.metresPerTexel,
                             .errorAngle = kErrorLeeway * errorPixels * pixel,
                             .smallestQuad = kSmallestQuad * errorPixels * pixel,
                             .reach = [this](int level) { return m_texels->reach(level); }});
    const glm::dvec2 place{own.x, own.z}, texel = glm::floor(place / map.metresPerTexel);
    m_block.eyeTexel = texel; // whole, so that what is near the eye is exact wherever it is
    m_block.eyeRest = place - texel * map.metresPerTexel;
    m_block.eyeHeight = float(own.y);
    m_block.levelsFrom = m_levelsFrom;
    m_block.segmentAngle = float(kSmallestSegment * errorPixels * pixel);
}

ProgramDesc Terrain::program(std::string label, GroundStages stages, std::string fragment, std::vector<std::string> defines) const
{
    if (m_windowed) defines.emplace_back("WINDOWS");
    if (stages == GroundStages::Grid) return {std::move(label), {"terrain.vert.glsl", std::move(fragment)}, std::move(defines)};
    return {std::move(label), {"terrain_patch.vert.glsl", "terrain.tesc.glsl", "terrain.tese.glsl", std::move(fragment)}, std::move(defines)};
}

std::vector<std::string> Terrain::coverDefines() const
{
    std::vector<std::string> defines{"LAYERS " + std::to_string(m_block.layers)};
    if (m_coverMap) defines.emplace_back("PAINTED");
    if (m_holed) defines.emplace_back("HOLES");
    if (m_flow) defines.emplace_back("FLOW");
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

GroundHorizon::Box Terrain::boxOf(const GroundNode& node) const
{
    const glm::ivec2 last = glm::min(node.origin + (TERRAIN_QUADS << node.level), m_map->size - 1);
    return {.from = glm::dvec2{node.origin} * m_map->metresPerTexel, .to = glm::dvec2{last} * m_map->metresPerTexel, .low = node.low, .high = node.high};
}

// From beneath or beside it one looks through its back, and so does who is so close that the near plane cuts it.
bool Terrain::eyeAboveGround() const
{
    const std::optional<double> height = m_map->height(m_levelsFrom.x + m_map->origin.x, m_levelsFrom.z + m_map->origin.y);
    return height && m_levelsFrom.y > *height + kClose;
}

std::vector<ChosenNode> Terrain::chosenBeforeOthers(const Volume& volume) const
{
    GroundHorizon horizon{m_levelsFrom};
    return m_choice.nodes(
        m_tree,
        [&](const GroundNode& node) -> std::optional<GroundHorizon::Seen> {
            if (!sees(volume, node)) return std::nullopt;
            const GroundHorizon::Seen seen = horizon.look(boxOf(node));
            return horizon.hides(seen) ? std::nullopt : std::optional{seen};
        },
        [&](const std::optional<GroundHorizon::Seen>& seen) { horizon.add(*seen); });
}

// What rests at the finest level is drawn as grids by both stages: those triangles are the map's, to either side of their diagonals,
// and a tessellator chooses its own. Their edges meet, as both cut them at the same texels.
Terrain::Draws Terrain::draws(GpuStream& stream, const std::optional<Volume>& volume, GroundStages stages) const
{
    if (!present()) return {};
    std::vector<ChosenNode> chosen = volume && !m_holed && eyeAboveGround() ? chosenBeforeOthers(*volume) : m_choice.nodes(m_tree, [&](const GroundNode& node) { return sees(volume, node); });
    if (stages == GroundStages::Grid) return {drawOf(stream, chosen, stages)};
    const auto moving = std::ranges::partition(chosen, [](const ChosenNode& one) {
        const bool edgesRest = glm::all(glm::lessThanEqual(one.edges, glm::vec4{0}) || glm::equal(one.edges, glm::vec4{1}));
        return one.node.level == 0 && one.morph == 0 && edgesRest;
    });
    return {drawOf(stream, {chosen.begin(), moving.begin()}, GroundStages::Grid), drawOf(stream, moving, stages)};
}

Terrain::Draw Terrain::shadowDraw(GpuStream& stream, const std::optional<Volume>& volume, double error)
{
    if (!present()) return {};
    const int level = m_tree.coarsestWithin(error);
    const auto seen = [&](const GroundNode& node) { return sees(volume, node); };
    if (m_windowed) { // as fine as it is there, and tight between levels
        TerrainChoice& choice = m_shadowChoices[level];
        if (choice.empty())
            choice.choose(m_tree, {.place = m_levelsFrom,
                                   .metresPerTexel = m_map->metresPerTexel,
                                   .onlyLevel = level,
                                   .reach = [this](int one) { return m_texels->reach(one); }});
        return drawOf(stream, choice.nodes(m_tree, seen), GroundStages::Grid);
    }
    std::vector<ChosenNode> chosen;
    for (const GroundNode& node : m_tree.selectLevel(level, seen))
        chosen.push_back({.node = node});
    return drawOf(stream, chosen, GroundStages::Grid);
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
    m_texels->bind(gpu);
    m_layers.bind(gpu);
    if (m_flow) gpu.bind({{FLOW_UNIT, &m_flow}});
}

void Terrain::bindForShadows(GpuFrame& gpu) const
{
    gpu.constants(TERRAIN_BINDING, m_block);
    m_texels->bindForShadows(gpu);
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
