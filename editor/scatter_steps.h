// Steps of a document that scatter layers ask for beside those of a brush: rules that follow the ground, and plants that become
// objects and the other way round.
#pragma once

#include "editor/document.h"
#include "editor/picker.h"
#include "editor/scatter_edits.h"

#include <span>
#include <string>
#include <vector>

namespace editor {

// The highest surface of ground and objects, but for plants.
PlantSurface visibleSurface(const io::Scene& scene, const Picker& picker);

// With a picker, which is up to date and outlives it, a layer that grows on meshes does.
Planting plantingOf(const Document& document, const io::ScatterLayer& layer, const Picker* picker = nullptr);

// All rule layers over those bounds. Their ids, as far as they have to be looked at.
void followRules(Document& document, const std::string& name, const PlaneRect& bounds);
bool anyRules(const io::Scene& scene);

// Plants of all layers that stood on the ground as it was do so on the one that is there. Nothing is asked of rules.
void liftPlants(Document& document, const std::string& name, const io::HeightMap& before, const PlaneRect& bounds);

// Nothing planted or erased is left.
void clearPlants(Document& document, const std::string& name, io::ScatterId layer);

std::vector<io::ObjectId> plantsToObjects(Document& document, const std::string& name, io::ScatterId layer, const PlantRegion& region);
// Those that are copies of a species of the layer, stand in no group and are as large along all axes; how many they are.
std::size_t objectsToPlants(Document& document, const std::string& name, const io::ScatterLayer& layer, std::span<const io::ObjectId> ids);

} // namespace editor
