// Normals and tangents where a model brings none.
#pragma once

#include "io/scene/model.h"

#include <vector>

namespace io {

struct ShadingFrames {
    std::vector<bool> needsNormal; // by vertex
    std::vector<bool> needsTangent;
};

// Fills what is needed: normals from the triangles around a vertex, weighted by their area; tangents along u of the
// texture coordinates that the part's normal map uses (Lengyel 2001).
void complete(Model& model, const ShadingFrames& frames);

// Sets `target` to the direction of `vector`, unless it has none.
bool setUnit(glm::vec3& target, const glm::vec3& vector);

} // namespace io
