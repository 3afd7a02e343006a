// The order in which a model's triangles and vertices are drawn fastest. What is drawn stays the same.
#pragma once

#include "io/scene/model.h"

namespace io {

// Blended parts keep the order of their triangles. Vertices that nothing uses go; those that only levels use come last.
// Returns the old number of each vertex.
std::vector<std::uint32_t> optimiseDrawOrder(Model& model);

// The vertices alone, in the order of their first use.
std::vector<std::uint32_t> renumberVertices(Model& model);

} // namespace io
