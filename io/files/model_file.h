// glTF 2.0 (.gltf and .glb) to and from io::Model.
#pragma once

#include "io/base/complaint.h"
#include "io/base/result.h"
#include "io/scene/model.h"

#include <filesystem>

namespace io {

// Flattens the default scene's nodes (EXT_mesh_gpu_instancing too) into one model. Files it names stay under `root`.
// A bad part (a texture, a material) is dropped with a warning; a file that cannot be trusted is refused by an error.
Result<Model> readModel(const std::filesystem::path& file, const std::filesystem::path& root, Complaints& complaints);

// Binary glTF with its images embedded as PNG.
Result<std::string> encodeGlb(const Model& model);

} // namespace io
