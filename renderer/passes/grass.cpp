#include "renderer/passes/grass.h"

#include "io/base/log.h"
#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>

namespace renderer {
namespace {

constexpr float kManyVertices = 60;     // pixels of height from which a blade has 15 of them
constexpr float kAnywhere = 1e9f; // m
constexpr std::size_t kPlacesOfTile = GRASS_TILE * GRASS_TILE;
constexpr std::uint32_t kPlantRoom = 1 << 16; // plants of a kind that grows as a model
constexpr std::uint32_t kMostPlantTriangles = 200; // of such a model, if it has a level with so few

void storage(GLuint binding, GLuint buffer)
{
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer);
}

// Of a bundle of each shape, as 16 bits.
gl::Buffer stripIndices()
{
    std::vector<std::uint16_t> indices;
    for (int shape = 0; shape < GRASS_SHAPES; ++shape) {
        const int triangles = glsl::grassSegments(shape) * 2 - 1;
        for (int blade = 0; blade < GRASS_BUNDLE; ++blade)
            for (int i = 0; i < triangles; ++i)
                for (int corner = 0; corner < 3; ++corner)
                    indices.push_back(std::uint16_t(blade * (triangles + 2) + i + corner));
    }
    gl::Buffer buffer{"grass indices", indices.size() * sizeof(indices[0])};
    buffer.write(0, std::as_bytes(std::span{indices}));
    return buffer;
}

} // namespace

GrassPass::GrassPass(ShaderLibrary& shaders) : m_shaders{shaders}, m_readback{"grass counts, read"}
{
}

void GrassPass::makeRoom(std::uint32_t most, std::size_t plants, std::size_t tiles)
{
    const std::size_t foundBytes = std::max<std::size_t>(tiles, 1) * kPlacesOfTile * sizeof(glsl::GrassFound);
    if (m_found.bytes() < foundBytes) m_found = gl::Buffer{"grass found", foundBytes + foundBytes / 4};
    if (!m_strips.id()) {
        m_indices = stripIndices();
        m_strips = gl::VertexArray{"grass"};
        m_strips.indices(m_indices.id());
        m_points = gl::VertexArray{"grass seeds"};
        m_points.attribute(0, 0, 3, GL_FLOAT, 0);
        m_points.integers(1, 0, 1, GL_UNSIGNED_INT, offsetof(glsl::GrassBlade, size));
        m_points.integers(2, 0, 4, GL_UNSIGNED_INT, offsetof(glsl::GrassBlade, bend));
        m_counts = gl::Buffer{"grass counts", sizeof(glsl::GrassCounts)};
        m_commands = gl::Buffer{"grass commands", GRASS_SHAPES * sizeof(DrawCommand)};
    }
    const std::size_t plantBytes = plants * kPlantRoom * sizeof(glsl::Instance);
    if (m_plants.bytes() < plantBytes) m_plants = gl::Buffer{"grass plants", plantBytes};
    if (most == m_room && m_blades.id()) return;
    m_room = most;
    m_blades = gl::Buffer{"grass blades", std::max<std::size_t>(m_room, 1) * GRASS_SHAPES * sizeof(glsl::GrassBlade)};
    m_points.source(0, m_blades.id(), 0, sizeof(glsl::GrassBlade));
}

std::vector<GrassPass::Plant> GrassPass::plantsOf(const Scenery& scenery)
{
    std::vector<Plant> plants;
    const std::span<const io::TemplateId> ids = scenery.grass.plants();
    for (std::size_t kind = 0; kind < ids.size(); ++kind)
        if (const ModelRef model = scenery.world.modelOf(ids[kind]); model && model.entry().bounds.max.y > 0) plants.push_back({int(kind), model});
    return plants;
}

glsl::GrassFrame GrassPass::frame(const Scenery& scenery, const Viewpoint& viewpoint, const io::Environment& environment,
                                  std::span<const Presser> pressers, std::span<const Plant> plants, const Settings& settings) const
{
    const Eye& eye = viewpoint.eye;
    glsl::GrassFrame frame = scenery.grass.frame(eye, settings);
    frame.room = m_room;
    frame.foundRoom = std::uint32_t(m_found.bytes() / sizeof(glsl::GrassFound));
    frame.plantRoom = kPlantRoom;
    frame.looksAhead = settings.culling && !viewpoint.frozen;
    frame.shapeAngle = float(kManyVertices * pixelAngle(eye));
    frame.water = environment.water.level;
    for (glsl::GrassKind& kind : frame.kind)
        if (!environment.water.on) kind.aboveWater = {-kAnywhere, kAnywhere}; // then any height will do
    for (std::size_t i = 0; i < plants.size(); ++i) {
        frame.kind[plants[i].kind].plant = std::uint32_t(i) + 1;
        frame.kind[plants[i].kind].perHeight = 1 / plants[i].model.entry().bounds.max.y;
    }
    frame.wind = viewpoint.wind;
    frame.tintScale = m_tint.scale();
    frame.pressers = int(std::min({pressers.size(), kMostPressers, std::size_t(GRASS_PRESSERS)}));
    for (int i = 0; i < frame.pressers; ++i) {
        const Presser& presser = pressers[std::size_t(i)];
        frame.presser[i] = glm::vec4{glm::vec3{presser.position - eye.position}, presser.radius};
        frame.pressed[i / 4][i % 4] = presser.strength;
    }
    return frame;
}

std::vector<std::string> GrassPass::groundDefines(const Scenery& scenery) const
{
    return scenery.terrain.windowed() ? std::vector<std::string>{"WINDOWS"} : std::vector<std::string>{};
}

// Plants of the grid around the eye.
bool GrassPass::place(GpuFrame& gpu, Scenery& scenery, std::span<const glsl::GrassTile> tiles, const gl::Texture* farthest, bool plants)
{
    if (tiles.empty()) return false;
    const GpuStream::Piece piece = gpu.stream().put(tiles);
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, GRASS_TILES_BINDING, piece.buffer, GLintptr(piece.offset), GLsizeiptr(tiles.size() * sizeof(tiles[0])));
    storage(GRASS_FOUND_BINDING, m_found.id());
    std::vector<std::string> defines = groundDefines(scenery);
    if (!gpu.use(m_shaders.program({.label = "grass found", .stages = {"grass_find.comp.glsl"}, .defines = defines}))) return false;
    glDispatchCompute(GLuint(tiles.size()), 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);

    if (scenery.terrain.holed()) defines.emplace_back("HOLES");
    if (farthest) defines.emplace_back("HIDDEN");
    if (plants) defines.emplace_back("PLANTS");
    if (!gpu.use(m_shaders.program({.label = "grass places", .stages = {"grass_place.comp.glsl"}, .defines = std::move(defines)}))) return false;
    if (farthest) gpu.bind({{IMAGE_UNIT, farthest}});
    if (plants) storage(GRASS_PLANTS_BINDING, m_plants.id());
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, m_counts.id());
    glDispatchComputeIndirect(offsetof(glsl::GrassCounts, groups));
    return true;
}

// The ground once more, where it is to be seen.
bool GrassPass::seed(GpuFrame& gpu, GeometryPass& geometry, Scenery& scenery, const Terrain::Draws& ground)
{
    const gl::Texture& depth = geometry.targets().depth;
    if (std::exchange(m_depthOf, depth.id()) != depth.id()) m_depth = gl::Framebuffer{{.label = "depth alone", .depth = &depth}};
    m_depth.bind();
    std::vector<std::string> defines = scenery.terrain.coverDefines();
    std::erase(defines, "HOLES"); // there is no ground to be seen in them
    for (const Terrain::Draw& part : ground) {
        if (!gpu.use(m_shaders.program(scenery.terrain.program("grass seeds", part.stages, "grass_seeds.frag.glsl", defines)))) return false;
        gl::apply({.depthTest = GL_EQUAL, .cull = GL_BACK});
        scenery.terrain.draw(gpu, part);
    }
    return true;
}

// The draws, of as many as were found and have room. Answers those of models.
std::vector<DrawList> GrassPass::command(GpuFrame& gpu, std::span<const Plant> plants, bool seeds)
{
    std::vector<glsl::GrassPart> parts;
    std::vector<DrawList> lists;
    for (std::size_t i = 0; i < plants.size(); ++i) {
        const ModelEntry& entry = plants[i].model.entry();
        const auto triangles = [](const ModelLevel& level) {
            std::uint32_t indices = 0;
            for (const ModelPart& part : level.parts)
                indices += part.indexCount;
            return indices / 3;
        };
        std::size_t level = 0;
        const std::size_t meshes = entry.levels.size() - (entry.impostor ? 1 : 0);
        while (level + 1 < meshes && triangles(entry.levels[level]) > kMostPlantTriangles) ++level;
        DrawList list{.models = plants[i].model.library, .instances = {.buffer = m_plants.id()}};
        for (const ModelPart& part : entry.levels[level].parts) {
            if (list.models->batches()[std::size_t(part.batch)].blend) continue;
            list.opaque.push_back({.batch = part.batch, .swaying = true, .commandOffset = parts.size() * sizeof(DrawCommand), .commands = 1});
            parts.push_back({.firstIndex = part.firstIndex, .indexCount = part.indexCount, .plants = std::uint32_t(i)});
        }
        if (!list.opaque.empty()) lists.push_back(std::move(list));
    }
    std::vector<std::string> defines;
    if (seeds) defines.emplace_back("SEEDS");
    if (!parts.empty()) defines.emplace_back("PLANTS");
    const gl::Program& program = m_shaders.program({.label = "grass commands", .stages = {"grass_commands.comp.glsl"}, .defines = std::move(defines)});
    if (!gpu.use(program)) return {};
    storage(GRASS_COMMANDS_BINDING, m_commands.id());
    if (!parts.empty()) {
        if (m_plantCommands.bytes() < parts.size() * sizeof(DrawCommand)) m_plantCommands = gl::Buffer{"grass plants' commands", parts.size() * sizeof(DrawCommand)};
        for (DrawList& list : lists)
            list.commands = {.buffer = m_plantCommands.id()};
        const GpuStream::Piece piece = gpu.stream().put(std::span<const glsl::GrassPart>{parts});
        glBindBufferRange(GL_SHADER_STORAGE_BUFFER, GRASS_PARTS_BINDING, piece.buffer, GLintptr(piece.offset), GLsizeiptr(parts.size() * sizeof(parts[0])));
        storage(GRASS_PLANT_COMMANDS_BINDING, m_plantCommands.id());
        glProgramUniform1ui(program.id(), 0, GLuint(parts.size()));
    }
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
    return lists;
}

void GrassPass::drawBlades(GpuFrame& gpu, const gl::Framebuffer& target, bool seeds)
{
    target.bind();
    gl::apply({.depthTest = GL_GREATER, .depthWrite = true});
    glBindVertexArray(seeds ? m_points.id() : m_strips.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, m_commands.id());
    if (seeds) {
        if (!gpu.use(m_shaders.program({.label = "grass of seeds", .stages = {"grass_seeds.vert.glsl", "grass_seeds.geom.glsl", "grass.frag.glsl"}, .defines = {"SEGMENTS 3"}}))) return;
        glDrawArraysIndirect(GL_POINTS, nullptr);
        gpu.count(1, 0);
        return;
    }
    for (int shape = 0; shape < GRASS_SHAPES; ++shape) {
        std::vector<std::string> defines{fmt::format("SHAPE {}", shape), fmt::format("SEGMENTS {}", glsl::grassSegments(shape))};
        if (!gpu.use(m_shaders.program({.label = "grass", .stages = {"grass.vert.glsl", "grass.frag.glsl"}, .defines = std::move(defines)}))) return;
        glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, reinterpret_cast<const void*>(std::size_t(shape) * sizeof(DrawCommand)));
        gpu.count(1, 0);
    }
}

void GrassPass::countDrawn(FrameStats& stats, const Settings& settings)
{
    if (const std::optional<glsl::GrassCounts> counts = m_readback.arrived()) {
        stats.grassDrawn = std::min(counts->drawn, std::uint32_t(settings.mostBlades));
        stats.grassLeftOut = counts->taken - stats.grassDrawn;
        if (counts->taken > std::uint32_t(settings.mostBlades) && !std::exchange(m_warned, true))
            io::log::warning("{} blades of grass are in view, {} are drawn; lower render.grass_density or raise render.most_blades", counts->taken, stats.grassDrawn);
    }
    m_readback.ask(m_counts);
}

void GrassPass::render(GpuFrame& gpu, GeometryPass& geometry, const GeometryPass::Drawn& drawn, Scenery& scenery, const Viewpoint& viewpoint,
                       const io::Environment& environment, std::span<const Presser> pressers, const Settings& settings)
{
    gpu.stats().grassDrawn = gpu.stats().grassLeftOut = 0;
    if (!settings.grass || !scenery.grass.present() || !scenery.terrain.present()) return scenery.footprints.forget();
    const auto scope = gpu.scope("grass");
    const bool seeds = settings.grassMethod == GrassFrom::Seeds;
    const std::vector<Plant> plants = seeds ? std::vector<Plant>{} : plantsOf(scenery);
    scenery.terrain.bind(gpu);
    const Eye& held = scenery.terrain.windowed() ? viewpoint.culledFor : viewpoint.eye; // around which the ground is there
    m_tint.update(gpu, m_shaders, scenery.terrain, held.position, double(settings.grassDistance));
    m_kinds.clear();
    for (const Plant& plant : plants)
        m_kinds.push_back(plant.kind);
    const std::optional<Volume> volume = settings.culling ? std::optional{volumeOf(viewpoint.culledFor)} : std::nullopt;
    const std::vector<glsl::GrassTile> tiles = seeds ? std::vector<glsl::GrassTile>{} : scenery.grass.tiles(scenery.terrain, viewpoint.eye, volume, settings);
    makeRoom(std::uint32_t(std::max(settings.mostBlades, 0)), plants.size(), tiles.size());
    gpu.constants(GRASS_BINDING, frame(scenery, viewpoint, environment, pressers, plants, settings));
    constexpr GLuint kNone = 0, kOne = 1;
    glClearNamedBufferData(m_counts.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &kNone);
    glClearNamedBufferSubData(m_counts.id(), GL_R32UI, offsetof(glsl::GrassCounts, groupsY), 8, GL_RED_INTEGER, GL_UNSIGNED_INT, &kOne);
    gpu.bind({{GRASS_MAP_UNIT, &scenery.grass.map()}, {GRASS_MASK_UNIT, &scenery.footprints.texture()}, {GROUND_TINT_UNIT, &m_tint.texture()}});
    storage(GRASS_BLADES_BINDING, m_blades.id());
    storage(GRASS_COUNTS_BINDING, m_counts.id());
    if (seeds ? !seed(gpu, geometry, scenery, drawn.ground) : !place(gpu, scenery, tiles, drawn.farthest, !plants.empty())) return;
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    const std::vector<DrawList> models = command(gpu, plants, seeds);
    drawBlades(gpu, geometry.framebuffer(), seeds);
    for (const DrawList& list : models)
        geometry.drawObjects(gpu, list);
    countDrawn(gpu.stats(), settings);
}

std::vector<glsl::GrassBlade> GrassPass::readBlades() const
{
    glsl::GrassCounts counts{};
    glGetNamedBufferSubData(m_counts.id(), 0, sizeof counts, &counts);
    std::vector<glsl::GrassBlade> blades;
    for (std::uint32_t shape = 0; shape < GRASS_SHAPES; ++shape) {
        const std::uint32_t count = std::min(counts.shape[shape], m_room);
        std::vector<glsl::GrassBlade> some(count);
        if (count > 0)
            glGetNamedBufferSubData(m_blades.id(), GLintptr(shape * m_room * sizeof some[0]), GLsizeiptr(count * sizeof some[0]), some.data());
        blades.insert(blades.end(), some.begin(), some.end());
    }
    return blades;
}

std::vector<glsl::Instance> GrassPass::readPlants(int kind) const
{
    const auto found = std::ranges::find(m_kinds, kind);
    if (found == m_kinds.end()) return {};
    const auto place = std::size_t(found - m_kinds.begin());
    glsl::GrassCounts counts{};
    glGetNamedBufferSubData(m_counts.id(), 0, sizeof counts, &counts);
    std::vector<glsl::Instance> plants(std::min(counts.plants[place], kPlantRoom));
    if (!plants.empty())
        glGetNamedBufferSubData(m_plants.id(), GLintptr(place * kPlantRoom * sizeof plants[0]), GLsizeiptr(plants.size() * sizeof plants[0]), plants.data());
    return plants;
}

} // namespace renderer
