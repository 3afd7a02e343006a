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

// The layers of the ground are these now; newNumbers[i] is that of the one that was i, -1 if it is gone: what was painted goes on
// to show the same layers.
void setLayers(Document& document, const std::string& name, std::vector<io::TerrainLayer> layers, std::span<const int> newNumbers);

} // namespace editor
