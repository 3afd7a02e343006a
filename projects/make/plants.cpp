#include "projects/make/limbs.h"
#include "projects/make/trees.h"

#include <algorithm>
#include <cmath>

namespace make {

Mesh growShrub(const ShrubShape& shape)
{
    Mesh mesh;
    const int wood = mesh.surface({.texture = "charred", .tint = {1.0f, 0.8f, 0.6f}, .roughness = 0.9f});
    const int leaves = mesh.surface({.texture = shape.leaf, .tint = shape.leafTint, .roughness = 0.8f, .leaves = true});
    Random random{shape.seed};
    const glm::vec3 centre{0, shape.height * 0.42f, 0};
    const glm::vec3 radii{shape.radius, shape.height * 0.58f, shape.radius};
    for (int i = 0; i < 4; ++i) {
        const float azimuth = float(i) * 1.57f + random.bell();
        Limb stem =
            growLimb({.from = {0, -0.1f, 0},
                      .direction = glm::normalize(glm::vec3{std::cos(azimuth) * 0.6f, 1, std::sin(azimuth) * 0.6f}),
                      .length = shape.height * 0.7f,
                      .radius = 0.035f,
                      .tipRadius = 0.008f,
                      .rings = 3,
                      .gnarl = 0.3f},
                     random);
        for (Ring& ring : stem.rings)
            ring.light = 0.45f;
        addTube(mesh, stem.rings, {.sides = 3, .surface = wood, .pointed = true});
    }
    for (int i = 0; i < shape.cards; ++i) {
        const float y = 1 - 1.75f * (float(i) + 0.5f) / float(shape.cards); // few below
        const float azimuth = float(i) * 2.39996f;
        const float ring = std::sqrt(std::max(0.0f, 1 - y * y));
        const glm::vec3 towards{ring * std::cos(azimuth), y, ring * std::sin(azimuth)};
        const glm::vec3 at = centre + radii * towards * random.range(0.5f, 0.78f);
        const glm::vec3 facing = glm::normalize(towards + random.direction() * 0.5f);
        const glm::vec3 growth = towards * 0.6f + glm::vec3{0, 0.9f, 0} + random.direction() * 0.4f;
        const glm::vec3 up = glm::normalize(growth - facing * glm::dot(growth, facing) + glm::vec3{0, 1e-3f, 0});
        const float size = shape.cardSize * random.range(0.8f, 1.2f);
        std::array<io::Vertex, 4> corners = cornersOf({.base = at - up * (size * 0.5f),
                                                       .up = up * size,
                                                       .right = glm::cross(up, facing) * (size * 0.5f),
                                                       .bend = facing * (size * random.range(-0.1f, 0.1f)),
                                                       .mirrored = random.chance(0.5f)});
        const float tone = random.range(0.82f, 1.0f);
        for (io::Vertex& corner : corners) {
            const glm::vec3 out = (corner.position - centre) / radii;
            corner.normal = glm::normalize(out + glm::vec3{0, 0.35f, 0});
            const float height = glm::smoothstep(-0.1f, shape.height * 0.8f, corner.position.y);
            corner.colour = shade(tone * glm::mix(0.42f, 1.0f, height) *
                                  glm::mix(0.6f, 1.0f, glm::smoothstep(0.4f, 1.0f, glm::length(out))));
        }
        mesh.addQuad(corners, leaves);
    }
    smoothNormals(mesh, 80, wood);
    return mesh;
}

Mesh growFern(std::uint64_t seed, int fronds, float length)
{
    Mesh mesh;
    const int surface = mesh.surface({.texture = "leaf_fern", .roughness = 0.8f, .leaves = true});
    Random random{seed};
    for (int i = 0; i < fronds; ++i) {
        const float azimuth = float(i) * 2.39996f + random.bell() * 0.4f;
        const glm::vec3 out{std::cos(azimuth), 0, std::sin(azimuth)};
        const glm::vec3 side = glm::vec3{-out.z, 0, out.x} * (length * 0.21f);
        const float reach = length * random.range(0.8f, 1.1f);
        // A frond rises and then bows: two quads.
        const glm::vec3 points[] = {{0, -0.02f, 0},
                                    out * (reach * 0.42f) + glm::vec3{0, reach * 0.56f, 0},
                                    out * (reach * 0.98f) + glm::vec3{0, reach * random.range(0.36f, 0.52f), 0}};
        for (int k = 0; k < 2; ++k) {
            const auto corner = [&](int end, float across) {
                const glm::vec3 p = points[k + end] + side * across;
                return io::Vertex{.position = p,
                                  .normal = glm::normalize(glm::vec3{0, 1, 0} + out * 0.35f),
                                  .uv0 = {0.5f + across * 0.5f, 1 - 0.5f * float(k + end)},
                                  .colour = shade(glm::mix(0.45f, 1.0f, float(k + end) / 2))};
            };
            mesh.addQuad({corner(0, -1), corner(0, 1), corner(1, 1), corner(1, -1)}, surface);
        }
    }
    return mesh;
}

Mesh growTuft(std::uint64_t seed, const std::string& leaf, int cards, glm::vec2 size)
{
    Mesh mesh;
    const int surface = mesh.surface({.texture = leaf, .roughness = 0.85f, .leaves = true});
    Random random{seed};
    for (int i = 0; i < cards; ++i) {
        const float azimuth = (float(i) + random.unit() * 0.5f) * 3.14159f / float(cards);
        const glm::vec3 right =
            glm::vec3{std::cos(azimuth), 0, std::sin(azimuth)} * (size.x * 0.5f * random.range(0.85f, 1.15f));
        const glm::vec3 shift = glm::vec3{random.bell(), 0, random.bell()} * (size.x * 0.15f);
        const glm::vec3 lean = glm::vec3{random.bell(), 0, random.bell()} * (size.y * 0.25f);
        std::array<io::Vertex, 4> corners = cornersOf({.base = shift - glm::vec3{0, 0.03f, 0},
                                                       .up = glm::vec3{0, size.y * random.range(0.85f, 1.1f), 0} + lean,
                                                       .right = right,
                                                       .mirrored = random.chance(0.5f)});
        for (io::Vertex& corner : corners) {
            corner.normal = glm::normalize(glm::vec3{corner.position.x, 0, corner.position.z} * 0.25f / size.x +
                                           glm::vec3{0, 1, 0});
            corner.colour = shade(corner.position.y > size.y * 0.4f ? 1.0f : 0.62f);
        }
        mesh.addQuad(corners, surface);
    }
    return mesh;
}

} // namespace make
