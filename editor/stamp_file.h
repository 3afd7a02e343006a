// Stamps: pictures whose brightness a brush presses into the ground.
#pragma once

#include "io/base/result.h"
#include "io/scene/height_grid.h"

#include <filesystem>
#include <memory>
#include <string>

namespace editor {

// The first channel of a picture of the project, 0..1. An error names a file that cannot be read, or that lies outside.
io::Result<std::shared_ptr<const io::HeightGrid>> readStamp(const std::filesystem::path& project, const std::string& file);

} // namespace editor
