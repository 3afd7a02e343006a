#include "editor/fly_camera.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

constexpr double kDegreesPerPixel = 0.15; // look
constexpr double kOrbitDegreesPerPixel = 0.3;
constexpr double kResponse = 0.07; // s, in which the speed closes 63 % of the gap to the wanted one
constexpr double kGlide = 0.25;    // s
constexpr double kFarthest = 1e7;  // m, of the eye from the world's origin
constexpr double kNearestFocus = 0.2, kFarthestFocus = 1e6; // m

glm::dvec3 rightOf(const io::Camera& camera)
{
    const double yaw = glm::radians(double(camera.yaw));
    return {std::cos(yaw), 0, -std::sin(yaw)};
}

} // namespace

void FlyCamera::setCamera(const io::Camera& camera)
{
    m_camera = camera;
    m_velocity = glm::dvec3{0};
    m_gliding = false;
    settle();
}

void FlyCamera::settle()
{
    for (int axis = 0; axis < 3; ++axis)
        m_camera.eye[axis] =
            std::isfinite(m_camera.eye[axis]) ? glm::clamp(m_camera.eye[axis], -kFarthest, kFarthest) : 0;
    m_camera.yaw = std::isfinite(m_camera.yaw) ? std::remainder(m_camera.yaw, 360.0f) : 0;
    m_camera.pitch = std::isfinite(m_camera.pitch) ? glm::clamp(m_camera.pitch, -89.0f, 89.0f) : 0;
    m_camera.fov = std::isfinite(m_camera.fov) ? glm::clamp(m_camera.fov, 1.0f, 170.0f) : 60;
}

void FlyCamera::look(glm::dvec2 pixels)
{
    m_gliding = false;
    m_camera.yaw -= float(pixels.x * kDegreesPerPixel);
    m_camera.pitch -= float(pixels.y * kDegreesPerPixel);
    settle();
}

void FlyCamera::fly(const glm::dvec3& keys, bool fast, double seconds)
{
    if (!(seconds > 0) || !std::isfinite(seconds)) return;
    const glm::dvec3 held = glm::clamp(keys, -1.0, 1.0);
    if (held != glm::dvec3{0}) m_gliding = false;
    const glm::dvec3 direction = rightOf(m_camera) * held.x + glm::dvec3{0, held.y, 0} + io::forward(m_camera) * held.z;
    const double length = glm::length(direction);
    const glm::dvec3 wanted =
        length > 0 ? direction / std::max(length, 1.0) * (m_speed * (fast ? kFast : 1)) : glm::dvec3{0};

    // v' = (wanted - v) / kResponse, solved exactly, so that the way does not depend on the frame rate.
    const double left = std::exp(-seconds / kResponse);
    m_camera.eye += wanted * seconds + (m_velocity - wanted) * (kResponse * (1 - left));
    m_velocity = wanted + (m_velocity - wanted) * left;
    if (wanted == glm::dvec3{0} && glm::length(m_velocity) < 1e-3 * m_speed) {
        m_camera.eye += m_velocity * kResponse; // all the way that is left
        m_velocity = glm::dvec3{0};
    }
    settle();
}

bool FlyCamera::moving() const
{
    return m_gliding || m_velocity != glm::dvec3{0};
}

void FlyCamera::changeSpeed(double steps)
{
    setSpeed(m_speed * std::pow(1.2, glm::clamp(steps, -100.0, 100.0)));
}

void FlyCamera::setSpeed(double metresPerSecond)
{
    if (std::isfinite(metresPerSecond)) m_speed = glm::clamp(metresPerSecond, kMinSpeed, kMaxSpeed);
}

glm::dvec3 FlyCamera::focus() const
{
    return m_camera.eye + io::forward(m_camera) * m_focusDistance;
}

void FlyCamera::focusOn(const glm::dvec3& point)
{
    // The focus stays on the line of sight, as far away as the point: orbiting then does not make the view jump.
    const double ahead = glm::dot(point - m_camera.eye, io::forward(m_camera));
    if (std::isfinite(ahead)) m_focusDistance = glm::clamp(ahead, kNearestFocus, kFarthestFocus);
}

void FlyCamera::orbit(glm::dvec2 pixels)
{
    m_gliding = false;
    const glm::dvec3 around = focus();
    m_camera.yaw -= float(pixels.x * kOrbitDegreesPerPixel);
    m_camera.pitch -= float(pixels.y * kOrbitDegreesPerPixel);
    settle();
    m_camera.eye = around - io::forward(m_camera) * m_focusDistance;
    settle();
}

void FlyCamera::pan(glm::dvec2 pixels, int viewHeight)
{
    m_gliding = false;
    const double metresPerPixel =
        2 * m_focusDistance * std::tan(glm::radians(double(m_camera.fov)) / 2) / std::max(viewHeight, 1);
    const glm::dvec3 right = rightOf(m_camera);
    const glm::dvec3 up = glm::cross(right, io::forward(m_camera));
    m_camera.eye += (up * pixels.y - right * pixels.x) * metresPerPixel;
    settle();
}

void FlyCamera::dolly(double steps)
{
    m_gliding = false;
    const glm::dvec3 towards = focus();
    m_focusDistance *= std::pow(0.9, glm::clamp(steps, -100.0, 100.0));
    m_focusDistance = glm::clamp(m_focusDistance, kNearestFocus, kFarthestFocus);
    m_camera.eye = towards - io::forward(m_camera) * m_focusDistance;
    settle();
}

void FlyCamera::frame(const io::WorldBox& box, double aspect, bool glide)
{
    if (box.empty() || !std::isfinite(glm::dot(box.min, box.max))) return;
    const double radius = std::max(glm::length(box.size()) / 2, 0.25);
    const double vertical = glm::radians(double(m_camera.fov)) / 2;
    const double horizontal = std::atan(std::tan(vertical) * std::max(aspect, 0.01));
    m_glideTo = box.centre();
    m_glideToDistance = glm::clamp(radius / std::sin(std::min(vertical, horizontal)), kNearestFocus, kFarthestFocus);
    m_glideFrom = focus();
    m_glideFromDistance = m_focusDistance;
    m_velocity = glm::dvec3{0};
    m_glideTime = glide ? 0 : kGlide;
    m_gliding = true;
    update(0);
}

void FlyCamera::update(double seconds)
{
    if (!m_gliding || !std::isfinite(seconds)) return;
    m_glideTime += std::max(seconds, 0.0);
    const double t = glm::smoothstep(0.0, 1.0, glm::clamp(m_glideTime / kGlide, 0.0, 1.0));
    m_focusDistance = glm::mix(m_glideFromDistance, m_glideToDistance, t);
    m_camera.eye = glm::mix(m_glideFrom, m_glideTo, t) - io::forward(m_camera) * m_focusDistance;
    m_gliding = m_glideTime < kGlide;
    settle();
}

} // namespace editor
