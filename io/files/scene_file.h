// scenes/NAME.scene.json: one object a line, sorted by id, so that a moved object is a changed line.
#pragma once

#include "io/base/complaint.h"
#include "io/base/result.h"
#include "io/scene/scene.h"

#include <string>

namespace io {

// Reads objects, terrain and unknown keys into `scene`, whose templates are known, and answers the file that the
// scene names as its environment. Templates that the objects name and the scene lacks get an empty slot.
Result<std::string> readSceneText(std::string text, const std::string& name, Scene& scene, Complaints& complaints);
std::string sceneText(const Scene& scene, const std::string& environmentFile);
std::string sceneText(const Scene& scene, const std::string& environmentFile, const Terrain& terrain); // in place of the scene's own

} // namespace io
