#include "renderer/debug_lines.h"

#include "renderer/shaders/shared/shadows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace renderer {
namespace {

constexpr glm::vec4 kFrustum{1, 0.72f, 0.2f, 0.95f}; // sRGB
constexpr float kBehind = 0.3f;                      // of the opacity, where something stands before it
constexpr float kUnreached = 0.25f;                  // the same, of nodes that frozen culling does not reach
constexpr double kShortest = 10, kLongest = 20000;   // m, of a view's edges

constexpr double kSmallest = 0.02;      // diagonal / distance of a node that is shown
constexpr std::size_t kMostNodes = 600; // shown at once

using Corners = std::array<glm::dvec3, 4>;

Corners cornersAt(const Eye& eye, double distance)
{
    const glm::dvec3 right = eye.right * (eye.tanHalfFov * eye.aspect * distance), up = eye.up * (eye.tanHalfFov * distance);
    const glm::dvec3 middle = eye.position + eye.forward * distance;
    return {middle - right - up, middle + right - up, middle + right + up, middle - right + up};
}

// How far along its direction an eye has anything of a box before it.
double reachOf(const Eye& eye, const io::WorldBox& box)
{
    const glm::dvec3 farthest = glm::mix(box.min, box.max, glm::greaterThan(eye.forward, glm::dvec3{0}));
    const double along = box.empty() ? 0 : glm::dot(farthest - eye.position, eye.forward);
    return std::clamp(along, kShortest, kLongest);
}

struct ShownNode {
    io::WorldBox box;
    double size = 0; // diagonal / distance
    int depth = 0;
    bool leaf = false, splitsInHeight = false;
};

bool touches(const io::Box& box, const Volume& volume)
{
    return std::ranges::none_of(volume.planes, [&](const glm::dvec4& p) { return io::sideOf(box, p) == io::Side::Outside; });
}

// A node below another looks no larger, so what is too small ends the way down.
void collect(std::vector<ShownNode>& nodes, const InstanceTree& tree, const Eye& eye)
{
    const Volume volume = volumeOf(eye);
    tree.preOrder([&](const InstanceTree::Node& node) {
        const io::WorldBox box{glm::dvec3{node.box.min}, glm::dvec3{node.box.max}};
        const double size = glm::length(box.size()) / std::max(io::distance(node.box, eye.position), 1e-3);
        if (size < kSmallest || !touches(node.box, volume)) return false;
        nodes.push_back({box, size, node.depth, node.leaf, node.children == 2 || node.children == 8});
        return true;
    });
}

glm::vec3 colourOf(int depth) // as the levels of detail have them
{
    return 0.5f + 0.5f * glm::cos(6.2831853f * (float(depth) * 0.17f + glm::vec3{0.3f, 0.63f, 0.97f}));
}

// Faint where something stands before it.
void addSeenThrough(std::vector<Line>& lines, const glm::dvec3& from, const glm::dvec3& to, const glm::vec4& colour)
{
    lines.push_back({.from = from, .to = to, .colour = colour});
    lines.push_back({.from = from, .to = to, .colour = {glm::vec3{colour}, colour.a * kBehind}, .onTop = true});
}

void addRing(std::vector<Line>& lines, const io::WorldBox& box, const glm::vec4& colour)
{
    const double y = box.centre().y;
    const Corners corners{{{box.min.x, y, box.min.z}, {box.max.x, y, box.min.z}, {box.max.x, y, box.max.z}, {box.min.x, y, box.max.z}}};
    for (std::size_t i = 0; i < corners.size(); ++i)
        lines.push_back({.from = corners[i], .to = corners[(i + 1) % corners.size()], .colour = colour});
}

// Around a middle, through the ends of two radii.
void addCircle(std::vector<Line>& lines, const glm::dvec3& middle, const glm::dvec3& u, const glm::dvec3& v, const glm::vec4& colour)
{
    constexpr int kSegments = 48;
    const auto at = [&](int i) {
        const double angle = 2 * std::numbers::pi * i / kSegments;
        return middle + u * std::cos(angle) + v * std::sin(angle);
    };
    for (int i = 0; i < kSegments; ++i)
        lines.push_back({.from = at(i), .to = at(i + 1), .colour = colour});
}

} // namespace

void addBox(std::vector<Line>& lines, const io::WorldBox& box, const glm::vec4& colour)
{
    const glm::dvec3 half = box.size() / 2.0;
    addBox(lines, box.centre(), {{half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}}, colour);
}

void addBox(std::vector<Line>& lines, const glm::dvec3& middle, const glm::dmat3& halfAxes, const glm::vec4& colour)
{
    const auto corner = [&](int i) { return middle + halfAxes * glm::dvec3{i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1}; };
    for (int i = 0; i < 8; ++i)
        for (const int bit : {1, 2, 4})
            if (!(i & bit)) lines.push_back({.from = corner(i), .to = corner(i | bit), .colour = colour});
}

void addSphere(std::vector<Line>& lines, const glm::dvec3& middle, double radius, const glm::vec4& colour)
{
    const glm::dvec3 x{radius, 0, 0}, y{0, radius, 0}, z{0, 0, radius};
    addCircle(lines, middle, x, y, colour);
    addCircle(lines, middle, y, z, colour);
    addCircle(lines, middle, z, x, colour);
}

void addLamp(std::vector<Line>& lines, const Lamp& lamp, const glm::vec4& colour)
{
    const double range = lamp.range;
    if (!lamp.isSpot()) return addSphere(lines, lamp.place, range, colour);
    const glm::dvec3 forward{lamp.direction};
    const glm::dvec3 aside = std::abs(forward.y) > 0.9 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    const glm::dvec3 u = glm::normalize(glm::cross(forward, aside)), v = glm::cross(u, forward);
    for (const double angle : {double(lamp.inner), double(lamp.outer)}) {
        const glm::dvec3 middle = lamp.place + forward * (range * std::cos(angle));
        const double radius = range * std::sin(angle);
        addCircle(lines, middle, u * radius, v * radius, colour);
        if (angle != double(lamp.outer)) continue;
        for (const glm::dvec3& side : {u, -u, v, -v})
            lines.push_back({.from = lamp.place, .to = middle + side * radius, .colour = colour});
    }
}

void addFrustum(std::vector<Line>& lines, const Eye& eye, const io::WorldBox& world)
{
    const double reach = reachOf(eye, world);
    const auto add = [&](const glm::dvec3& from, const glm::dvec3& to) { addSeenThrough(lines, from, to, kFrustum); };
    const auto frame = [&](double distance) {
        const Corners corners = cornersAt(eye, distance);
        for (std::size_t i = 0; i < corners.size(); ++i)
            add(corners[i], corners[(i + 1) % corners.size()]);
    };
    for (const glm::dvec3& corner : cornersAt(eye, reach))
        add(eye.position, corner);
    for (double distance = 1; distance < reach; distance *= 10)
        frame(distance);
    frame(reach);
}

void addNodes(std::vector<Line>& lines, std::span<const InstanceTree* const> trees, const Eye& eye,
              const std::optional<Volume>& culledTo)
{
    std::vector<ShownNode> nodes;
    for (const InstanceTree* tree : trees)
        collect(nodes, *tree, eye);
    if (nodes.size() > kMostNodes) {
        const auto last = nodes.begin() + std::ptrdiff_t(kMostNodes);
        std::ranges::nth_element(nodes, last, std::greater{}, &ShownNode::size);
        nodes.erase(last, nodes.end());
    }
    for (const ShownNode& node : nodes) {
        const bool reached = !culledTo || touches(io::roundedOutwards(node.box), *culledTo);
        const glm::vec4 colour{colourOf(node.depth), (node.leaf ? 0.9f : 0.4f) * (reached ? 1 : kUnreached)};
        addBox(lines, node.box, colour);
        if (node.splitsInHeight) addRing(lines, node.box, colour);
    }
}

void addCascades(std::vector<Line>& lines, std::span<const Cascade> cascades, const Eye& eye, const glm::dvec3& towardSun, bool strong)
{
    const glm::dmat3 worldFromLight = glm::transpose(lightAxes(towardSun));
    for (std::size_t i = 0; i < cascades.size(); ++i) {
        const Cascade& c = cascades[i];
        const glm::vec4 colour{glsl::cascadeTint(int(i)), strong ? 0.95f : kUnreached};
        const glm::dvec3 low{glm::dvec2{c.low} * c.texel, c.bottom};
        const glm::dvec3 high{glm::dvec2{c.window().high} * c.texel, c.bottom + c.depthRange - c.contactReach};
        const auto corner = [&](int of) { return worldFromLight * glm::dvec3{of & 1 ? high.x : low.x, of & 2 ? high.y : low.y, of & 4 ? high.z : low.z}; };
        for (int of = 0; of < 8; ++of)
            for (const int bit : {1, 2, 4})
                if (!(of & bit)) addSeenThrough(lines, corner(of), corner(of | bit), colour);
        const double slope = std::hypot(1.0, eye.tanHalfFov, eye.tanHalfFov * eye.aspect);
        const Corners slice = cornersAt(eye, c.end / slope); // corners lie at the distance at which the slice ends
        for (std::size_t k = 0; k < slice.size(); ++k)
            addSeenThrough(lines, slice[k], slice[(k + 1) % slice.size()], colour);
    }
}

} // namespace renderer
