// Where the ground is: the same for every kind of field that has size, metresPerTexel, origin and at().
#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <optional>

namespace io {

template <class Heights> bool heightsContain(const Heights& heights, double x, double z)
{
    const glm::dvec2 texel = (glm::dvec2{x, z} - heights.origin) / heights.metresPerTexel;
    return texel.x >= 0 && texel.y >= 0 && texel.x <= heights.size.x - 1 && texel.y <= heights.size.y - 1;
}

// Of the triangle there.
template <class Heights> std::optional<double> heightOn(const Heights& heights, double x, double z)
{
    if (heights.size.x < 2 || heights.size.y < 2 || !heightsContain(heights, x, z)) return std::nullopt;
    const glm::dvec2 texel = (glm::dvec2{x, z} - heights.origin) / heights.metresPerTexel;
    const int column = std::min(int(texel.x), heights.size.x - 2);
    const int row = std::min(int(texel.y), heights.size.y - 2);
    const double u = texel.x - column;
    const double v = texel.y - row;
    const double h10 = heights.at(column + 1, row);
    const double h01 = heights.at(column, row + 1);
    if (u + v <= 1) {
        const double h00 = heights.at(column, row);
        return h00 + u * (h10 - h00) + v * (h01 - h00);
    }
    const double h11 = heights.at(column + 1, row + 1);
    return h11 + (1 - u) * (h01 - h11) + (1 - v) * (h10 - h11);
}

// Smooth, from what lies a texel away.
template <class Heights> std::optional<glm::dvec3> normalOn(const Heights& heights, double x, double z)
{
    const double step = heights.metresPerTexel;
    const auto near = [&](double dx, double dz) {
        const double left = heights.origin.x;
        const double top = heights.origin.y;
        return heightOn(heights, std::clamp(x + dx, left, left + (heights.size.x - 1) * step),
                        std::clamp(z + dz, top, top + (heights.size.y - 1) * step));
    };
    if (!heightsContain(heights, x, z)) return std::nullopt;
    const auto west = near(-step, 0), east = near(step, 0), north = near(0, -step), south = near(0, step);
    if (!west || !east || !north || !south) return std::nullopt;
    return glm::normalize(glm::dvec3{*west - *east, 2 * step, *north - *south});
}

} // namespace io
