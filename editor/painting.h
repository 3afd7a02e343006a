// Painting: what brushes and buttons make of the cover of the ground, as steps of a document.
#pragma once

#include "editor/brush.h"
#include "editor/document.h"

#include <span>

namespace editor {

io::CoverMap coverOf(const io::Scene& scene); // nothing painted where there is none; the scene has heights

// Makes a patch part of the cover, with a file of its own where there was none.
void changeCover(Document& document, const std::string& name, const CoverPatch& patch);

// Paints where the brush's slopes and heights let it, all over the ground, as one step.
void fillCover(Document& document, const std::string& name, const Brush& brush);

// The same of the grass: a map of a metre a texel over all of the ground where there is none.
io::GrassMap grassMapOf(const io::Scene& scene);
void changeGrassMap(Document& document, const std::string& name, const CoverPatch& patch);
void fillGrass(Document& document, const std::string& name, const Brush& brush);

// The kinds of grass are these now, numbered as setLayers() has it.
void setGrassKinds(Document& document, const std::string& name, std::vector<io::GrassKind> kinds, std::span<const int> newNumbers);

// The layers of the ground are these now; newNumbers[i] is that of the one that was i, -1 if it is gone: what was painted goes on
// to show the same layers.
void setLayers(Document& document, const std::string& name, std::vector<io::TerrainLayer> layers, std::span<const int> newNumbers);

} // namespace editor
