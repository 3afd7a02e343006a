// Triangles of glTF meshes, baked into one model.
#pragma once

#include "io/files/gltf_materials.h"
#include "io/files/gltf_nodes.h"

namespace io::gltf {

// Bakes every placed mesh into `result`: parts by material, normals and tangents made where there are none, bounds
// from the data. Throws Refused for data that cannot be trusted or is over 2 GiB.
void bake(const tinygltf::Model& source, const std::vector<PlacedMesh>& placed, Accessors& accessors,
          Materials& materials, Notes& notes, Model& result);

} // namespace io::gltf
