#include "tests/projects/facing.h"

#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace tests {
namespace {

using Place = std::tuple<int, int, int>;

Place placeOf(const io::Vertex& v)
{
    const glm::ivec3 p{glm::round(v.position * 20000.0f)};
    return {p.x, p.y, p.z};
}

glm::dvec3 areaOf(const make::Triangle& t)
{
    const glm::dvec3 a{t.corners[0].position}, b{t.corners[1].position}, c{t.corners[2].position};
    return glm::cross(b - a, c - a) * 0.5;
}

std::size_t rootOf(std::vector<std::size_t>& parents, std::size_t i)
{
    while (parents[i] != i)
        i = parents[i] = parents[parents[i]];
    return i;
}

std::vector<std::vector<make::Triangle>> splitUp(const std::vector<make::Triangle>& triangles)
{
    std::vector<std::size_t> parents(triangles.size());
    std::iota(parents.begin(), parents.end(), 0u);
    std::map<Place, std::size_t> seen;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (const io::Vertex& corner : triangles[i].corners) {
            const auto [known, isNew] = seen.emplace(placeOf(corner), i);
            if (!isNew) parents[rootOf(parents, i)] = rootOf(parents, known->second);
        }
    std::map<std::size_t, std::vector<make::Triangle>> groups;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        groups[rootOf(parents, i)].push_back(triangles[i]);
    std::vector<std::vector<make::Triangle>> result;
    for (auto& [root, group] : groups)
        result.push_back(std::move(group));
    return result;
}

// Neighbours of one facing run along their common edge in opposite directions.
double turnedEdges(const std::vector<make::Triangle>& triangles)
{
    std::map<std::pair<Place, Place>, int> runs;
    for (const make::Triangle& t : triangles)
        for (std::size_t side = 0; side < 3; ++side)
            ++runs[{placeOf(t.corners[side]), placeOf(t.corners[(side + 1) % 3])}];
    int turned = 0, shared = 0;
    for (const auto& [edge, count] : runs) {
        const auto back = runs.find({edge.second, edge.first});
        const int returns = back == runs.end() ? 0 : back->second;
        turned += count == 2 && returns == 0;
        shared += count + returns == 2;
    }
    return shared > 0 ? double(turned) / shared : 0;
}

// Solid angle of a triangle seen from `p`, positive from behind it (van Oosterom & Strackee 1983).
double solidAngle(const make::Triangle& t, const glm::dvec3& p)
{
    const glm::dvec3 a = glm::dvec3{t.corners[0].position} - p, b = glm::dvec3{t.corners[1].position} - p,
                     c = glm::dvec3{t.corners[2].position} - p;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double below = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    return 2 * std::atan2(glm::dot(a, glm::cross(b, c)), below);
}

// The winding number (Jacobson 2013) on a surface is the mean of those before and behind it: a half where the front
// looks out of a closed piece, less near an opening, and below zero where the front looks in.
double turnedOver(const std::vector<make::Triangle>& triangles)
{
    const std::size_t step = 1 + triangles.size() / 300;
    double turned = 0, all = 0;
    for (std::size_t i = 0; i < triangles.size(); i += step) {
        const auto& corners = triangles[i].corners;
        const glm::dvec3 middle{(corners[0].position + corners[1].position + corners[2].position) / 3.0f};
        double angles = 0;
        for (std::size_t k = 0; k < triangles.size(); ++k)
            if (k != i) angles += solidAngle(triangles[k], middle);
        const double area = glm::length(areaOf(triangles[i]));
        turned += angles / 12.5663706 < -0.02 ? area : 0;
        all += area;
    }
    return all > 0 ? turned / all : 0;
}

Piece measured(const std::vector<make::Triangle>& triangles)
{
    Piece piece;
    glm::dvec3 middle{0}, sum{0};
    for (const make::Triangle& t : triangles) {
        const glm::dvec3 area = areaOf(t);
        const glm::vec3 normals = t.corners[0].normal + t.corners[1].normal + t.corners[2].normal;
        piece.area += glm::length(area);
        piece.agreeing += glm::dot(area, glm::dvec3{normals}) >= 0 ? glm::length(area) : 0;
        sum += area;
        for (const io::Vertex& corner : t.corners)
            middle += glm::dvec3{corner.position} * (glm::length(area) / 3);
    }
    if (piece.area == 0) return piece;
    middle /= piece.area;
    for (const make::Triangle& t : triangles)
        piece.volume += glm::dot(areaOf(t), glm::dvec3{t.corners[0].position} - middle) / 3;
    piece.opening = glm::length(sum) / piece.area;
    piece.agreeing /= piece.area;
    piece.turnedOver = turnedOver(triangles);
    piece.turnedEdges = turnedEdges(triangles);
    return piece;
}

} // namespace

std::vector<Piece> piecesOf(const make::Mesh& mesh)
{
    std::vector<make::Triangle> solid;
    for (const make::Triangle& t : mesh.triangles()) {
        const make::Surface& surface = mesh.surfaces()[std::size_t(t.surface)];
        if (!surface.leaves && !surface.twoSided) solid.push_back(t);
    }
    std::vector<Piece> pieces;
    for (const std::vector<make::Triangle>& group : splitUp(solid))
        pieces.push_back(measured(group));
    return pieces;
}

} // namespace tests
