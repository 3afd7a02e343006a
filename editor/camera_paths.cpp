#include "editor/camera_paths.h"

#include <algorithm>

namespace editor {

std::vector<io::CameraPath> pathsOf(const io::Scene& scene)
{
    return {scene.paths().begin(), scene.paths().end()};
}

std::string freePathName(const io::Scene& scene, const std::string& stem)
{
    std::string name = stem;
    for (int i = 2; scene.findPath(name); ++i)
        name = stem + " " + std::to_string(i);
    return name;
}

void addKey(io::CameraPath& path, const io::Camera& camera)
{
    const double time = path.keys.empty() ? 0 : path.keys.back().time + std::max(glm::distance(path.keys.back().eye, camera.eye) / kPathSpeed, kShortestLeg);
    path.keys.push_back({.time = time, .eye = camera.eye, .yaw = camera.yaw, .pitch = camera.pitch, .fov = camera.fov});
}

void removeKey(io::CameraPath& path, std::size_t key)
{
    if (key < path.keys.size()) path.keys.erase(path.keys.begin() + std::ptrdiff_t(key));
}

void setKey(io::CameraPath& path, std::size_t key, const io::Camera& camera)
{
    if (key >= path.keys.size()) return;
    path.keys[key] = {.time = path.keys[key].time, .eye = camera.eye, .yaw = camera.yaw, .pitch = camera.pitch, .fov = camera.fov};
}

void setTime(io::CameraPath& path, std::size_t key, double seconds)
{
    if (key >= path.keys.size()) return;
    const double least = key == 0 ? 0 : path.keys[key - 1].time + kShortestLeg;
    const double by = std::max(seconds, least) - path.keys[key].time;
    for (std::size_t i = key; i < path.keys.size(); ++i)
        path.keys[i].time += by;
}

void setDuration(io::CameraPath& path, double seconds)
{
    const double before = io::duration(path);
    if (before <= 0) return;
    const double legs = double(path.keys.size() - 1), factor = std::max(seconds, kShortestLeg * legs) / before, first = path.keys.front().time;
    for (io::PathKey& key : path.keys)
        key.time = first + (key.time - first) * factor;
}

void setSpeed(io::CameraPath& path, double metresPerSecond)
{
    std::vector<double> legs; // before times change, which does not change the way
    for (std::size_t leg = 0; leg + 1 < path.keys.size(); ++leg)
        legs.push_back(io::length(path, leg));
    for (std::size_t leg = 0; leg < legs.size(); ++leg)
        path.keys[leg + 1].time = path.keys[leg].time + std::max(legs[leg] / std::max(metresPerSecond, 1e-3), kShortestLeg);
}

} // namespace editor
