#include "projects/make/noise.h"
#include "projects/make/shapes.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

Mesh icosahedron(const Surface& surface)
{
    const float g = 1.618034f;
    const glm::vec3 p[12] = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                             {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    const int faces[20][3] = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                              {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                              {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    Mesh mesh;
    const int number = mesh.surface(surface);
    for (const auto& face : faces) {
        Triangle t{.surface = number};
        for (std::size_t i = 0; i < 3; ++i)
            t.corners[i].position = glm::normalize(p[face[i]]);
        mesh.add(t);
    }
    return mesh;
}

struct Cut {
    glm::vec3 normal;
    float distance;
};

std::vector<Cut> cutsOf(const Stone& stone)
{
    Random random{stone.seed};
    std::vector<Cut> cuts;
    for (int i = 0; i < stone.cuts; ++i)
        cuts.push_back({random.direction(), random.range(0.55f, 0.98f)});
    cuts.push_back({{0, -1, 0}, 0.62f}); // something to lie on
    return cuts;
}

// Radius of the cut and roughened sphere towards `direction`.
float radius(const Stone& stone, const std::vector<Cut>& cuts, glm::vec3 direction)
{
    float r = 1.05f;
    for (const Cut& cut : cuts) {
        const float towards = glm::dot(direction, cut.normal);
        if (towards > 0.05f) r = std::min(r, cut.distance / towards);
    }
    const auto seed = std::uint32_t(stone.seed);
    const float large = fbm(direction * 1.4f, seed, {.count = 2});
    const float small = fbm(direction * 4.2f, seed + 5, {.count = 3});
    return r * (1 + stone.roughness * (1.3f * large + small));
}

} // namespace

Mesh makeStone(const Stone& stone)
{
    Mesh mesh = icosahedron(stone.surface);
    const std::vector<Cut> cuts = cutsOf(stone);
    const auto toSurface = [&](io::Vertex& v) {
        const glm::vec3 direction = glm::normalize(v.position);
        v.position = direction * radius(stone, cuts, direction);
    };
    for (Triangle& t : mesh.triangles())
        for (io::Vertex& corner : t.corners)
            toSurface(corner);
    refineTo(mesh, stone.triangles, toSurface);
    for (Triangle& t : mesh.triangles())
        for (io::Vertex& corner : t.corners) {
            corner.colour =
                shade(glm::mix(0.55f, 1.0f, glm::smoothstep(-0.7f, 0.3f, corner.position.y))); // dark near the ground
            corner.position *= stone.size * 0.5f;
        }
    smoothNormals(mesh, stone.sharpness);
    projectTexture(mesh, stone.metres);
    float lowest = 0;
    for (const Triangle& t : mesh.triangles())
        for (const io::Vertex& corner : t.corners)
            lowest = std::min(lowest, corner.position.y);
    for (Triangle& t : mesh.triangles())
        for (io::Vertex& corner : t.corners)
            corner.position.y -= lowest; // the origin is where it touches the ground
    return mesh;
}

} // namespace make
