// Editing camera paths: whole new paths, for the caller to make a step of.
#pragma once

#include "io/scene/camera.h"
#include "io/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace editor {

constexpr double kPathSpeed = 8;     // m/s, of a leg that is added
constexpr double kShortestLeg = 0.1; // s

std::vector<io::CameraPath> pathsOf(const io::Scene& scene);
std::string freePathName(const io::Scene& scene, const std::string& stem); // "Path", "Path 2"

void addKey(io::CameraPath& path, const io::Camera& camera);    // after the last, as late as kPathSpeed makes it
void removeKey(io::CameraPath& path, std::size_t key);          // what follows keeps its times
void setKey(io::CameraPath& path, std::size_t key, const io::Camera& camera); // keeps its time
void setTime(io::CameraPath& path, std::size_t key, double seconds); // what follows is moved along; times go on rising
void setDuration(io::CameraPath& path, double seconds);         // all of it stretched
void setSpeed(io::CameraPath& path, double metresPerSecond);    // the same along all legs

} // namespace editor
