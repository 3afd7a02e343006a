#include "renderer/passes/geometry.h"

#include "renderer/shaders/shared/bindings.h"

namespace renderer {

void GBuffer::bind(GpuFrame& gpu) const
{
    gpu.bind({{GBUFFER_COLOUR_UNIT, &colour},
              {GBUFFER_NORMAL_UNIT, &normal},
              {GBUFFER_SURFACE_UNIT, &surface},
              {GBUFFER_ID_UNIT, &id},
              {GBUFFER_DEPTH_UNIT, &depth}});
}

GeometryPass::GeometryPass(ShaderLibrary& shaders)
    : m_shaders{shaders}, m_programs{shaders, "objects", {}, ~0u},
      m_objects{makeObjectVertexArray()}
{
}

void GeometryPass::resize(glm::ivec2 size)
{
    if (m_targets.depth.size() == size) return;
    const auto make = [&](std::string_view label, GLenum format) {
        return gl::Texture{{.label = label, .size = size, .format = format, .filter = GL_NEAREST, .target = true}};
    };
    m_targets = {.colour = make("gbuffer colour", GL_RGBA8),
                 .normal = make("gbuffer normal", GL_RG16_SNORM),
                 .surface = make("gbuffer surface", GL_RGBA8),
                 .id = make("gbuffer id", GL_R32UI),
                 .depth = make("gbuffer depth", GL_DEPTH_COMPONENT32F)};
    m_framebuffer = gl::Framebuffer{{.label = "gbuffer",
                                     .colours = {&m_targets.colour, &m_targets.normal, &m_targets.surface, &m_targets.id},
                                     .depth = &m_targets.depth}};
    m_withoutIds = gl::Framebuffer{{.label = "gbuffer without ids",
                                    .colours = {&m_targets.colour, &m_targets.normal, &m_targets.surface},
                                    .depth = &m_targets.depth}};
}

void GeometryPass::begin(const Viewpoint& viewpoint, bool ids)
{
    resize(viewpoint.eye.size);
    m_ids = ids;
    constexpr GLuint kNobody[4] = {};
    m_framebuffer.clearDepth(0);
    glClearNamedFramebufferuiv(m_framebuffer.id(), GL_COLOR, 3, kNobody);
}

void GeometryPass::drawObjects(GpuFrame& gpu, const DrawList& objects)
{
    framebuffer().bind();
    drawRanges(gpu, m_objects, objects, objects.opaque, [&](const DrawRange& range, const Batch& batch) {
        gl::apply({.depthTest = GL_GREATER,
                   .depthWrite = true,
                   .cull = GLenum(batch.twoSided ? GL_NONE : GL_BACK),
                   .clockwise = range.mirrored});
        bindArrays(gpu, *objects.models, batch);
        return gpu.use(m_programs.of(batch, range.fading, range.swaying));
    });
}

void GeometryPass::drawGround(GpuFrame& gpu, Scenery& scenery, const Terrain::Draws& ground, const Settings& settings)
{
    std::vector<std::string> defines = scenery.terrain.coverDefines();
    if (settings.groundDetail) defines.emplace_back("DETAIL");
    for (const Terrain::Draw& part : ground) {
        if (!gpu.use(m_shaders.program(scenery.terrain.program("ground", part.stages, "terrain.frag.glsl", defines)))) continue;
        framebuffer().bind();
        gl::apply({.depthTest = GL_GREATER, .depthWrite = true, .cull = GL_BACK});
        scenery.terrain.bind(gpu);
        scenery.terrain.draw(gpu, part);
    }
}

const GBuffer& GeometryPass::finish()
{
    glTextureBarrier(); // later passes read these textures while depth stays attached, unwritten
    return m_targets;
}

} // namespace renderer
