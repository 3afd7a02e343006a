#include "renderer/passes/picture.h"

#include "renderer/passes/occlusion.h"
#include "renderer/shaders/shared/bindings.h"

namespace renderer {

void PictureTarget::resize(std::string_view label, glm::ivec2 size)
{
    if (texture.size() == size) return;
    texture = gl::Texture{{.label = label, .size = size, .format = GL_RGBA8, .target = true}};
    glTextureParameteri(texture.id(), GL_TEXTURE_SWIZZLE_A, GL_ONE); // whoever shows it in a panel sees it opaque
    framebuffer = gl::Framebuffer{{.label = label, .colours = {&texture}}};
}

ShowPass::ShowPass(ShaderLibrary& shaders)
    : m_shaders{shaders},
      m_flatObjects{shaders, "flat", {"POSITION_ONLY"}, kFeatureImpostor | kFeatureMask},
      m_objectLevels{shaders, "flat", {"POSITION_ONLY", "LEVELS"}, kFeatureImpostor | kFeatureMask},
      m_objects{makeObjectVertexArray()}
{
}

// Everything the camera sees once more, in one colour.
void ShowPass::drawAgain(GpuFrame& gpu, Scenery& scenery, const GeometryPass::Drawn& drawn, const gl::DrawState& state,
                         bool levels)
{
    const auto prepare = [&](const DrawRange& range, const Batch& batch) {
        gl::DrawState own = state;
        own.cull = batch.twoSided ? GL_NONE : GL_BACK;
        own.clockwise = range.mirrored;
        gl::apply(own);
        return gpu.use((levels ? m_objectLevels : m_flatObjects).of(batch, false, range.swaying));
    };
    for (const DrawList& objects : drawn.objects)
        drawRanges(gpu, m_objects, objects, objects.opaque, prepare);
    std::vector<std::string> defines;
    if (levels) defines.emplace_back("LEVELS");
    drawGround(gpu, scenery, drawn.ground, state, "flat.frag.glsl", defines);
}

void ShowPass::drawGround(GpuFrame& gpu, Scenery& scenery, const Terrain::Draws& ground, gl::DrawState state, const char* fragment,
                          const std::vector<std::string>& defines)
{
    state.cull = GL_BACK;
    for (const Terrain::Draw& part : ground) {
        if (!gpu.use(m_shaders.program(scenery.terrain.program("ground again", part.stages, fragment, defines)))) continue;
        gl::apply(state);
        scenery.terrain.bind(gpu);
        scenery.terrain.draw(gpu, part);
    }
}

void ShowPass::render(GpuFrame& gpu, PictureTarget& canvas, Show show, const Radiance& radiance, const GBuffer& surfaces,
                      Scenery& scenery, const Viewpoint& viewpoint, const GeometryPass::Drawn& drawn, const Settings& settings)
{
    const auto scope = gpu.scope("show");
    if (show == Show::Overdraw) { // counted where the light was, for want of it
        radiance.framebuffer.clearColour(0, glm::vec4{0});
        radiance.framebuffer.bind();
        gpu.constants(PASS_BINDING, glm::vec4{1});
        drawAgain(gpu, scenery, drawn, {.blend = gl::Blend::Add}, false);
    }
    const bool ofGround = show >= Show::Contours;
    const bool overBackdrop = show == Show::Wireframe || show == Show::Lod || show == Show::Nodes || ofGround;
    std::vector<std::string> defines = shadowDefines(viewpoint.shadows);
    defines.push_back("MODE " + std::to_string(overBackdrop ? int(Show::Wireframe) : int(show)));
    if (show == Show::Ao)
        for (std::string& define : occlusionDefines(viewpoint.occlusion, settings))
            defines.push_back(std::move(define));
    canvas.framebuffer.bind();
    surfaces.bind(gpu);
    gpu.fullScreen(m_shaders.fullScreen("show", std::move(defines)), {}, {{IMAGE_UNIT, &radiance.texture}});
    if (!overBackdrop || show == Show::Nodes) return; // lines come over it

    if (m_canvas != canvas.texture.id() || m_depth != surfaces.depth.id()) {
        m_withDepth = gl::Framebuffer{{.label = "picture with depth", .colours = {&canvas.texture}, .depth = &surfaces.depth}};
        m_canvas = canvas.texture.id();
        m_depth = surfaces.depth.id();
    }
    m_withDepth.bind();
    if (ofGround) {
        std::vector<std::string> view = scenery.terrain.coverDefines();
        view.insert(view.end(), {"LEVELS", "VIEW " + std::to_string(int(show) - int(Show::Contours))});
        drawGround(gpu, scenery, drawn.ground, {.depthTest = GL_EQUAL, .blend = gl::Blend::Alpha}, "terrain_show.frag.glsl", view);
        return;
    }
    const bool lines = show == Show::Wireframe;
    gpu.constants(PASS_BINDING, lines ? glm::vec4{0.75f, 0.85f, 1, 1} : glm::vec4{0.85f, 0.8f, 0.7f, 1});
    const gl::DrawState state = lines ? gl::DrawState{.depthTest = GL_GEQUAL, .lines = true, .depthOffset = {1, 4}}
                                      : gl::DrawState{.depthTest = GL_EQUAL};
    drawAgain(gpu, scenery, drawn, state, !lines);
}

} // namespace renderer
