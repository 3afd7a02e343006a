#include "io/scene/terrain.h"

#include <algorithm>
#include <cmath>

namespace io {

bool HeightMap::contains(double x, double z) const
{
    const glm::dvec2 texel = (glm::dvec2{x, z} - origin) / metresPerTexel;
    return texel.x >= 0 && texel.y >= 0 && texel.x <= size.x - 1 && texel.y <= size.y - 1;
}

std::optional<double> HeightMap::height(double x, double z) const
{
    if (size.x < 2 || size.y < 2 || !contains(x, z)) return std::nullopt;
    const glm::dvec2 texel = (glm::dvec2{x, z} - origin) / metresPerTexel;
    const int column = std::min(int(texel.x), size.x - 2);
    const int row = std::min(int(texel.y), size.y - 2);
    const double u = texel.x - column;
    const double v = texel.y - row;
    const double h10 = at(column + 1, row);
    const double h01 = at(column, row + 1);
    if (u + v <= 1) {
        const double h00 = at(column, row);
        return h00 + u * (h10 - h00) + v * (h01 - h00);
    }
    const double h11 = at(column + 1, row + 1);
    return h11 + (1 - u) * (h01 - h11) + (1 - v) * (h10 - h11);
}

std::optional<glm::dvec3> HeightMap::normal(double x, double z) const
{
    const double step = metresPerTexel;
    const auto near = [&](double dx, double dz) {
        const double left = origin.x;
        const double top = origin.y;
        return height(std::clamp(x + dx, left, left + (size.x - 1) * step),
                      std::clamp(z + dz, top, top + (size.y - 1) * step));
    };
    if (!contains(x, z)) return std::nullopt;
    const auto west = near(-step, 0), east = near(step, 0), north = near(0, -step), south = near(0, step);
    if (!west || !east || !north || !south) return std::nullopt;
    return glm::normalize(glm::dvec3{*west - *east, 2 * step, *north - *south});
}

} // namespace io
