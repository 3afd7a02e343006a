// Other rows of a field of texels: finer or coarser ones, a part, or the same moved along.
#pragma once

#include "io/base/contract.h"
#include "io/scene/height_grid.h"
#include "io/scene/texel_rect.h"

#include <cmath>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace io {

// The same ground with other texels, `size` of them from `origin` on: finer ones through Catmull-Rom cubics (Catmull and Rom 1974),
// coarser ones as means of what they cover. Beyond its edge the ground goes on as its own reflection in the edge's point, so that
// a plane stays the same plane to the edge. At least 2 x 2 texels in, 1 x 1 out.
HeightGrid resampled(const HeightGrid& from, glm::ivec2 size, double metresPerTexel, glm::dvec2 origin);

// The rows of a field of `size` that show at each of `to` texels the one that at(x, z) names, or T{} where that is none of it.
template <class T, class At> std::vector<T> gathered(std::span<const T> rows, glm::ivec2 size, glm::ivec2 to, At&& at)
{
    EXPECTS(rows.size() == std::size_t(size.x) * std::size_t(size.y));
    std::vector<T> result(std::size_t(to.x) * std::size_t(to.y));
    for (int z = 0; z < to.y; ++z)
        for (int x = 0; x < to.x; ++x) {
            const glm::ivec2 from = at(x, z);
            if (from.x >= 0 && from.y >= 0 && from.x < size.x && from.y < size.y)
                result[std::size_t(z) * std::size_t(to.x) + std::size_t(x)] = rows[std::size_t(from.y) * std::size_t(size.x) + std::size_t(from.x)];
        }
    return result;
}

} // namespace io
