#include "renderer/eye.h"

#include "renderer/shaders/shared/wind.h"

#include <cmath>

namespace renderer {
namespace {

struct Axes {
    glm::dvec3 right, up, forward;
};

// Straight up and down keep the yaw, so that the picture does not spin there.
Axes axesOf(const io::Camera& camera)
{
    const double yaw = glm::radians(double(camera.yaw));
    const double pitch = glm::radians(double(camera.pitch));
    const glm::dvec3 right{std::cos(yaw), 0, -std::sin(yaw)};
    const glm::dvec3 forward{-std::sin(yaw) * std::cos(pitch), std::sin(pitch), -std::cos(yaw) * std::cos(pitch)};
    return {right, glm::cross(right, forward), forward};
}

double tanHalf(const io::Camera& camera)
{
    return std::tan(glm::radians(glm::clamp(double(camera.fov), 1.0, 170.0)) / 2);
}

glm::vec3 high(const glm::dvec3& v)
{
    return glm::vec3{v};
}

} // namespace

glm::dmat4 viewFromRelative(const io::Camera& camera)
{
    const Axes axes = axesOf(camera);
    glm::dmat4 view{1};
    for (int axis = 0; axis < 3; ++axis)
        view[axis] = glm::dvec4{axes.right[axis], axes.up[axis], -axes.forward[axis], 0};
    return view;
}

// Reversed depth without a far plane: depth = near / distance.
glm::dmat4 clipFromView(const io::Camera& camera, double aspect)
{
    const double scale = 1 / tanHalf(camera);
    glm::dmat4 clip{0};
    clip[0][0] = scale / aspect;
    clip[1][1] = scale;
    clip[2][3] = -1;
    clip[3][2] = kNear;
    return clip;
}

io::Ray rayThrough(const io::Camera& camera, glm::ivec2 size, glm::dvec2 pixel)
{
    const Axes axes = axesOf(camera);
    const glm::dvec2 extent{glm::max(size, glm::ivec2{1})};
    const glm::dvec2 ndc = pixel / extent * 2.0 - 1.0;
    const double t = tanHalf(camera);
    const glm::dvec3 direction = axes.forward + axes.right * (ndc.x * t * extent.x / extent.y) - axes.up * (ndc.y * t);
    return {.origin = camera.eye, .direction = glm::normalize(direction)};
}

std::optional<glm::dvec2> project(const io::Camera& camera, glm::ivec2 size, const glm::dvec3& world)
{
    const Axes axes = axesOf(camera);
    const glm::dvec2 extent{glm::max(size, glm::ivec2{1})};
    const glm::dvec3 relative = world - camera.eye;
    const double depth = glm::dot(relative, axes.forward);
    if (depth < kNear) return std::nullopt;
    const double t = tanHalf(camera) * depth;
    const glm::dvec2 ndc{glm::dot(relative, axes.right) / (t * extent.x / extent.y), -glm::dot(relative, axes.up) / t};
    return (ndc * 0.5 + 0.5) * extent;
}

Eye eyeOf(const io::Camera& camera, glm::ivec2 size)
{
    const Axes axes = axesOf(camera);
    const double aspect = double(size.x) / size.y;
    return {.position = camera.eye,
            .clipFromRelative = clipFromView(camera, aspect) * viewFromRelative(camera),
            .forward = axes.forward,
            .right = axes.right,
            .up = axes.up,
            .tanHalfFov = tanHalf(camera),
            .aspect = aspect,
            .size = size};
}

double pixelAngle(const Eye& eye)
{
    return 2 * eye.tanHalfFov / eye.size.y;
}

glsl::View viewBlock(const Eye& eye, const glm::dmat4& clipFromRelative, double time, double exposure)
{
    glsl::View view{};
    view.clipFromRelative = glm::mat4{clipFromRelative};
    view.eyeHigh = high(eye.position);
    view.eyeLow = glm::vec3{eye.position - glm::dvec3{view.eyeHigh}};
    view.eyeHeight = float(eye.position.y);
    view.time = float(std::fmod(time, double(WIND_PERIOD)));
    view.near = float(kNear);
    view.forward = glm::vec3{eye.forward};
    view.right = glm::vec3{eye.right * (eye.tanHalfFov * eye.aspect)};
    view.up = glm::vec3{eye.up * eye.tanHalfFov};
    view.exposure = float(std::exp2(exposure));
    view.pixelAngle = float(pixelAngle(eye));
    view.size = eye.size;
    view.texel = 1.0f / glm::vec2{eye.size};
    return view;
}

glsl::View movedAside(glsl::View view, const Eye& eye, const glm::dvec2& by)
{
    glm::dmat4 clip = eye.clipFromRelative;
    for (int column = 0; column < 4; ++column) // by the same share of the picture, however far away
        clip[column] += glm::dvec4{by * clip[column].w, 0, 0};
    view.clipFromRelative = glm::mat4{clip};
    view.jitter = glm::vec2{by};
    return view;
}

Volume volumeOf(const Eye& eye)
{
    const auto through = [&](const glm::dvec3& normal, double offset = 0) {
        const glm::dvec3 n = glm::normalize(normal);
        return glm::dvec4{n, -glm::dot(n, eye.position) - offset};
    };
    const double y = eye.tanHalfFov;
    const double x = y * eye.aspect;
    return {{through(eye.forward * x + eye.right), through(eye.forward * x - eye.right),
             through(eye.forward * y + eye.up), through(eye.forward * y - eye.up), through(eye.forward, kNear)}};
}

} // namespace renderer
