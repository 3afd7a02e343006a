// The nodes of a glTF file, flattened: which mesh stands where.
#pragma once

#include "io/files/gltf_accessors.h"

namespace io::gltf {

struct PlacedMesh {
    int mesh = 0;
    glm::dmat4 modelFromMesh{1};
};

// Of the default scene, instances of EXT_mesh_gpu_instancing one by one. Throws Refused when the nodes are no trees
// or name what is not there.
std::vector<PlacedMesh> placedMeshes(const tinygltf::Model& model, Accessors& accessors, Notes& notes);

} // namespace io::gltf
