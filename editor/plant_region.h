// PlantRegion: where a brush, a line drawn around or a button means: a part of the world seen from above.
#pragma once

#include "editor/plant_pattern.h"

#include <optional>
#include <vector>

namespace editor {

class PlantRegion {
public:
    static PlantRegion disc(const glm::dvec2& centre, double radius);
    static PlantRegion polygon(std::vector<glm::dvec2> corners); // closed by itself; even-odd where it crosses itself
    static PlantRegion everywhere();

    bool contains(const glm::dvec2& at) const;
    const PlaneRect& bounds() const { return m_bounds; }

private:
    PlaneRect m_bounds;
    std::optional<double> m_radius; // of a disc
    std::vector<glm::dvec2> m_corners; // of a polygon
};

} // namespace editor
