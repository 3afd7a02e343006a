// What a person does to single instances of scatter layers: deleting them, turning them into objects, and objects into instances.
#pragma once

#include "editor/document.h"

namespace editor {

// Those of the ids that are instances now, or that are not.
std::vector<io::ObjectId> instancesAmong(const io::Scene& scene, std::span<const io::ObjectId> ids);
std::vector<io::ObjectId> withoutInstances(std::span<const io::ObjectId> ids);

// Each is one step. In a layer with rules the places count as erased, so that the rules plant nothing there again.
void removeInstances(Document& document, std::string name, std::span<const io::ObjectId> instances);
std::vector<io::ObjectId> promote(Document& document, std::string name, std::span<const io::ObjectId> instances); // the new objects

struct Demoted {
    std::vector<io::InstanceRef> instances;
    std::size_t left = 0; // objects that stay: of a template that no layer has, scaled unevenly, mirrored, groups
};
// Into `layer`, or into the first one that has the template; painted by hand, so that rules leave them alone.
Demoted demote(Document& document, std::string name, std::span<const io::ObjectId> objects, io::ScatterId layer = io::ScatterId::None);

// The object that an instance would be.
io::Object objectOf(const io::Scene& scene, const io::InstanceRef& instance);
std::string instanceName(const io::Scene& scene, const io::InstanceRef& instance); // "fir (Slopes)"

std::uint64_t trianglesOf(const Document& document, const io::ScatterLayer& layer); // of all its instances but markers

} // namespace editor
