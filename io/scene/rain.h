// Rain that wears ground: drops that run downhill, carry soil away where they are fast and leave it where they slow down
// (Beyer 2015, "Implementation of a method for hydraulic erosion").
#pragma once

#include "io/scene/height_grid.h"

#include <utility>
#include <vector>

namespace io {

struct Rain {
    int steps = 40;         // a drop's life, texels
    int reach = 3;          // radius of the soil that is taken at once, texels, as single points would become pits
    float strength = 1;     // of taking and leaving
    float unit = 1;         // m of height that count as one: with a texel's width the same slopes wear alike at every scale
    float inertia = 0.08f;  // share of its old way that a drop keeps, 0..1
    float capacity = 0.16f; // soil that is carried, by the fall, the speed and the water
    float gravity = 0.15f;
    float lasting = 0.985f; // share of its water that is left after each step
    bool seesItself = true; // a drop runs over what it has just changed itself; off is quicker, for nearly the same
    bool leavesAll = false; // where a drop ends it leaves what it carries: nothing is lost
};

class Rainfall {
public:
    Rainfall(HeightGrid& heights, const Rain& rain);

    void drop(glm::vec2 at); // texels; inside
    bool inside(glm::vec2 at) const { return at.x >= m_first && at.y >= m_first && at.x <= m_last.x && at.y <= m_last.y; }
    float first() const { return m_first; } // what is inside, texels along both sides
    glm::vec2 last() const { return m_last; }

private:
    struct Ground {
        float height;
        glm::vec2 slope;
    };
    Ground groundAt(glm::vec2 p) const;
    void leave(glm::vec2 p, float amount);
    void take(glm::vec2 p, float amount);

    HeightGrid& m_heights;
    Rain m_rain;
    float m_first;
    glm::vec2 m_last;
    std::vector<std::pair<std::ptrdiff_t, float>> m_taken; // texels around one, and their shares
};

} // namespace io
