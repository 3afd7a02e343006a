#include "renderer/thumbnails.h"

#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr unsigned kAllFeatures = kFeatureMask | kFeatureNormalMap | kFeatureSurfaceMaps | kFeatureWrap | kFeatureUvTransform |
                                  kFeatureSmoothColours;
constexpr float kFov = 28;   // degrees
constexpr float kYaw = 32;   // degrees, to the right of the model's front
constexpr float kPitch = -16;

// Even light from all around, more from above.
glsl::SkyLight studioSky()
{
    glsl::SkyLight sky{};
    sky.irradiance[0] = glm::vec4{0.42f / 0.282095f};
    sky.irradiance[1] = glm::vec4{0.16f / 0.488603f};
    return sky;
}

glsl::Light studioLight()
{
    glsl::Light light{};
    light.towardSun = glm::normalize(glm::vec3{-0.25f, 0.75f, 0.62f});
    light.ambient = 1;
    light.sunIrradiance = glm::vec3{2.1f, 2.05f, 1.95f};
    std::ranges::fill(light.sunAt, glm::vec4{light.sunIrradiance, 0});
    light.sunAbove = glm::vec3{1};
    light.sunSolidAngle = 0.015f; // a soft box, so that polished things show no glaring dot
    light.fogHeight = 1;
    return light;
}

io::Camera cameraFor(const ModelEntry& model)
{
    io::Camera camera{.yaw = kYaw, .pitch = kPitch, .fov = kFov};
    const double distance = std::max(double(model.radius), 0.01) * 1.04 / std::sin(glm::radians(kFov / 2.0));
    camera.eye = glm::dvec3{model.centre} - io::forward(camera) * std::max(distance, 2 * kNear);
    return camera;
}

// A model of a few centimetres is blown up, so that it stays clear of the near plane.
float scaleFor(const ModelEntry& model)
{
    return model.radius < 0.5f ? 0.5f / std::max(model.radius, 1e-6f) : 1.0f;
}

} // namespace

Thumbnails::Thumbnails(ShaderLibrary& shaders)
    : m_programs{shaders, "forward", {"FORWARD", "STUDIO"}, kAllFeatures}, m_backdrop{shaders.fullScreen("backdrop")},
      m_develop{shaders.fullScreen("thumbnail")}, m_objects{makeObjectVertexArray()},
      m_skyLight{"studio light", sizeof(glsl::SkyLight)}
{
    const glsl::SkyLight sky = studioSky();
    m_skyLight.write(0, std::as_bytes(std::span{&sky, 1}));
}

Picture Thumbnails::kept(io::TemplateId id, int pixels) const
{
    const auto found = m_kept.find(id);
    if (found == m_kept.end() || found->second.pixels != pixels) return {};
    return {.texture = found->second.texture.id(), .size = glm::ivec2{pixels}};
}

void Thumbnails::resize(int pixels)
{
    const glm::ivec2 size{pixels * 2};
    if (m_colour.size() == size) return;
    m_colour = gl::Texture{{.label = "studio", .size = size, .format = GL_RGBA16F, .filter = GL_NEAREST, .target = true}};
    m_depth = gl::Texture{{.label = "studio depth", .size = size, .format = GL_DEPTH_COMPONENT32F, .target = true}};
    m_framebuffer = gl::Framebuffer{{.label = "studio", .colours = {&m_colour}, .depth = &m_depth}};
}

Picture Thumbnails::make(GpuFrame& gpu, const World& world, io::TemplateId id, int pixels)
{
    const auto scope = gpu.scope("thumbnail");
    resize(pixels);
    const ModelRef found = world.modelOf(id);
    ModelEntry model = found ? found.entry() : ModelEntry{};
    const float scale = scaleFor(model);
    model.centre *= scale;
    model.radius *= scale;
    const Eye eye = eyeOf(cameraFor(model), m_colour.size());
    gpu.constants(VIEW_BINDING, viewBlock(eye, eye.clipFromRelative, 0, 0));
    gpu.constants(LIGHT_BINDING, studioLight());
    glBindBufferBase(GL_UNIFORM_BUFFER, SKY_LIGHT_BINDING, m_skyLight.id());

    const float ground = model.bounds.empty() ? 0.0f : model.bounds.min.y * scale;
    const glm::vec3 foot = glm::vec3{model.centre.x, ground, model.centre.z} - glm::vec3{eye.position};
    const glm::vec3 size = model.bounds.empty() ? glm::vec3{1} : model.bounds.size() * scale;
    m_framebuffer.clearDepth(0);
    m_framebuffer.bind();
    gpu.constants(PASS_BINDING, glm::vec4{foot, std::max(0.6f * std::max(size.x, size.z), 0.05f)});
    gpu.fullScreen(m_backdrop, {}, {});
    if (found) drawModel(gpu, world, id);

    Kept& kept = m_kept[id];
    kept.pixels = pixels;
    kept.texture = gl::Texture{{.label = "thumbnail", .size = glm::ivec2{pixels}}};
    const gl::Framebuffer target{{.label = "thumbnail", .colours = {&kept.texture}}};
    target.bind();
    gpu.fullScreen(m_develop, {}, {{IMAGE_UNIT, &m_colour}});
    return {.texture = kept.texture.id(), .size = glm::ivec2{pixels}};
}

void Thumbnails::drawModel(GpuFrame& gpu, const World& world, io::TemplateId id)
{
    Ghost only{.templateId = id};
    only.transform.scale = glm::vec3{scaleFor(world.modelOf(id).entry())};
    const std::vector<DrawList> lists = drawsOf(gpu, world, {&only, 1});
    const DrawList& list = lists.front();
    for (const std::span<const DrawRange> ranges : {std::span{list.opaque}, std::span{list.blended}})
        drawRanges(gpu, m_objects, list, ranges, [&](const DrawRange& range, const Batch& batch) {
            gl::apply({.depthTest = GL_GREATER,
                       .depthWrite = !batch.blend,
                       .cull = GLenum(batch.twoSided ? GL_NONE : GL_BACK),
                       .clockwise = range.mirrored,
                       .blend = batch.blend ? gl::Blend::Alpha : gl::Blend::None});
            bindArrays(gpu, *list.models, batch);
            return gpu.use(m_programs.of(batch));
        });
}

} // namespace renderer
