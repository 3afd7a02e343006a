// Levels of detail of a model, made by meshoptimizer and by thinning of foliage, kept on disk by what they were made of.
#pragma once

#include "io/scene/model.h"

#include <filesystem>

namespace io {

// Fills model.levels: coarser and coarser until hardly anything is left or gained; none for a small model. Puts the
// triangles and vertices of all levels, the full one too, into the order that draws fastest.
// What a level lacks or moved is no farther away than its error, in m; of foliage, looks no farther away.
void makeLevels(Model& model);

std::filesystem::path levelsFolder(); // in the cache folder

// The same from `folder` when it was done before, else done and put there. A folder that cannot be used is no error.
void addLevels(Model& model, const std::filesystem::path& folder = levelsFolder());

} // namespace io
