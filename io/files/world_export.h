// A whole world as one glTF file.
#pragma once

#include "io/base/result.h"
#include "io/scene/assets.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace io {

struct WorldExport {
    std::vector<std::filesystem::path> written;
    std::uint64_t models = 0, instances = 0;
    std::uint64_t groundTriangles = 0;
    std::uint64_t leftOut = 0; // objects without a model: markers
    int step = 0;              // texels from vertex to vertex of the ground; 0: there is none
};

// .glb or .gltf: the ground as exportTerrainMesh() writes it (`step` 0: its usual one), and each model once with all its copies
// (EXT_mesh_gpu_instancing), at full detail. Groups, markers, cameras and light are left out.
Result<WorldExport> exportWorld(const std::filesystem::path& file, const Scene& scene, const Assets& assets, int step);

} // namespace io
