#include "editor/sound_shape.h"

#include "io/scene/falloff.h"
#include "io/scene/transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace editor {
namespace {

constexpr double kCurveHeight = 0.3; // of the radius
constexpr double kReach = 9;         // pixels around a handle that hit it
constexpr float kSteep = 50;         // degrees of pitch, from which the curve lies on the ground instead of standing on it
constexpr float kLeastRadius = 0.1f, kMostRadius = 1e6f; // m, as files may have it

// Where the pixel's ray meets the plane of the curve: share of the radius and level.
std::optional<glm::dvec2> onPlane(const View& view, const SoundFrame& frame, glm::dvec2 pixel)
{
    const io::Ray ray = rayThrough(view, pixel);
    const glm::dvec3 normal = glm::cross(frame.along, frame.up);
    const double facing = glm::dot(ray.direction, normal);
    if (std::abs(facing) < 1e-4) return {};
    const double distance = glm::dot(frame.middle - ray.origin, normal) / facing;
    if (!(distance > 0)) return {};
    const glm::dvec3 from = ray.origin + ray.direction * distance - frame.middle;
    return glm::dvec2{glm::dot(from, frame.along) / frame.radius, glm::dot(from, frame.up) / (frame.radius * kCurveHeight)};
}

} // namespace

glm::dvec3 SoundFrame::at(double share, double level) const
{
    return middle + along * (share * radius) + up * (level * radius * kCurveHeight);
}

glm::dvec3 soundPlace(const io::Object& object, const io::SoundSource& sound)
{
    return object.transform.position + glm::dvec3{io::linearPart(object.transform) * sound.offset};
}

SoundFrame soundFrame(const View& view, const io::Object& object, const io::SoundSource& sound)
{
    const double yaw = double(view.camera.yaw) * std::numbers::pi / 180;
    const glm::dvec3 forward{-std::sin(yaw), 0, -std::cos(yaw)};
    const bool lies = std::abs(view.camera.pitch) > kSteep;
    return {.middle = soundPlace(object, sound), .along = glm::cross(forward, glm::dvec3{0, 1, 0}), .up = lies ? forward : glm::dvec3{0, 1, 0}, .radius = double(sound.radius)};
}

std::vector<SoundMark> soundMarks(const View& view, const SoundFrame& frame, const io::SoundSource& sound)
{
    std::vector<SoundMark> marks;
    const auto add = [&](const SoundHandle& handle, const glm::dvec3& at) {
        if (const auto pixel = project(view, at)) marks.push_back({handle, *pixel});
    };
    for (std::size_t i = 0; i < sound.falloff.size(); ++i)
        add({SoundHandle::Kind::Key, i}, frame.at(sound.falloff[i].at, sound.falloff[i].level));
    for (const double side : {1.0, -1.0})
        add({SoundHandle::Kind::Radius}, frame.at(side, 0));
    return marks;
}

// The nearest; of two as near, the later, which lies over the other.
SoundHandle soundHandleAt(std::span<const SoundMark> marks, glm::dvec2 pixel)
{
    SoundHandle best;
    double nearest = kReach;
    for (const SoundMark& mark : marks)
        if (const double distance = glm::distance(mark.pixel, pixel); distance <= nearest) nearest = distance, best = mark.handle;
    return best;
}

std::vector<glm::dvec2> soundCurve(const View& view, const SoundFrame& frame, const io::SoundSource& sound)
{
    constexpr int kSegments = 64;
    std::vector<glm::dvec2> points;
    for (int i = 0; i <= kSegments; ++i) {
        const float share = float(i) / kSegments;
        const auto pixel = project(view, frame.at(share, io::falloffAt(sound.falloff, share)));
        if (!pixel) break;
        points.push_back(*pixel);
    }
    return points;
}

io::SoundSource soundDragged(const View& view, const SoundFrame& frame, io::SoundSource sound, const SoundHandle& handle, glm::dvec2 pixel, double step)
{
    const auto at = onPlane(view, frame, pixel);
    if (!at) return sound;
    if (handle.kind == SoundHandle::Kind::Key)
        io::moveFalloffKey(sound.falloff, handle.key, {std::clamp(float(at->x), 0.0f, 1.0f), std::clamp(float(at->y), 0.0f, 1.0f)});
    if (handle.kind == SoundHandle::Kind::Radius) {
        double radius = std::abs(at->x) * frame.radius;
        if (step > 0) radius = std::max(std::round(radius / step), 1.0) * step;
        sound.radius = std::clamp(float(std::round(radius * 100) / 100), kLeastRadius, kMostRadius); // to a centimetre
    }
    return sound;
}

} // namespace editor
