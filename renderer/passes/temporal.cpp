#include "renderer/passes/temporal.h"

#include "renderer/shaders/shared/bindings.h"

#include <glm/gtc/matrix_transform.hpp>

namespace renderer {
namespace {

constexpr float kLeastShare = 0.06f;        // of a frame while the eye rests
constexpr float kLeastShareMoving = 0.14f; // looking up what was gathered blurs it a little each time

// Digits of a number, mirrored behind the point: spread evenly wherever one stops.
double halton(int index, int base)
{
    double result = 0, digit = 1;
    for (int i = index; i > 0; i /= base) {
        digit /= base;
        result += digit * (i % base);
    }
    return result;
}

struct Constants {
    glm::mat4 lastClipFromRelative{1};
    glm::vec4 mixing{1, 0, 0, 0};
};

} // namespace

glm::dvec2 jitterOf(int frame, glm::ivec2 size)
{
    const int place = frame % kTemporalFrames;
    if (place == 0) return glm::dvec2{0};
    return (glm::dvec2{halton(place, 2), halton(place, 3)} - 0.5) * 2.0 / glm::dvec2{size};
}

TemporalPass::TemporalPass(ShaderLibrary& shaders) : m_shaders{shaders} {}

const gl::Texture& TemporalPass::render(GpuFrame& gpu, const Radiance& radiance, const GBuffer& surfaces, const Eye& eye,
                                        const Eye& last, int frame)
{
    const auto scope = gpu.scope("gather frames");
    const glm::ivec2 size = radiance.texture.size();
    for (Target* target : {&m_gathered, &m_next})
        if (target->texture.size() != size) {
            target->texture = gl::Texture{{.label = "gathered frames", .size = size, .format = GL_RGBA16F, .target = true}};
            target->framebuffer = gl::Framebuffer{{.label = "gathered frames", .colours = {&target->texture}}};
        }
    // While few are gathered they weigh the same.
    const bool rests = eye.position == last.position && eye.clipFromRelative == last.clipFromRelative;
    const float share = std::max(1.0f / float(frame + 1), rests ? kLeastShare : kLeastShareMoving);
    const glm::dmat4 toLastEye = glm::translate(glm::dmat4{1}, eye.position - last.position);
    gpu.constants(PASS_BINDING, Constants{glm::mat4{last.clipFromRelative * toLastEye}, {share, 0, 0, 0}});
    surfaces.bind(gpu);
    m_next.framebuffer.bind();
    gpu.fullScreen(m_shaders.fullScreen("temporal"), {}, {{IMAGE_UNIT, &radiance.texture}, {HISTORY_UNIT, &m_gathered.texture}});
    std::swap(m_gathered, m_next);
    return m_gathered.texture;
}

void TemporalPass::forget()
{
    m_gathered = {};
    m_next = {};
}

} // namespace renderer
