#include "renderer/passes/transparent.h"

#include "renderer/shaders/shared/bindings.h"

#include <algorithm>

namespace renderer {
namespace {

constexpr unsigned kAllFeatures = kFeatureMask | kFeatureNormalMap | kFeatureSurfaceMaps | kFeatureWrap | kFeatureUvTransform;

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
    for (const DrawList& list : objects)
        if (blends(list)) drawBlended(gpu, scenery, viewpoint, list, settings);
    if (!ghosts.empty()) drawGhosts(gpu, radiance, scenery, viewpoint, ghosts, settings);
}

void TransparentPass::drawBlended(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, const DrawList& objects,
                                  const Settings& settings)
{
    ObjectPrograms& kinds = programs(false, viewpoint, settings);
    const ModelLibrary& models = scenery.world.models();
    m_withIds.bind();
    models.bindMaterials();
    drawRanges(gpu, m_objects, models, objects, objects.blended, [&](const DrawRange& range) {
        const Batch& batch = models.batches()[std::size_t(range.batch)];
        gl::apply({.depthTest = GL_GREATER,
                   .cull = GLenum(batch.twoSided ? GL_NONE : GL_BACK),
                   .clockwise = range.mirrored,
                   .blend = gl::Blend::Alpha});
        bindArrays(gpu, models, batch);
        return gpu.use(kinds.of(batch));
    });
}

// Their depth first, so that one sees through a ghost but not into it.
void TransparentPass::drawGhosts(GpuFrame& gpu, Radiance& radiance, Scenery& scenery, const Viewpoint& viewpoint,
                                 std::span<const Ghost> ghosts, const Settings& settings)
{
    ObjectPrograms& kinds = programs(true, viewpoint, settings);
    const ModelLibrary& models = scenery.world.models();
    radiance.framebuffer.bind();
    const DrawList list = drawsOf(gpu, scenery.world, ghosts);
    for (const bool depthOnly : {true, false})
        for (const std::span<const DrawRange> ranges : {std::span{list.opaque}, std::span{list.blended}})
            drawRanges(gpu, m_objects, models, list, ranges, [&](const DrawRange& range) {
                const Batch& batch = models.batches()[std::size_t(range.batch)];
                const bool masked = batch.features & kFeatureMask;
                if (depthOnly && masked) return false; // holes would be filled
                gl::apply({.depthTest = GLenum(depthOnly ? GL_GREATER : GL_GEQUAL),
                           .depthWrite = depthOnly || masked,
                           .cull = GLenum(batch.twoSided ? GL_NONE : GL_BACK),
                           .clockwise = range.mirrored,
                           .blend = gl::Blend::Alpha});
                if (depthOnly) glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
                else glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
                bindArrays(gpu, models, batch);
                return gpu.use(depthOnly ? m_depthOnly : kinds.of(batch));
            });
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

} // namespace renderer
