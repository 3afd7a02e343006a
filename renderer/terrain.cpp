#include "renderer/terrain.h"

#include "renderer/pixels.h"
#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace renderer {
namespace {

constexpr int kSide = TERRAIN_QUADS + 1;             // vertices
constexpr int kQuarter = TERRAIN_QUADS / 2;          // quads
constexpr std::uint32_t kQuarterIndices = kQuarter * kQuarter * 6;
constexpr double kErrorPixels = 1.5;
constexpr int kLargestLayer = 1024; // texels
constexpr std::size_t kFewPlaces = 64;
static_assert(TERRAIN_LAYERS == io::kMostLayers);

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

// Brightness stands for the height of a cover's texels: stones over the earth between them.
void heightIntoAlpha(Pixels& pixels)
{
    for (glm::u8vec4& p : pixels)
        p.w = std::uint8_t((p.x * 54 + p.y * 183 + p.z * 19) >> 8);
}

bool holeBit(std::uint32_t texel)
{
    return (texel & io::kHoleBit) != 0;
}

bool holes(const std::vector<std::uint32_t>& cover)
{
    return std::ranges::any_of(cover, holeBit);
}

using Images = std::vector<std::shared_ptr<const io::Image>>;

int sideFor(const Images& images)
{
    int side = 1;
    for (const auto& image : images)
        if (image) side = std::max(side, textureSide(image->size, kLargestLayer));
    return side;
}

gl::Texture layerArray(std::string_view label, const Images& images, ColourSpace space)
{
    const int side = sideFor(images);
    gl::Texture array{{.label = label,
                       .size = glm::ivec2{side},
                       .layers = std::max(int(images.size()), 1),
                       .mips = gl::fullMipCount(glm::ivec2{side}),
                       .wrap = GL_REPEAT,
                       .anisotropic = true,
                       .lodBias = -0.6f}}; // the ground mostly runs away from the eye
    std::vector<MipRequest> requests;
    std::vector<int> layers; // of the requests
    for (std::size_t layer = 0; layer < images.size(); ++layer) {
        if (!images[layer]) continue;
        requests.push_back({images[layer].get(), side, space});
        layers.push_back(int(layer));
    }
    mipChains(requests, [&](std::size_t number, std::vector<Pixels>& mips) {
        for (std::size_t mip = 0; mip < mips.size(); ++mip) {
            if (space == ColourSpace::Srgb) heightIntoAlpha(mips[mip]);
            array.upload(mips[mip].data(), GL_RGBA, GL_UNSIGNED_BYTE, int(mip), layers[number]);
        }
    });
    return array;
}

// Rise at the low end and fall at the high one, each over twice the half width; ends of the scale have no border.
glm::vec4 rampsOf(const glm::vec2& range, float half, const glm::vec2& scale)
{
    const float factor = 0.5f / half;
    glm::vec4 ramps{0, 1, 0, 1};
    if (range.x > scale.x) ramps.x = factor, ramps.y = 0.5f - range.x * factor;
    if (range.y < scale.y) ramps.z = -factor, ramps.w = 0.5f + range.y * factor;
    return ramps;
}

glsl::TerrainLayer layerBlock(const io::TerrainLayer& layer, bool colour, bool normal, int index)
{
    const float blend = std::max(layer.blend, 1e-3f);
    glsl::TerrainLayer block{};
    block.colour = layer.colour;
    block.repeats = 1 / std::max(layer.metres, 1e-3f);
    block.slopeRamps = rampsOf(layer.slope, blend * 7.5f, {0, 90});
    block.altitudeRamps = rampsOf(layer.altitude, blend * 20, {-1e5f, 1e5f});
    block.ragged = {blend * 12, blend * 40};
    block.roughness = layer.roughness;
    block.colourLayer = colour ? float(index) : -1.0f;
    block.normalLayer = normal ? float(index) : -1.0f;
    return block;
}

std::uint32_t quarterOffset(int quarter)
{
    return std::uint32_t(quarter) * kQuarterIndices;
}

} // namespace

Terrain::Terrain()
{
    makeGrid();
}

// Vertices of one grid; indices by quarter, so that a quarter or the whole is one run.
void Terrain::makeGrid()
{
    std::vector<glm::u8vec2> vertices;
    for (int z = 0; z < kSide; ++z)
        for (int x = 0; x < kSide; ++x)
            vertices.emplace_back(x, z);
    std::vector<std::uint16_t> indices;
    for (int quarter = 0; quarter < 4; ++quarter)
        for (int z = 0; z < kQuarter; ++z)
            for (int x = 0; x < kQuarter; ++x) {
                const int column = x + (quarter & 1) * kQuarter;
                const int row = z + (quarter >> 1) * kQuarter;
                const int a = row * kSide + column, b = a + 1, c = a + kSide, d = c + 1;
                for (const int i : {a, c, b, b, c, d}) // the diagonal from (x+1, z) to (x, z+1)
                    indices.push_back(std::uint16_t(i));
            }
    m_gridVertices = gl::Buffer{"ground grid", vertices.size() * sizeof(vertices[0])};
    m_gridVertices.write(0, std::as_bytes(std::span{vertices}));
    m_gridIndices = gl::Buffer{"ground grid indices", indices.size() * sizeof(indices[0])};
    m_gridIndices.write(0, std::as_bytes(std::span{indices}));

    m_array = gl::VertexArray{"ground"};
    m_array.attribute(0, 0, 2, GL_UNSIGNED_BYTE, 0);
    m_array.attribute(1, 1, 4, GL_FLOAT, 0);
    m_array.perInstance(1);
    m_array.source(0, m_gridVertices.id(), 0, sizeof(glm::u8vec2));
    m_array.indices(m_gridIndices.id());
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
        m_nodes.clear();
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
    if (fields || !m_layerColours) uploadLayers(scene.terrain(), assets);
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

void Terrain::uploadLayers(const io::Terrain& terrain, const io::Assets& assets)
{
    const std::size_t count = std::min<std::size_t>(terrain.layers.size(), TERRAIN_LAYERS);
    Images colours(count), normals(count);
    for (std::size_t i = 0; i < count && i < assets.layers.size(); ++i) {
        colours[i] = assets.layers[i].colour;
        normals[i] = assets.layers[i].normal;
    }
    m_block.layers = int(count);
    for (std::size_t i = 0; i < count; ++i)
        m_block.layer[i] = layerBlock(terrain.layers[i], colours[i] != nullptr, normals[i] != nullptr, int(i));
    if (count == 0) { // bare earth
        m_block.layers = 1;
        m_block.layer[0] = layerBlock({.colour = {0.16f, 0.17f, 0.11f}}, false, false, 0);
    }
    Images images = colours;
    images.insert(images.end(), normals.begin(), normals.end());
    if (images == m_layerImages && m_layerColours) return; // a rule or a colour changed, no picture
    m_layerColours = layerArray("ground colours", colours, ColourSpace::Srgb);
    m_layerNormals = layerArray("ground bumps", normals, ColourSpace::Linear);
    m_layerImages = std::move(images);
}

void Terrain::aim(const Eye& eye, const Eye& levelsFor, double leniency)
{
    m_nodes.clear();
    if (!present()) return;
    const io::HeightMap& map = *m_map;
    const auto inTerrain = [&map](const Eye& e) { return glm::dvec2{e.position.x, e.position.z} - map.origin; };
    const glm::dvec2 levelsFrom = inTerrain(levelsFor);
    const glm::dvec2 reach = glm::dvec2{map.size - 1} * map.metresPerTexel;
    const glm::dvec2 nearest = map.origin + glm::clamp(levelsFrom, glm::dvec2{0}, reach);
    const double ground = map.height(nearest.x, nearest.y).value_or(map.min);

    const TerrainTree::Eye treeEye{
        .texel = levelsFrom / map.metresPerTexel,
        .eyeAbove = std::max(levelsFor.position.y - ground, 0.0) / map.metresPerTexel,
        .firstRange = m_tree.firstRange(kErrorPixels * leniency, pixelAngle(levelsFor), map.metresPerTexel)};
    m_nodes = m_tree.select(treeEye);

    m_block.eyeInTerrain = glm::vec2{inTerrain(eye)};
    m_block.levelsFrom = glm::vec2{levelsFrom};
    m_block.eyeHeight = float(eye.position.y);
    m_block.eyeAbove = float(treeEye.eyeAbove * map.metresPerTexel);
    for (int level = 0; level < TERRAIN_LEVELS; ++level) {
        // Whole before the range ends, begun only after the finer neighbours' last corner.
        const double range = treeEye.firstRange * std::exp2(level) * map.metresPerTexel;
        const bool coarsest = level + 1 >= m_tree.levels();
        const double begin = range * 0.8, end = range * 0.985;
        m_block.morph[level] = coarsest ? glm::vec4{1e30f, 0, 0, 0} : glm::vec4{float(begin), float(1 / (end - begin)), 0, 0};
    }
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

Terrain::Draw Terrain::draws(GpuStream& stream, const std::optional<Volume>& volume) const
{
    std::vector<GroundNode> nodes;
    std::ranges::copy_if(m_nodes, std::back_inserter(nodes), [&](const GroundNode& node) { return sees(volume, node); });
    return drawsOf(stream, nodes);
}

Terrain::Draw Terrain::shadowDraws(GpuStream& stream, const std::optional<Volume>& volume, double error) const
{
    if (!present()) return {};
    return drawsOf(stream, m_tree.selectLevel(m_tree.coarsestWithin(error), [&](const GroundNode& node) { return sees(volume, node); }));
}

Terrain::Draw Terrain::drawsOf(GpuStream& stream, std::span<const GroundNode> nodes) const
{
    Draw draw;
    std::vector<glsl::TerrainPatch> patches;
    std::vector<std::array<std::uint32_t, 5>> commands;
    for (int kind = -1; kind < 4; ++kind) { // wholes, then the quarters
        const auto first = std::uint32_t(patches.size());
        for (const GroundNode& node : nodes)
            if (node.quarter == kind) patches.push_back({glm::vec2{node.origin}, float(1 << node.level), float(node.level)});
        const auto instances = std::uint32_t(patches.size()) - first;
        if (instances == 0) continue;
        const std::uint32_t indices = kind < 0 ? 4 * kQuarterIndices : kQuarterIndices;
        commands.push_back({indices, instances, quarterOffset(std::max(kind, 0)), 0, first});
        draw.triangles += std::uint64_t(instances) * (indices / 3);
    }
    if (patches.empty()) return draw;
    draw.patches = stream.put(std::span<const glsl::TerrainPatch>{patches});
    draw.commands = stream.put(std::span<const std::array<std::uint32_t, 5>>{commands});
    draw.commandCount = std::uint32_t(commands.size());
    return draw;
}

void Terrain::bind(GpuFrame& gpu) const
{
    gpu.constants(TERRAIN_BINDING, m_block);
    gpu.bind({{HEIGHTS_UNIT, &m_heights},
              {GROUND_NORMALS_UNIT, &m_normals},
              {LAYER_COLOURS_UNIT, &m_layerColours},
              {LAYER_NORMALS_UNIT, &m_layerNormals}});
    if (m_cover) gpu.bind({{COVER_UNIT, &m_cover}});
}

void Terrain::bindForShadows(GpuFrame& gpu) const
{
    glsl::Terrain still = m_block;
    for (glm::vec4& morph : still.morph)
        morph = {1e30f, 0, 0, 0};
    gpu.constants(TERRAIN_BINDING, still);
    gpu.bind({{HEIGHTS_UNIT, &m_heights}});
    if (m_cover) gpu.bind({{COVER_UNIT, &m_cover}});
}

void Terrain::draw(GpuFrame& gpu, const Draw& draw)
{
    if (draw.commandCount == 0) return;
    m_array.source(1, draw.patches.buffer, draw.patches.offset, sizeof(glsl::TerrainPatch));
    glBindVertexArray(m_array.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, draw.commands.buffer);
    const auto* offset = reinterpret_cast<const void*>(draw.commands.offset);
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, offset, GLsizei(draw.commandCount), 0);
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
