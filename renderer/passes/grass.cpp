#include "renderer/passes/grass.h"

#include "io/base/log.h"
#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <cstddef>

namespace renderer {
namespace {

constexpr int kMostTint = 512;          // texels along a side
constexpr float kManyVertices = 60;     // pixels of height from which a blade has 15 of them
constexpr std::uint32_t kShapes[GRASS_SHAPES] = {7, 3, 1}; // segments of each
constexpr std::size_t kCommandBytes = 16;
constexpr float kAnywhere = 1e9f; // m

void storage(GLuint binding, GLuint buffer)
{
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer);
}

} // namespace

GrassPass::GrassPass(ShaderLibrary& shaders)
    : m_shaders{shaders}, m_commandsProgram{shaders.program({.label = "grass commands", .stages = {"grass_commands.comp.glsl"}})}, m_readback{"grass counts, read"}
{
}

void GrassPass::makeRoom(std::uint32_t most)
{
    if (!m_strips.id()) {
        m_strips = gl::VertexArray{"grass"};
        m_strips.attribute(0, 0, 3, GL_FLOAT, 0);
        m_strips.integers(1, 0, 1, GL_UNSIGNED_INT, offsetof(glsl::GrassBlade, size));
        m_strips.integers(2, 0, 4, GL_UNSIGNED_INT, offsetof(glsl::GrassBlade, bend));
        m_strips.perInstance(0);
        m_counts = gl::Buffer{"grass counts", sizeof(glsl::GrassCounts)};
        m_commands = gl::Buffer{"grass commands", GRASS_SHAPES * kCommandBytes};
    }
    if (most == m_room && m_blades.id()) return;
    m_room = most;
    m_blades = gl::Buffer{"grass blades", std::max<std::size_t>(m_room, 1) * GRASS_SHAPES * sizeof(glsl::GrassBlade)};
    m_strips.source(0, m_blades.id(), 0, sizeof(glsl::GrassBlade));
}

// The ground's colours from above, drawn by the ground's own shader when it looks other than it did.
void GrassPass::updateTint(GpuFrame& gpu, Scenery& scenery)
{
    Terrain& terrain = scenery.terrain;
    if (terrain.windowed()) return;
    const glm::ivec2 texels = terrain.heights()->size;
    const int longest = std::max(texels.x, texels.y);
    const glm::ivec2 size = glm::max(longest > kMostTint ? texels * kMostTint / longest : texels, glm::ivec2{1});
    const bool another = m_tint.size() != size;
    if (another) m_tint = gl::Texture{{.label = "ground tint", .size = size}};
    const io::TexelRect changed = another ? terrain.heights()->texels() : terrain.repainted();
    if (changed.empty()) return;
    std::vector<std::string> defines = terrain.coverDefines();
    std::erase(defines, "HOLES");
    defines.emplace_back("FROM_ABOVE");
    const gl::Program& program = m_shaders.program({.label = "ground tint", .stages = {"ground_tint.vert.glsl", "terrain.frag.glsl"}, .defines = std::move(defines)});
    const gl::Framebuffer target{{.label = "ground tint", .colours = {&m_tint}}};
    if (!gpu.use(program)) return;
    target.bind();
    const glm::dvec2 scale = glm::dvec2{size} / glm::dvec2{texels};
    const glm::ivec2 low{glm::floor(glm::dvec2{changed.low} * scale)}, high = glm::min(glm::ivec2{glm::ceil(glm::dvec2{changed.high} * scale)}, size);
    glViewport(low.x, low.y, high.x - low.x, high.y - low.y);
    gl::apply({});
    const glm::vec2 from = glm::vec2{low} / glm::vec2{size}, extent = glm::vec2{high - low} / glm::vec2{size};
    glProgramUniform4f(program.id(), 0, from.x, from.y, extent.x, extent.y);
    if (!m_bare.id()) m_bare = gl::VertexArray{"ground tint"};
    glBindVertexArray(m_bare.id());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gpu.count(1, 2);
    terrain.forgetRepainted();
}

bool GrassPass::place(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, const io::Environment& environment, std::span<const Presser> pressers,
                      const Settings& settings)
{
    const Eye& eye = viewpoint.eye;
    const std::optional<Volume> volume = settings.culling ? std::optional{volumeOf(viewpoint.culledFor)} : std::nullopt;
    const std::vector<glsl::GrassTile> tiles = scenery.grass.tiles(scenery.terrain, eye, volume, settings);
    glsl::GrassFrame frame = scenery.grass.frame(eye, settings);
    makeRoom(frame.most);
    frame.room = m_room;
    frame.shapeAngle = float(kManyVertices * pixelAngle(eye));
    frame.water = environment.water.level;
    if (!environment.water.on) // then any height will do
        for (glsl::GrassKind& kind : frame.kind)
            kind.aboveWater = {-kAnywhere, kAnywhere};
    frame.wind = viewpoint.wind;
    if (m_tint) frame.tintScale = 1.0f / glm::vec2{scenery.terrain.heights()->size};
    frame.pressers = int(std::min({pressers.size(), kMostPressers, std::size_t(GRASS_PRESSERS)}));
    for (int i = 0; i < frame.pressers; ++i) {
        const Presser& presser = pressers[std::size_t(i)];
        frame.presser[i] = glm::vec4{glm::vec3{presser.position - eye.position}, presser.radius};
        frame.pressed[i / 4][i % 4] = presser.strength;
    }
    gpu.constants(GRASS_BINDING, frame);
    constexpr GLuint kNone = 0;
    glClearNamedBufferData(m_counts.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &kNone);
    if (tiles.empty()) return false;

    std::vector<std::string> defines;
    if (scenery.terrain.windowed()) defines.emplace_back("WINDOWS");
    if (scenery.terrain.holed()) defines.emplace_back("HOLES");
    if (m_tint && !scenery.terrain.windowed()) defines.emplace_back("TINT");
    const gl::Program& program = m_shaders.program({.label = "grass places", .stages = {"grass_place.comp.glsl"}, .defines = std::move(defines)});
    if (!gpu.use(program, {{GRASS_MAP_UNIT, &scenery.grass.map()}, {GRASS_MASK_UNIT, &scenery.footprints.texture()}})) return false;
    if (m_tint) gpu.bind({{GROUND_TINT_UNIT, &m_tint}});
    const GpuStream::Piece piece = gpu.stream().put(std::span<const glsl::GrassTile>{tiles});
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, GRASS_TILES_BINDING, piece.buffer, GLintptr(piece.offset), GLsizeiptr(tiles.size() * sizeof(tiles[0])));
    storage(GRASS_BLADES_BINDING, m_blades.id());
    storage(GRASS_COUNTS_BINDING, m_counts.id());
    glDispatchCompute(GRASS_TILE / 8, GRASS_TILE / 8, GLuint(tiles.size()));
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    if (!gpu.use(m_commandsProgram)) return false;
    storage(GRASS_COMMANDS_BINDING, m_commands.id());
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
    return true;
}

void GrassPass::render(GpuFrame& gpu, const gl::Framebuffer& target, Scenery& scenery, const Viewpoint& viewpoint, const io::Environment& environment,
                       std::span<const Presser> pressers, const Settings& settings)
{
    gpu.stats().grassDrawn = gpu.stats().grassLeftOut = 0;
    if (!settings.grass || !scenery.grass.present() || !scenery.terrain.present()) return scenery.footprints.forget();
    const auto scope = gpu.scope("grass");
    scenery.terrain.bind(gpu);
    updateTint(gpu, scenery);
    if (!place(gpu, scenery, viewpoint, environment, pressers, settings)) return;

    target.bind();
    gl::apply({.depthTest = GL_GREATER, .depthWrite = true});
    glBindVertexArray(m_strips.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, m_commands.id());
    for (std::size_t shape = 0; shape < GRASS_SHAPES; ++shape) {
        const gl::Program& program = m_shaders.program(
            {.label = "grass", .stages = {"grass.vert.glsl", "grass.frag.glsl"}, .defines = {"SEGMENTS " + std::to_string(kShapes[shape])}});
        if (!gpu.use(program)) return;
        glDrawArraysIndirect(GL_TRIANGLE_STRIP, reinterpret_cast<const void*>(shape * kCommandBytes));
        gpu.count(1, 0);
    }
    if (const std::optional<glsl::GrassCounts> counts = m_readback.arrived()) {
        gpu.stats().grassDrawn = std::min(counts->taken, std::uint32_t(settings.mostBlades));
        gpu.stats().grassLeftOut = counts->taken - gpu.stats().grassDrawn;
        if (gpu.stats().grassLeftOut > 0 && !std::exchange(m_warned, true))
            io::log::warning("{} blades of grass are in view, {} are drawn; lower render.grass_density or raise render.most_blades", counts->taken, settings.mostBlades);
    }
    m_readback.ask(m_counts);
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

} // namespace renderer
