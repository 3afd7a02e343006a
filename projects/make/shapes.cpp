#include "projects/make/shapes.h"

#include "projects/make/noise.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

constexpr float kTurn = 6.2831853f;

struct Frame {
    glm::vec3 right{1, 0, 0}, forward{0, 0, 1};
};

// The frame of a ring: right kept as it was as far as the new direction allows (parallel transport).
Frame frameAlong(glm::vec3 direction, glm::vec3 right)
{
    right -= direction * glm::dot(direction, right);
    if (glm::dot(right, right) < 1e-8f) right = glm::cross(direction, {0.31f, 0.2f, 0.9f});
    right = glm::normalize(right);
    return {right, glm::cross(right, direction)};
}

glm::vec3 directionAt(std::span<const Ring> rings, std::size_t i)
{
    const glm::vec3 before = rings[i > 0 ? i - 1 : 0].centre;
    const glm::vec3 after = rings[std::min(i + 1, rings.size() - 1)].centre;
    return glm::normalize(after - before + glm::vec3{0, 1e-6f, 0});
}

float radiusAt(const Ring& ring, const TubeLook& look, int side, std::size_t index)
{
    const float angle = float(side) / float(look.sides);
    const float lobe = 0.5f + 0.5f * std::cos(kTurn * (angle * float(look.roots) + unitOf(look.seed)));
    const float uneven =
        noise(glm::vec2{std::cos(angle * kTurn), std::sin(angle * kTurn)} * 1.3f + float(index) * 0.37f, look.seed);
    return ring.radius * (1 + ring.flare * lobe) * (1 + look.wobble * uneven);
}

std::vector<io::Vertex> ringVertices(const Ring& ring, const Frame& frame, const TubeLook& look, std::size_t index,
                                     float v)
{
    std::vector<io::Vertex> vertices;
    for (int side = 0; side <= look.sides; ++side) {
        const float share = float(side) / float(look.sides);
        const int same = side % look.sides; // the seam's two vertices lie at one point
        const float angle = float(same) / float(look.sides) * kTurn;
        const glm::vec3 out = frame.right * std::cos(angle) + frame.forward * std::sin(angle) * look.flatten;
        vertices.push_back({.position = ring.centre + out * radiusAt(ring, look, same, index),
                            .normal = glm::normalize(out),
                            .uv0 = {share * look.around, v},
                            .colour = shade(ring.light)});
    }
    return vertices;
}

} // namespace

glm::u8vec4 shade(float light, glm::vec3 tint)
{
    return {glm::u8vec3{glm::round(glm::clamp(tint * light, 0.0f, 1.0f) * 255.0f)}, 255};
}

void addTube(Mesh& mesh, std::span<const Ring> rings, const TubeLook& look)
{
    std::vector<std::vector<io::Vertex>> loops;
    glm::vec3 right{1, 0, 0};
    float along = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        if (i > 0) along += glm::length(rings[i].centre - rings[i - 1].centre);
        const Frame frame = frameAlong(directionAt(rings, i), right);
        right = frame.right;
        loops.push_back(ringVertices(rings[i], frame, look, i, -along / look.metres));
    }
    for (std::size_t i = 0; i + 1 < loops.size(); ++i)
        for (std::size_t side = 0; side < std::size_t(look.sides); ++side) {
            const io::Vertex &a = loops[i][side], &b = loops[i][side + 1], &c = loops[i + 1][side + 1],
                             &d = loops[i + 1][side];
            if (look.pointed && i + 2 == loops.size()) {
                io::Vertex tip = d;
                tip.position = rings.back().centre;
                mesh.add({{a, tip, b}, look.surface});
            } else {
                mesh.addQuad({a, d, c, b}, look.surface);
            }
        }
}

std::vector<glm::vec3> rimOf(const Ring& before, const Ring& last, const TubeLook& look)
{
    const Frame frame = frameAlong(glm::normalize(last.centre - before.centre), {1, 0, 0});
    std::vector<glm::vec3> rim;
    for (const io::Vertex& vertex : ringVertices(last, frame, look, 1, 0))
        rim.push_back(vertex.position);
    rim.pop_back();
    return rim;
}

void addCap(Mesh& mesh, std::span<const glm::vec3> rim, int surface, float uvRadius)
{
    io::Vertex centre{.uv0 = glm::vec2{0.49f, 0.52f}};
    for (const glm::vec3& point : rim)
        centre.position += point / float(rim.size());
    const auto corner = [&](std::size_t i) {
        const float angle = float(i) / float(rim.size()) * kTurn;
        return io::Vertex{.position = rim[i % rim.size()],
                          .uv0 = centre.uv0 + uvRadius * glm::vec2{std::cos(angle), std::sin(angle)}};
    };
    for (std::size_t i = 0; i < rim.size(); ++i) {
        Triangle t{{centre, corner(i + 1), corner(i)}, surface};
        const glm::vec3 normal =
            glm::cross(t.corners[1].position - t.corners[0].position, t.corners[2].position - t.corners[0].position);
        for (io::Vertex& v : t.corners)
            v.normal = glm::dot(normal, normal) > 0 ? glm::normalize(normal) : glm::vec3{0, 1, 0};
        mesh.add(t);
    }
}

void addBeam(Mesh& mesh, const Beam& beam)
{
    const glm::vec3 along = beam.to - beam.from;
    const float length = glm::length(along);
    const glm::vec3 axis = along / length;
    const Frame frame = frameAlong(axis, glm::cross(beam.up, axis));
    const glm::vec3 x = frame.right * (beam.width / 2), y = frame.forward * (beam.height / 2);
    const float u0 = (float(beam.board % 4) + 0.06f) / 4, u1 = (float(beam.board % 4) + 0.94f) / 4;
    const float v0 = unitOf(hash(std::uint32_t(beam.board))), v1 = v0 + length / 1.6f;
    const auto face = [&](glm::vec3 centre, glm::vec3 across, glm::vec3 lengthwise, glm::vec2 uvLow, glm::vec2 uvHigh) {
        const glm::vec3 normal = glm::normalize(glm::cross(across, lengthwise));
        const auto corner = [&](float sx, float sy) {
            return io::Vertex{.position = centre + across * sx + lengthwise * sy,
                              .normal = normal,
                              .uv0 = {sx < 0 ? uvLow.x : uvHigh.x, sy < 0 ? uvLow.y : uvHigh.y},
                              .colour = shade(beam.light)};
        };
        mesh.addQuad({corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)}, beam.surface);
    };
    const glm::vec3 half = along * 0.5f, middle = beam.from + half;
    for (const float s : {-1.0f, 1.0f}) {
        face(middle + x * s, -y * s, half, {u0, v0}, {u1, v1});
        face(middle + y * s, x * s, half, {u0, v0}, {u1, v1});
        face(middle + half * s, y * s, x, {u0, v0}, {u1, v0 + 0.06f});
    }
}

std::array<io::Vertex, 4> cornersOf(const Card& card)
{
    const glm::vec3 normal = glm::normalize(glm::cross(card.right, card.up));
    const float left = card.mirrored ? 1.0f : 0.0f;
    const auto corner = [&](float x, float y, float lift, float u) {
        return io::Vertex{.position = card.base + card.right * x + card.up * y + card.bend * lift,
                          .normal = normal,
                          .uv0 = {u, 1 - y}};
    };
    return {corner(-1, 0, 1, left), corner(1, 0, -1, 1 - left), corner(1, 1, 1, 1 - left), corner(-1, 1, -1, left)};
}

} // namespace make
