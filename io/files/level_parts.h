// The pieces of which levels of detail are made: triangles of a model by part, and what hangs together in them.
#pragma once

#include "io/files/surface_distance.h"
#include "io/scene/model.h"

#include <cstdint>
#include <span>
#include <vector>

namespace io::levels {

// A triangle of one part; the corners index Model::vertices.
struct Corners {
    std::array<std::uint32_t, 3> vertex;
    std::uint32_t part = 0;
};

// Part of a level in the making.
struct Piece {
    std::vector<Corners> triangles; // parts rising, within a part in the model's order
    float error = 0;                // m
};

SurfaceDistance::Triangle positionsOf(const Model& model, const Corners& corners);
float areaOf(const SurfaceDistance::Triangle& triangle);

// The part's triangles that can be seen: finite corners and an area.
std::vector<Corners> drawnTriangles(const Model& model, std::uint32_t part);

// Vertices at one position share a number, counted from 0.
std::vector<std::uint32_t> placesOf(const Model& model);

enum class Joined { AtEdges, AtVertices }; // triangles that share an edge, or already one corner
// For each triangle the number of the connected component that holds it, counted from 0 in order of appearance.
std::vector<std::uint32_t> componentsOf(std::span<const Corners> triangles, std::span<const std::uint32_t> places,
                                        Joined joined);

} // namespace io::levels
