// glTF 2.0 (.gltf and .glb) to and from io::Model.
#pragma once

#include "io/base/complaint.h"
#include "io/base/result.h"
#include "io/scene/model.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace io {

// Flattens the default scene's nodes (EXT_mesh_gpu_instancing too) into one model. Files it names stay under `root`.
// A bad part (a texture, a material) is dropped with a warning; a file that cannot be trusted is refused by an error.
Result<Model> readModel(const std::filesystem::path& file, const std::filesystem::path& root, Complaints& complaints);

// The same of bytes that lie in memory; `file` is where they belong.
Result<Model> readModelBytes(std::string_view bytes, const std::filesystem::path& file,
                             const std::filesystem::path& root, Complaints& complaints);

// Binary glTF with its images embedded as PNG.
Result<std::string> encodeGlb(const Model& model);

} // namespace io
