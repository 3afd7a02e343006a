// What brushes, buttons and rules make of the instances of a scatter layer, tile by tile. All of it is worked out on a copy of the
// layer's tiles, which costs little as they are shared, so it can be done beside the window; setInstances() then makes it so.
#pragma once

#include "editor/commands.h"
#include "editor/plant_region.h"
#include "editor/planting.h"
#include "io/base/progress.h"
#include "io/scene/instances.h"

#include <optional>
#include <span>
#include <vector>

namespace editor {

class Document;

// A layer as it is now, and which of its species are meant.
struct LayerTiles {
    io::ScatterId layer = io::ScatterId::None;
    io::InstanceTiles tiles;
    bool rule = false; // what is erased is remembered, and what is planted by hand stays
    std::vector<bool> species; // by their numbers; empty: all

    bool means(const io::Instance& instance) const { return species.empty() || (instance.species < species.size() && species[instance.species]); }
};
LayerTiles layerTiles(const io::Scene& scene, const io::ScatterLayer& layer);

using InstanceSlots = std::vector<SwapInstances::Slot>; // the tiles that change

// By hand: stays when rules are evaluated.
InstanceSlots planted(const LayerTiles& layer, const Planting& planting, const PlantRegion& region, const io::Progress& progress = {});
InstanceSlots erased(const LayerTiles& layer, const PlantRegion& region);
// Of those that are meant this share stays: always the same ones, so that twice is as once.
InstanceSlots thinned(const LayerTiles& layer, const PlantRegion& region, double share);
// Plants of one species become another's, in their places. Both are numbers of the planting's kinds.
InstanceSlots replaced(const LayerTiles& layer, const PlantRules& rules, const PlantRegion& region, std::uint8_t from, std::uint8_t to);

// What the rules say, besides what was planted and erased by hand, for the tiles that the bounds touch. Nothing when the progress
// said to stop.
std::optional<InstanceSlots> evaluated(const LayerTiles& layer, const Planting& planting, const PlaneRect& bounds, const io::Progress& progress = {});

// The tiles of `later` in place of those of the same name.
void applySlots(io::InstanceTiles& tiles, const InstanceSlots& later);
std::size_t countIn(const io::InstanceTiles& tiles, const PlantRegion& region);
std::size_t countIn(const LayerTiles& layer, const PlantRegion& region); // of those that are meant

} // namespace editor
