// The ground for other programs: its heights as a picture or as bare samples, and as a mesh.
#pragma once

#include "io/base/result.h"
#include "io/scene/cover_map.h"
#include "io/scene/height_map.h"
#include "io/scene/terrain.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace io {

struct HeightExport {
    std::vector<std::filesystem::path> written;
    bool metres = false;                 // floats; otherwise 16 bits between these:
    double minHeight = 0, maxHeight = 0; // m
};

bool exportsHeights(const std::filesystem::path& file); // by its name: .png .r16, 16 bits; .exr .tif .tiff .r32, metres as floats
bool exportsMesh(const std::filesystem::path& file);    // .glb .gltf

// 16 bits lie between the terrain's two heights, or farther apart where the ground needs it; those of a ground of floats, between
// its lowest and highest whole metre. Beside .r16 and .r32 a header of the same name (.hdr) tells their size and measures.
Result<HeightExport> exportHeights(const std::filesystem::path& file, const HeightMap& heights, const Terrain& terrain);

constexpr std::uint64_t kUsualTriangles = 2'000'000;
constexpr std::uint64_t kMostTriangles = 64'000'000; // 1 GiB

std::uint64_t meshTriangles(glm::ivec2 size, int step); // without holes
// The least power of two that makes no more than so many triangles.
int meshStep(glm::ivec2 size, std::uint64_t triangles = kUsualTriangles);

struct MeshExport {
    std::vector<std::filesystem::path> written;
    int step = 1; // texels from vertex to vertex
    int tiles = 0;
    std::uint64_t triangles = 0;
};
// glTF 2.0: a mesh and a node for each tile of 256 x 256 squares, with normals, and texture coordinates from 0 to 1 over the ground.
// World metres; holes are left out. `step` texels lie from vertex to vertex, and the last row and column are always there.
Result<MeshExport> exportTerrainMesh(const std::filesystem::path& file, const HeightMap& heights, const CoverMap* cover, const Terrain& terrain, int step);

} // namespace io
