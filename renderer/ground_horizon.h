// What of the ground stands behind other ground: for each direction around the eye, how steeply upwards one must look to see over all that
// was met so far (a horizon map of one point; compare Stewart, "Hierarchical Visibility in Terrains", 1997). It knows lengthy boxes
// only, so it hides less than there is to hide, and never what can be seen.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <utility>

namespace renderer {

// For an eye above ground without holes. Boxes come from front to back: of any two in one direction, the nearer one first.
class GroundHorizon {
public:
    explicit GroundHorizon(const glm::dvec3& eye);

    struct Box { // m; the ground fills it from side to side, and lies between low and high
        glm::dvec2 from{0}, to{0}; // x and z
        double low = 0, high = 0;
    };
    struct Seen { // of a box, from the eye; nothing where that is above the box
        int first = 0, last = 0;   // sectors that it touches, and beyond them, up to once around farther
        int inner = 0, end = 0;    // those that it fills
        float top = 0, bottom = 0; // the steepest line of sight to it; the least steep that is sure to meet it
        explicit operator bool() const { return first < last; }
    };
    Seen look(const Box& box) const;
    bool hides(const Seen& seen) const;
    void add(const Seen& seen);

private:
    static constexpr int kSectors = 2048; // a power of two

    static std::array<std::pair<int, int>, 2> pieces(int first, int last);

    glm::dvec3 m_eye;
    std::array<float, kSectors> m_slopes; // of the steepest line of sight that meets ground
};

} // namespace renderer
