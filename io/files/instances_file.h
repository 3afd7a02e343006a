// scenes/NAME.ID.scatter: the instances of one scatter layer, as docs/files.md says.
#pragma once

#include "io/base/result.h"
#include "io/scene/instances.h"

#include <string>
#include <string_view>

namespace io {

// Beside the scene's own file: "scenes/valley.scene.json" has "scenes/valley.3.scatter".
std::string instancesFile(std::string_view sceneFile, ScatterId layer);

std::string encodeInstances(const InstanceTiles& tiles);

struct ReadInstances {
    InstanceTiles tiles;
    std::size_t strangers = 0; // instances of species beyond `species`, left out
};
// Whole or not at all, whatever the bytes are. An error says what is wrong, without the file's name.
Result<ReadInstances> decodeInstances(std::string_view bytes, std::size_t species);

} // namespace io
