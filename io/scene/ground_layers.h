// GroundLayers: which of the terrain's layers shows at a place, as its rules and what was painted say.
#pragma once

#include "io/scene/cover_map.h"
#include "io/scene/ground_flow.h"
#include "io/scene/height_map.h"
#include "io/scene/terrain.h"

#include <array>
#include <memory>
#include <optional>

namespace io {

// What renderer/shaders/terrain_layers.glsl draws, but for the noise that makes its borders ragged.
class GroundLayers {
public:
    using Shares = std::array<float, kMostLayers>; // together 1, or less where no layer shows

    GroundLayers(std::shared_ptr<const HeightMap> heights, std::shared_ptr<const CoverMap> cover, std::vector<TerrainLayer> layers);

    Shares at(double x, double z) const; // world, on the map

private:
    float byRule(const TerrainLayer& layer, float slope, float altitude, float flow) const;
    void showPainted(Shares& shares, double x, double z) const;

    std::shared_ptr<const HeightMap> m_heights;
    std::shared_ptr<const CoverMap> m_cover; // null: nothing was painted
    std::vector<TerrainLayer> m_layers;
    std::optional<GroundFlow> m_flow; // where a layer asks for it
};

} // namespace io
