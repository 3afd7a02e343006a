#include "renderer/passes/water.h"

#include "renderer/passes/shafts.h"
#include "renderer/ripples.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/water.h"

namespace renderer {
namespace {

constexpr int kIndices = WATER_CELLS * WATER_CELLS * 6;
constexpr int kPlainCorners = 10;

void copyOf(gl::Texture& to, const gl::Texture& from, std::string_view label)
{
    if (to.size() != from.size() || to.format() != from.format())
        to = gl::Texture{{.label = label, .size = from.size(), .format = from.format(), .filter = from.format() == GL_RGBA16F ? GLenum(GL_LINEAR) : GLenum(GL_NEAREST), .target = true}};
    glCopyImageSubData(from.id(), GL_TEXTURE_2D, 0, 0, 0, 0, to.id(), GL_TEXTURE_2D, 0, 0, 0, 0, from.size().x, from.size().y, 1);
}

std::vector<std::string> definesOf(const Viewpoint& viewpoint, const Settings& settings, const glsl::Water& water)
{
    std::vector<std::string> defines = lightingDefines(viewpoint, settings);
    addHaze(defines, viewpoint);
    if (settings.skyPixels <= 1) defines.emplace_back("MARCH"); // where the sky is made coarse, mirrors are too
    if (water.height > 0) defines.emplace_back("FROM_BELOW");
    return defines;
}

} // namespace

WaterPass::WaterPass(ShaderLibrary& shaders) : m_shaders{shaders} {}

void WaterPass::makeGrid()
{
    std::vector<std::uint16_t> indices;
    for (int z = 0; z < WATER_CELLS; ++z)
        for (int x = 0; x < WATER_CELLS; ++x) {
            const auto corner = [&](int dx, int dz) { return std::uint16_t((z + dz) * (WATER_CELLS + 1) + x + dx); };
            for (const std::uint16_t i : {corner(0, 0), corner(0, 1), corner(1, 1), corner(0, 0), corner(1, 1), corner(1, 0)})
                indices.push_back(i);
        }
    m_indices = gl::Buffer{"water's cells", indices.size() * sizeof(std::uint16_t)};
    m_indices.write(0, std::as_bytes(std::span{indices}));
    m_patches = gl::VertexArray{"water"};
    m_patches.attribute(0, 0, 4, GL_FLOAT, 0);
    m_patches.perInstance(0);
    m_patches.indices(m_indices.id());
    m_plain = gl::VertexArray{"water's plain"};
    m_ripples = makeRipples();
}

void WaterPass::copy(const Radiance& radiance, const GBuffer& surfaces)
{
    copyOf(m_behind, radiance.texture, "behind water");
    copyOf(m_behindDepth, surfaces.depth, "depth behind water");
}

void WaterPass::drawPatches(GpuFrame& gpu, const Viewpoint& viewpoint, glsl::Water& water, const Settings& settings)
{
    const std::optional<Volume> volume = settings.culling ? std::optional{volumeOf(viewpoint.eye)} : std::nullopt;
    const std::vector<WaterPatch> patches = waterPatches(water, viewpoint.eye, volume);
    gpu.constants(WATER_BINDING, water);
    const gl::DrawState state{.depthTest = GL_GREATER, .depthWrite = true};
    const auto program = [&](const char* label, std::vector<std::string> defines) -> const gl::Program& {
        return m_shaders.program({.label = label, .stages = {"water.vert.glsl", "water.frag.glsl"}, .defines = std::move(defines)});
    };
    std::vector<std::string> defines = definesOf(viewpoint, settings, water);
    const gl::Program& plain = program("water's plain", defines);
    defines.emplace_back("PATCHES");
    if (!patches.empty() && gpu.use(program("water", std::move(defines)))) {
        gl::apply(state);
        const GpuStream::Piece piece = gpu.stream().put(std::span<const WaterPatch>{patches});
        m_patches.source(0, piece.buffer, piece.offset, sizeof(WaterPatch));
        glBindVertexArray(m_patches.id());
        glDrawElementsInstanced(GL_TRIANGLES, kIndices, GL_UNSIGNED_SHORT, nullptr, GLsizei(patches.size()));
        gpu.count(1, patches.size() * kIndices / 3);
    }
    if (!gpu.use(plain)) return;
    gl::apply(state);
    glBindVertexArray(m_plain.id());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, kPlainCorners);
    gpu.count(1, kPlainCorners - 2);
}

void WaterPass::render(GpuFrame& gpu, Radiance& radiance, const GBuffer& surfaces, const io::Environment& environment,
                       const Viewpoint& viewpoint, const Settings& settings)
{
    if (!environment.water.on || !settings.water) return;
    const auto scope = gpu.scope("water");
    if (!m_ripples) makeGrid();
    copy(radiance, surfaces);
    radiance.framebuffer.bind();
    gpu.bind({{RIPPLES_UNIT, &m_ripples}, {BEHIND_UNIT, &m_behind}, {BEHIND_DEPTH_UNIT, &m_behindDepth}});
    glsl::Water water = waterOf(environment, viewpoint.eye, viewpoint.time);
    drawPatches(gpu, viewpoint, water, settings);
    if (water.height <= 0) return;
    surfaces.bind(gpu);
    gpu.fullScreen(m_shaders.fullScreen("underwater"), {.blend = gl::Blend::Over}, {});
}

} // namespace renderer
