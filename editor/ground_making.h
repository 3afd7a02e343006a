// Making of landscapes: noise gives the rough shape, rivers and sliding stones what a landscape is known by.
#pragma once

#include "editor/ground_recipe.h"
#include "io/base/progress.h"
#include "io/base/result.h"
#include "io/scene/height_grid.h"

namespace editor {

// Ground of that recipe, its middle at the world's origin. The same recipe makes the same bits, and one with fewer texels over the
// same metres the same landscape: it is made from coarse to fine, and a coarser one stops earlier. An error is a recipe that
// cannot be followed, or that the progress said to stop.
io::Result<io::HeightGrid> generateGround(const GroundRecipe& recipe, const io::Progress& progress = {});

} // namespace editor
