// Where things live: what Wold ships, what belongs to a person, and paths that may not leave a project.
#pragma once

#include "io/base/result.h"

#include <filesystem>
#include <string_view>

namespace io {

// Folders of a person (XDG base directories); made by whoever writes there first.
std::filesystem::path configFolder(); // $XDG_CONFIG_HOME/wold
std::filesystem::path stateFolder();  // $XDG_STATE_HOME/wold
std::filesystem::path cacheFolder();  // $XDG_CACHE_HOME/wold

// A file that ships with Wold, as "renderer/shaders/sky.frag.glsl", "app/lang/en.json" or "projects/valley":
// found in $WOLD_RESOURCES, in the source tree of this build, or in share/wold beside the installed program.
std::filesystem::path resource(std::string_view relative);

// A part of the program in a file of its own, as "wold_pictures.so": in this build, or in lib/wold beside the installed
// program.
std::filesystem::path programModule(std::string_view name);

// The file that a project's text names, as an absolute path. A relative path stays inside `root`;
// one that would leave it ("..", absolute, a link outward) is an error that names it. The file need not exist.
Result<std::filesystem::path> insideFolder(const std::filesystem::path& root, std::string_view relative);

} // namespace io
