#include "io/scene/camera.h"

#include <algorithm>
#include <cmath>

namespace io {

glm::dvec3 forward(const Camera& camera)
{
    const double yaw = glm::radians(double(camera.yaw));
    const double pitch = glm::radians(double(camera.pitch));
    return {-std::sin(yaw) * std::cos(pitch), std::sin(pitch), -std::cos(yaw) * std::cos(pitch)};
}

Camera lookingAt(Camera camera, const glm::dvec3& target)
{
    const glm::dvec3 to = target - camera.eye;
    const double flat = std::hypot(to.x, to.z);
    if (flat > 0) camera.yaw = float(glm::degrees(std::atan2(-to.x, -to.z)));
    if (flat > 0 || to.y != 0) camera.pitch = float(glm::degrees(std::atan2(to.y, flat)));
    return camera;
}

double duration(const CameraPath& path)
{
    return path.keys.empty() ? 0 : path.keys.back().time - path.keys.front().time;
}

double length(const CameraPath& path, std::size_t leg)
{
    constexpr int kPieces = 64;
    if (leg + 1 >= path.keys.size()) return 0;
    const double from = path.keys[leg].time - path.keys.front().time, span = path.keys[leg + 1].time - path.keys[leg].time;
    double sum = 0;
    glm::dvec3 last = path.keys[leg].eye;
    for (int i = 1; i <= kPieces; ++i) {
        const glm::dvec3 next = sample(path, from + span * i / kPieces).eye;
        sum += glm::distance(last, next);
        last = next;
    }
    return sum;
}

double length(const CameraPath& path)
{
    double sum = 0;
    for (std::size_t leg = 0; leg + 1 < path.keys.size(); ++leg)
        sum += length(path, leg);
    return sum;
}

Camera sample(const CameraPath& path, double seconds)
{
    if (path.keys.empty()) return {};
    const std::vector<PathKey>& keys = path.keys;
    const double time = std::clamp(seconds + keys.front().time, keys.front().time, keys.back().time);
    const auto after = std::upper_bound(keys.begin(), keys.end(), time,
                                        [](double t, const PathKey& key) { return t < key.time; });
    const int last = int(keys.size()) - 1;
    const int second = std::min(int(after - keys.begin()), last);
    const int first = std::max(second - 1, 0);
    const double span = keys[second].time - keys[first].time;
    const double t = span > 0 ? (time - keys[first].time) / span : 0;

    const auto smooth = [t](auto a, auto b, auto c, auto d) {
        return 0.5 * ((2.0 * b) + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * (t * t) +
                      (3.0 * b - a - 3.0 * c + d) * (t * t * t));
    };
    const PathKey& a = keys[std::max(first - 1, 0)];
    const PathKey& b = keys[first];
    const PathKey& c = keys[second];
    const PathKey& d = keys[std::min(second + 1, last)];
    const auto unwrapped = [&](float angle, float reference) {
        return double(reference) + std::remainder(double(angle) - double(reference), 360.0);
    };
    Camera camera;
    camera.eye = smooth(a.eye, b.eye, c.eye, d.eye);
    const double yawC = unwrapped(c.yaw, b.yaw);
    camera.yaw = float(smooth(unwrapped(a.yaw, b.yaw), double(b.yaw), yawC, unwrapped(d.yaw, float(yawC))));
    camera.pitch = float(smooth(double(a.pitch), double(b.pitch), double(c.pitch), double(d.pitch)));
    camera.fov = float(smooth(double(a.fov), double(b.fov), double(c.fov), double(d.fov)));
    return path.lookAt ? lookingAt(camera, path.target) : camera;
}

} // namespace io
