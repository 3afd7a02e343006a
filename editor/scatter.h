// Scatter: objects of a mix of templates, strewn over a part of the world or taken from it. Each is one undo step.
#pragma once

#include "editor/document.h"
#include "editor/plant_region.h"
#include "editor/planting.h"

#include <span>
#include <string>
#include <vector>

namespace editor {

constexpr std::size_t kMostScattered = 1'000'000; // objects at once

// The new ids. Those of the same templates that stand there count: twice over one place is as once.
std::vector<io::ObjectId> scatter(Document& document, const std::string& name, const Planting& planting, const PlantRegion& region);

// Objects of these templates in the region, by id.
std::vector<io::ObjectId> scatteredIn(const io::Scene& scene, std::span<const io::TemplateId> templates, const PlantRegion& region);
// Of those, the ones that go for this share to stay; always the same ones.
std::vector<io::ObjectId> thinnedOut(const io::Scene& scene, std::vector<io::ObjectId> ids, double share);

} // namespace editor
