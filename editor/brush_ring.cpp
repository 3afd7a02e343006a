#include "editor/brush_ring.h"

#include <glm/gtc/constants.hpp>

namespace editor {

void addRing(std::vector<renderer::Line>& lines, const io::HeightMap* map, const glm::dvec3& eye, const glm::dvec3& middle, double radius, const glm::vec4& colour)
{
    constexpr int kParts = 96;
    const auto point = [&](int i) {
        const double angle = glm::two_pi<double>() * i / kParts;
        const double x = middle.x + radius * std::cos(angle), z = middle.z + radius * std::sin(angle);
        const double y = map ? map->height(x, z).value_or(middle.y) : middle.y;
        return glm::dvec3{x, y + 0.02 + 0.003 * glm::distance(eye, glm::dvec3{x, y, z}), z};
    };
    for (int i = 0; i < kParts; ++i) {
        const glm::dvec3 from = point(i), to = point(i + 1);
        lines.push_back({.from = from, .to = to, .colour = colour});
        lines.push_back({.from = from, .to = to, .colour = {glm::vec3{colour}, colour.w * 0.25f}, .onTop = true});
    }
}

} // namespace editor
