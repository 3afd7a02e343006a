// Every sound that a scene names, opened: what `wold check` says of them.
#pragma once

#include "io/base/complaint.h"
#include "io/scene/scene.h"

#include <filesystem>
#include <string>

namespace app {

// Where: the file of the project that names the sound, and the line that does. `sceneFile`: scenes/NAME.scene.json.
void checkSounds(const io::Scene& scene, const std::filesystem::path& project, const std::string& sceneFile, io::Complaints& complaints);

} // namespace app
