#include "renderer/passes/occlusion.h"

#include "renderer/shaders/shared/bindings.h"
#include "renderer/shaders/shared/occlusion.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

// Software draws at half the resolution, and each place looked at costs it as much as a pixel's simple shading.
constexpr int kSlices = 4, kSteps = 6; // to either side
constexpr int kHalfSlices = 1, kHalfSteps = 4;
constexpr float kMostOfHeight = 0.4f; // of the picture, that the radius may span: places further apart say nothing of each other

glsl::OcclusionPass constantsOf(const Eye& eye, const io::Occlusion& occlusion, int stride, glm::ivec2 size)
{
    const glm::dvec2 half{eye.tanHalfFov * eye.aspect, eye.tanHalfFov};
    const glm::dvec2 pixels{eye.size};
    glsl::OcclusionPass pass{};
    pass.radius = std::max(occlusion.radius, 1e-3f);
    pass.strength = std::max(occlusion.strength, 0.0f);
    pass.pixels = float(pixels.y / (2 * eye.tanHalfFov * stride));
    pass.most = kMostOfHeight * float(size.y);
    pass.scale = glm::vec2{half * 2.0 * double(stride) / pixels};
    pass.bias = glm::vec2{half * (1.0 / pixels - 1.0)};
    pass.axes = glm::vec2{1.0 / half};
    pass.size = size;
    return pass;
}

} // namespace

bool occludes(const io::Occlusion& occlusion, const Settings& settings)
{
    return settings.ao && occlusion.strength > 0 && occlusion.radius > 0;
}

std::vector<std::string> occlusionDefines(const io::Occlusion& occlusion, const Settings& settings)
{
    if (!occludes(occlusion, settings)) return {};
    if (settings.halfOcclusion) return {"OCCLUSION", "HALF_OCCLUSION"};
    return {"OCCLUSION"};
}

void OcclusionPass::resize(glm::ivec2 size)
{
    if (m_found.texture.size() == size) return;
    for (Target* target : {&m_found, &m_across}) {
        target->texture = gl::Texture{{.label = "ambient occlusion", .size = size, .format = GL_RG16F, .filter = GL_NEAREST, .target = true}};
        target->framebuffer = gl::Framebuffer{{.label = "ambient occlusion", .colours = {&target->texture}}};
    }
}

void OcclusionPass::render(GpuFrame& gpu, const GBuffer& surfaces, const Eye& eye, const io::Occlusion& occlusion, const Settings& settings)
{
    if (!occludes(occlusion, settings)) return;
    const auto scope = gpu.scope("occlusion");
    const bool half = settings.halfOcclusion;
    const int stride = half ? 2 : 1;
    const glm::ivec2 size = (eye.size + stride - 1) / stride;
    resize(size);
    glsl::OcclusionPass pass = constantsOf(eye, occlusion, stride, size);

    const std::vector<std::string> search{"STRIDE " + std::to_string(stride), "SLICES " + std::to_string(half ? kHalfSlices : kSlices),
                                          "STEPS " + std::to_string(half ? kHalfSteps : kSteps)};
    surfaces.bind(gpu);
    gpu.constants(PASS_BINDING, pass);
    m_found.framebuffer.bind();
    gpu.fullScreen(m_shaders.fullScreen("occlusion", search), {}, {});

    pass.step = {1, 0};
    gpu.constants(PASS_BINDING, pass);
    m_across.framebuffer.bind();
    gpu.fullScreen(m_shaders.fullScreen("occlusion_blur"), {}, {{IMAGE_UNIT, &m_found.texture}});
    pass.step = {0, 1};
    gpu.constants(PASS_BINDING, pass);
    m_found.framebuffer.bind();
    gpu.fullScreen(m_shaders.fullScreen("occlusion_blur", {"LAST"}), {}, {{IMAGE_UNIT, &m_across.texture}});
    gpu.bind({{AMBIENT_OCCLUSION_UNIT, &m_found.texture}});
}

} // namespace renderer
