#include "io/scene/settling.h"

#include <cmath>

namespace io {

void settle(HeightGrid& heights, float degrees, int passes)
{
    const float most = std::tan(glm::radians(degrees)) * float(heights.metresPerTexel);
    for (int pass = 0; pass < passes; ++pass)
        for (int z = 1; z + 1 < heights.size.y; ++z)
            for (int x = 1; x + 1 < heights.size.x; ++x) {
                float& own = heights.at(x, z);
                for (float* next : {&heights.at(x + 1, z), &heights.at(x - 1, z), &heights.at(x, z + 1), &heights.at(x, z - 1)}) {
                    const float over = own - *next - most;
                    if (over <= 0) continue;
                    own -= over * 0.22f;
                    *next += over * 0.22f;
                }
            }
}

} // namespace io
