#include "renderer/passes/transparent.h"

#include "renderer/passes/shafts.h"
#include "renderer/shaders/shared/bindings.h"

#include <algorithm>

namespace renderer {
namespace {

constexpr unsigned kAllFeatures = kFeatureMask | kFeatureNormalMap | kFeatureSurfaceMaps | kFeatureWrap | kFeatureUvTransform |
                                  kFeatureSmoothColours;

struct BlendedRun {
    const DrawList* list = nullptr;
    std::span<const DrawRange> ranges; // that nothing of another list lies between
};

std::vector<BlendedRun> backToFront(std::span<const DrawList> lists)
{
    std::vector<BlendedRun> single, runs;
    for (const DrawList& list : lists)
        for (const DrawRange& range : list.blended)
            single.push_back({&list, {&range, 1}});
    std::ranges::stable_sort(single, std::greater{}, [](const BlendedRun& run) { return run.ranges[0].distance; });
    for (const BlendedRun& next : single)
        if (!runs.empty() && runs.back().list == next.list && &*next.ranges.begin() == &runs.back().ranges.back() + 1)
            runs.back().ranges = {runs.back().ranges.data(), runs.back().ranges.size() + 1};
        else runs.push_back(next);
    return runs;
}

} // namespace

TransparentPass::TransparentPass(ShaderLibrary& shaders)
    : m_shaders{shaders},
      m_depthOnly{shaders.program({.label = "ghosts' depth",
                                   .stages = {"objects.vert.glsl", "empty.frag.glsl"},
                                   .defines = {"POSITION_ONLY"}})},
      m_objects{makeObjectVertexArray()}
{
}

ObjectPrograms& TransparentPass::programs(bool ghosts, const Viewpoint& viewpoint, const Settings& settings)
{
    std::vector<std::string> defines = lightingDefines(viewpoint, settings);
    addHaze(defines, viewpoint);
    defines.emplace_back("FORWARD");
    defines.emplace_back(ghosts ? "GHOST" : "WRITE_ID");
    for (const auto& variant : m_variants)
        if (variant->defines == defines) return variant->programs;
    m_variants.push_back(std::make_unique<Variant>(Variant{defines, {m_shaders, "forward", defines, kAllFeatures}}));
    return m_variants.back()->programs;
}

void TransparentPass::resize(const Radiance& radiance, const GBuffer& surfaces)
{
    if (m_radiance == radiance.texture.id() && m_id == surfaces.id.id()) return;
    m_withIds = gl::Framebuffer{
        {.label = "transparent", .colours = {&radiance.texture, &surfaces.id}, .depth = &surfaces.depth}};
    m_radiance = radiance.texture.id();
    m_id = surfaces.id.id();
}

void TransparentPass::render(GpuFrame& gpu, Radiance& radiance, const GBuffer& surfaces, Scenery& scenery,
                             const Viewpoint& viewpoint, std::span<const DrawList> objects, std::span<const Ghost> ghosts,
                             const Settings& settings)
{
    const auto blends = [](const DrawList& list) { return !list.blended.empty(); };
    if (std::ranges::none_of(objects, blends) && ghosts.empty()) return;
    const auto scope = gpu.scope("transparent");
    resize(radiance, surfaces);
    if (std::ranges::any_of(objects, blends)) drawBlended(gpu, viewpoint, objects, settings);
    if (!ghosts.empty()) drawGhosts(gpu, radiance, scenery, viewpoint, ghosts, settings);
}

void TransparentPass::drawBlended(GpuFrame& gpu, const Viewpoint& viewpoint, std::span<const DrawList> objects,
                                  const Settings& settings)
{
    ObjectPrograms& kinds = programs(false, viewpoint, settings);
    m_withIds.bind();
    for (const auto& [list, ranges] : backToFront(objects))
        drawRanges(gpu, m_objects, *list, ranges, [&](const DrawRange& range, const Batch& batch) {
            gl::apply({.depthTest = GL_GREATER,
                       .cull = GLenum(batch.twoSided ? GL_NONE : GL_BACK),
                       .clockwise = range.mirrored,
                       .blend = gl::Blend::Alpha});
            bindArrays(gpu, *list->models, batch);
            return gpu.use(kinds.of(batch, false, range.swaying));
        });
}

// Their depth first, so that one sees through a ghost but not into it.
void TransparentPass::drawGhosts(GpuFrame& gpu, Radiance& radiance, Scenery& scenery, const Viewpoint& viewpoint,
                                 std::span<const Ghost> ghosts, const Settings& settings)
{
    ObjectPrograms& kinds = programs(true, viewpoint, settings);
    radiance.framebuffer.bind();
    for (const DrawList& list : drawsOf(gpu, scenery.world, ghosts))
        drawGhostList(gpu, kinds, list);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void TransparentPass::drawGhostList(GpuFrame& gpu, ObjectPrograms& kinds, const DrawList& list)
{
    for (const bool depthOnly : {true, false})
        for (const std::span<const DrawRange> ranges : {std::span{list.opaque}, std::span{list.blended}})
            drawRanges(gpu, m_objects, list, ranges, [&](const DrawRange& range, const Batch& batch) {
                const bool masked = batch.features & kFeatureMask;
                if (depthOnly && masked) return false; // holes would be filled
                gl::apply({.depthTest = GLenum(depthOnly ? GL_GREATER : GL_GEQUAL),
                           .depthWrite = depthOnly || masked,
                           .cull = GLenum(batch.twoSided ? GL_NONE : GL_BACK),
                           .clockwise = range.mirrored,
                           .blend = gl::Blend::Alpha});
                if (depthOnly) glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
                else glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
                bindArrays(gpu, *list.models, batch);
                return gpu.use(depthOnly ? m_depthOnly : kinds.of(batch));
            });
}

} // namespace renderer
