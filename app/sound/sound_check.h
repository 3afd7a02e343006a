// Every sound that a scene names, opened: what `wold check` says of them.
#pragma once

#include "io/base/complaint.h"
#include "io/scene/scene.h"

#include <filesystem>

namespace app {

void checkSounds(const io::Scene& scene, const std::filesystem::path& project, io::Complaints& complaints);

} // namespace app
