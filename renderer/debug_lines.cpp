#include "renderer/debug_lines.h"

#include <algorithm>
#include <array>

namespace renderer {
namespace {

constexpr glm::vec4 kFrustum{1, 0.72f, 0.2f, 0.95f}; // sRGB
constexpr float kBehind = 0.3f;                      // of the opacity, where something stands before it
constexpr double kShortest = 10, kLongest = 20000;   // m, of a view's edges

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

} // namespace

void addBox(std::vector<Line>& lines, const io::WorldBox& box, const glm::vec4& colour)
{
    const auto corner = [&box](int i) {
        return glm::dvec3{i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z};
    };
    for (int i = 0; i < 8; ++i)
        for (const int bit : {1, 2, 4})
            if (!(i & bit)) lines.push_back({.from = corner(i), .to = corner(i | bit), .colour = colour});
}

void addFrustum(std::vector<Line>& lines, const Eye& eye, const io::WorldBox& world)
{
    const double reach = reachOf(eye, world);
    const auto add = [&](const glm::dvec3& from, const glm::dvec3& to) {
        lines.push_back({.from = from, .to = to, .colour = kFrustum});
        lines.push_back({.from = from, .to = to, .colour = {glm::vec3{kFrustum}, kFrustum.a * kBehind}, .onTop = true});
    };
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

} // namespace renderer
