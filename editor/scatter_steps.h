// Steps of a document that scatter layers ask for beside those of a brush: rules that follow the ground, and plants that become
// objects (single ones, and the other way round: editor/instance_edits.h).
#pragma once

#include "editor/document.h"
#include "editor/picker.h"
#include "editor/scatter_edits.h"

#include <string>
#include <vector>

namespace editor {

// The highest surface of ground and objects, but for plants.
PlantSurface visibleSurface(const io::Scene& scene, const Picker& picker);

// With a picker, which is up to date and outlives it, a layer that grows on meshes does.
Planting plantingOf(const Document& document, const io::ScatterLayer& layer, const Picker* picker = nullptr);

// All layers of rules that grow on the ground alone, over those bounds. What else grows on objects is left as it is, as rays know
// nothing of the new ground yet.
void followRules(Document& document, const std::string& name, const PlaneRect& bounds);

// Plants of all layers that stood on the ground as it was do so on the one that is there. Nothing is asked of rules.
void liftPlants(Document& document, const std::string& name, const io::HeightMap& before, const PlaneRect& bounds);

// Another list of species, by their templates: plants keep theirs, and those of species that are gone go.
void setSpecies(Document& document, const std::string& name, io::ScatterId layer, std::vector<io::Species> species);

// Nothing planted or erased is left.
void clearPlants(Document& document, const std::string& name, io::ScatterId layer);

std::vector<io::ObjectId> plantsToObjects(Document& document, const std::string& name, io::ScatterId layer, const PlantRegion& region);

} // namespace editor
