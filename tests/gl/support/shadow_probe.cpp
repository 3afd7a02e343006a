#include "tests/gl/support/shadow_probe.h"

#include "renderer/heavens.h"

#include <array>
#include <string_view>

namespace test {
namespace {

constexpr glm::ivec2 kSize{64, 36};
constexpr GLuint kGroup = 64;

GLuint bufferOf(GLuint binding, GLsizeiptr bytes, const void* data)
{
    GLuint id = 0;
    glCreateBuffers(1, &id);
    glNamedBufferStorage(id, bytes, data, 0);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, id);
    return id;
}

} // namespace

ShadowProbe::ShadowProbe() : m_shaders{WOLD_SOURCE_DIR "/renderer/shaders"}
{
    settings = frame(kSize, {}).settings;
    settings.clouds = settings.fog = false;
}

std::vector<float> ShadowProbe::ask(const io::Environment& environment, const io::Camera& camera, std::span<const GroundPoint> points)
{
    renderer::FrameInput in = frame(kSize, camera);
    in.settings = settings;
    shared().render(in); // leaves its constants and maps bound
    m_eye = renderer::eyeOf(camera, kSize);
    const double radius = glm::radians(double(environment.sun.angularDiameter)) / 2;
    const glm::dvec3 toward = renderer::inSteps(io::towardSun(environment));
    m_cascades = renderer::cascadesOf(m_eye, environment.shadows, toward, radius);
    m_constants = renderer::shadowConstants(environment.shadows, m_cascades, toward);

    std::vector<glm::vec4> places, normals;
    for (const GroundPoint& point : points) {
        places.emplace_back(glm::vec3{point.place - camera.eye}, 0);
        normals.emplace_back(point.normal, 0);
    }
    std::vector<float> lit(points.size());
    const auto bytes = GLsizeiptr(places.size() * sizeof(glm::vec4));
    const std::array<GLuint, 3> buffers{bufferOf(0, bytes, places.data()), bufferOf(1, bytes, normals.data()),
                                        bufferOf(2, GLsizeiptr(lit.size() * sizeof(float)), nullptr)};
    std::vector<std::string> defines = renderer::shadowDefines(m_constants);
    if (mixes) std::erase(defines, "NOISE_BLEND");
    glUseProgram(m_shaders.program({.label = "shadow probe", .stages = {"../../tests/gl/support/shadow_probe.comp.glsl"},
                                    .defines = std::move(defines)}).id());
    glDispatchCompute((GLuint(points.size()) + kGroup - 1) / kGroup, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(buffers[2], 0, GLsizeiptr(lit.size() * sizeof(float)), lit.data());
    glUseProgram(0);
    glDeleteBuffers(GLsizei(buffers.size()), buffers.data());
    return lit;
}

int ShadowProbe::cascadeAt(const glm::dvec3& place) const
{
    const double away = glm::distance(place, m_eye.position);
    if (away > double(m_constants.fadeFrom)) return -1;
    for (std::size_t i = 0; i < m_cascades.size(); ++i)
        if (away <= m_cascades[i].end) return away < double(m_constants.cascade[i].blendFrom) ? int(i) : -1;
    return -1;
}

bool ShadowProbe::seen(const glm::dvec3& place) const
{
    const glm::dvec4 clip = m_eye.clipFromRelative * glm::dvec4{place - m_eye.position, 1};
    return clip.w > 0 && std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w;
}

std::vector<float> shadowMapDepths(int layer)
{
    constexpr std::string_view kLabel = "shadow maps";
    for (GLuint id = 1; id < 10000; ++id) {
        std::array<char, 64> label{};
        if (!glIsTexture(id)) continue;
        glGetObjectLabel(GL_TEXTURE, id, GLsizei(label.size()), nullptr, label.data());
        if (label.data() != kLabel) continue;
        GLint side = 0;
        glGetTextureLevelParameteriv(id, 0, GL_TEXTURE_WIDTH, &side);
        std::vector<float> depths(std::size_t(side) * side);
        glGetTextureSubImage(id, 0, 0, 0, layer, side, side, 1, GL_DEPTH_COMPONENT, GL_FLOAT, GLsizei(depths.size() * sizeof(float)), depths.data());
        return depths;
    }
    return {};
}

} // namespace test
