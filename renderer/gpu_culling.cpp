#include "renderer/gpu_culling.h"

#include "io/base/log.h"

#include <algorithm>
#include <bit>
#include <tuple>

namespace renderer {
namespace {

constexpr std::size_t kFirstRoom = 16384;   // instances in a list
constexpr GLuint kThreads = 64;

template <class T>
void ensure(gl::Buffer& buffer, std::string_view label, std::size_t count)
{
    gl::grow(buffer, label, std::max<std::size_t>(count, 1) * sizeof(T), 0);
}

void clear(const gl::Buffer& buffer)
{
    constexpr GLuint kZero = 0;
    glClearNamedBufferData(buffer.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &kZero);
}

void storage(GLuint binding, GLuint buffer)
{
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer);
}

GLuint groups(std::size_t count)
{
    return GLuint((count + kThreads - 1) / kThreads);
}

} // namespace

void CullTable::update(const ModelLibrary& models)
{
    if (m_of == models.revision()) return;
    m_of = models.revision();
    struct Placed {
        std::uint32_t bin;
        const ModelPart* part;
    };
    std::vector<Placed> placed;
    const std::span<const Bin> bins = models.bins();
    for (std::uint32_t bin = 0; bin < bins.size(); ++bin) {
        const ModelEntry& model = models.entry(bins[bin].model);
        if (model.blended || (bins[bin].swaying && !model.sways)) continue;
        for (const ModelPart& part : model.levels[std::size_t(bins[bin].level)].parts)
            placed.push_back({bin, &part});
    }
    std::ranges::stable_sort(placed, {}, [&](const Placed& p) {
        const bool holes = hasHoles(models.batches()[std::size_t(p.part->batch)]);
        return std::tuple{holes, bins[p.bin].fading, bins[p.bin].swaying, p.part->batch, bins[p.bin].mirrored};
    });
    m_ranges.clear();
    std::vector<glsl::CullPart> parts;
    for (const Placed& p : placed) {
        const Bin& bin = bins[p.bin];
        if (m_ranges.empty() || m_ranges.back().batch != p.part->batch || m_ranges.back().mirrored != bin.mirrored ||
            m_ranges.back().fading != bin.fading || m_ranges.back().swaying != bin.swaying)
            m_ranges.push_back({.batch = p.part->batch,
                                .mirrored = bin.mirrored,
                                .fading = bin.fading,
                                .swaying = bin.swaying,
                                .commandOffset = parts.size() * sizeof(DrawCommand)});
        ++m_ranges.back().commands;
        parts.push_back({.firstIndex = p.part->firstIndex,
                         .indexCount = p.part->indexCount,
                         .bin = p.bin,
                         .level = std::uint32_t(bin.level)});
    }
    m_partCount = std::uint32_t(parts.size());
    m_binCount = std::uint32_t(bins.size());
    ensure<glsl::CullPart>(m_parts, "parts to draw", parts.size());
    m_parts.write(0, std::as_bytes(std::span{parts}));
    const std::span<const glsl::CullModel> levels = models.cullModels();
    ensure<glsl::CullModel>(m_models, "levels of models", levels.size());
    m_models.write(0, std::as_bytes(levels));
}

DepthPyramid::DepthPyramid(ShaderLibrary& shaders)
    : m_program{shaders.program({.label = "depth pyramid", .stages = {"depth_pyramid.comp.glsl"}})}
{
}

const gl::Texture& DepthPyramid::make(GpuFrame& gpu, const gl::Texture& depth)
{
    const glm::ivec2 from = depth.size();
    const glm::ivec2 size{int(std::bit_floor(unsigned(from.x))), int(std::bit_floor(unsigned(from.y)))};
    if (m_levels.size() != size)
        m_levels = gl::Texture{{.label = "depth pyramid",
                                .size = size,
                                .format = GL_R32F,
                                .mips = gl::fullMipCount(size),
                                .filter = GL_NEAREST,
                                .target = true}};
    if (!gpu.use(m_program)) return m_levels;
    for (int mip = 0; mip < m_levels.mips(); ++mip) {
        const glm::ivec2 coarse = m_levels.size(mip);
        gpu.bind({{IMAGE_UNIT, mip == 0 ? &depth : &m_levels}});
        glBindImageTexture(0, m_levels.id(), mip, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
        glProgramUniform3i(m_program.id(), 0, coarse.x, coarse.y, std::max(mip - 1, 0));
        glDispatchCompute(GLuint(coarse.x + 7) / 8, GLuint(coarse.y + 7) / 8, 1);
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    }
    return m_levels;
}

CulledView::CulledView(ShaderLibrary& shaders, std::size_t mostRoom)
    : m_all{shaders.program({.label = "cull", .stages = {"cull.comp.glsl"}, .defines = {"DECIDE"}})},
      m_early{shaders.program({.label = "cull early", .stages = {"cull.comp.glsl"}, .defines = {"DECIDE", "EARLY"}})},
      m_late{shaders.program({.label = "cull late", .stages = {"cull.comp.glsl"}, .defines = {"DECIDE", "LATE"}})},
      m_kept{shaders.program({.label = "cull kept", .stages = {"cull.comp.glsl"}, .defines = {"DECIDE", "KEPT"}})},
      m_copy{shaders.program({.label = "cull copies", .stages = {"cull.comp.glsl"}})},
      m_commands{shaders.program({.label = "cull commands", .stages = {"cull_commands.comp.glsl"}})},
      m_countsBuffer{"culling counts", sizeof(glsl::CullCounts)}, m_mostRoom{mostRoom},
      m_room{std::min(kFirstRoom, mostRoom)}, m_readback{std::make_unique<GpuReadback<glsl::CullCounts>>("culling counts, read")}
{
    clear(m_countsBuffer); // read before any is counted; a fresh buffer holds anything
}

DrawList CulledView::run(GpuFrame& gpu, const gl::Program& decide, Pass& pass, const CullTable& table,
                         const GpuCullScene& scene, const CullRequest& request)
{
    if (scene.count == 0 || table.partCount() == 0 || !m_commands || !m_copy || !gpu.use(decide)) return {};
    ensure<glsl::CullBin>(pass.bins, "bins of a view", table.binCount());
    ensure<DrawCommand>(pass.commands, "commands of a view", table.partCount());
    ensure<glsl::Instance>(pass.drawn, "instances of a view", m_room);
    ensure<std::uint32_t>(m_decided, "decisions of a view", scene.count);
    if (m_slots < scene.count) { // the first look at these: nothing was seen
        ensure<std::uint32_t>(m_seen, "seen by a view", scene.count);
        clear(m_seen);
        m_slots = m_seen.bytes() / sizeof(std::uint32_t);
    }
    clear(pass.bins);
    gpu.constants(PASS_BINDING, cullView(request, scene.count));
    storage(CULL_RECORDS_BINDING, scene.records);
    storage(CULL_MODELS_BINDING, table.models());
    storage(CULL_BINS_BINDING, pass.bins.id());
    storage(CULL_DECIDED_BINDING, m_decided.id());
    storage(CULL_SEEN_BINDING, m_seen.id());
    storage(CULL_COUNTS_BINDING, m_countsBuffer.id());
    glDispatchCompute(groups(scene.count), 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);

    gpu.use(m_commands);
    storage(CULL_PARTS_BINDING, table.parts());
    storage(CULL_COMMANDS_BINDING, pass.commands.id());
    glProgramUniform3ui(m_commands.id(), 0, table.binCount(), table.partCount(), GLuint(m_room));
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);

    gpu.use(m_copy);
    storage(CULL_RECORDS_BINDING, scene.records);
    storage(CULL_MODELS_BINDING, table.models());
    storage(CULL_INSTANCES_BINDING, scene.instances);
    storage(CULL_DRAWN_BINDING, pass.drawn.id());
    glDispatchCompute(groups(scene.count), 1, 1);
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT);

    DrawList list;
    list.instances = {.buffer = pass.drawn.id()};
    list.commands = {.buffer = pass.commands.id()};
    list.opaque.assign(table.ranges().begin(), table.ranges().end());
    return list;
}

DrawList CulledView::all(GpuFrame& gpu, const CullTable& table, const GpuCullScene& scene, const CullRequest& request)
{
    readCounts();
    return run(gpu, m_all, m_passes[0], table, scene, request);
}

DrawList CulledView::early(GpuFrame& gpu, const CullTable& table, const GpuCullScene& scene, const CullRequest& request)
{
    readCounts();
    return run(gpu, m_early, m_passes[0], table, scene, request);
}

DrawList CulledView::late(GpuFrame& gpu, const CullTable& table, const GpuCullScene& scene, const CullRequest& request,
                          const gl::Texture& pyramid)
{
    gpu.bind({{IMAGE_UNIT, &pyramid}});
    return run(gpu, m_late, m_passes[1], table, scene, request);
}

DrawList CulledView::kept(GpuFrame& gpu, const CullTable& table, const GpuCullScene& scene, const CullRequest& request)
{
    readCounts();
    return run(gpu, m_kept, m_passes[0], table, scene, request);
}

// Sends off the counts of the frame before, and takes those that have come.
void CulledView::readCounts()
{
    m_counts = m_readback->arrived().value_or(m_counts);
    m_readback->ask(m_countsBuffer);
    clear(m_countsBuffer);
    if (m_counts.copies > m_room && m_room < m_mostRoom) {
        m_room = std::min(m_mostRoom, std::bit_ceil(std::size_t(m_counts.copies)));
    } else if (m_counts.copies > m_room && !m_warned) {
        m_warned = true;
        io::log::warning("{} instances are in view, {} are drawn; look at less or lower the quality", m_counts.copies, m_room);
    }
}

} // namespace renderer
