// The catalogue: every model that the shipped worlds use, by name.
#pragma once

#include "io/scene/template.h"
#include "projects/make/mesh.h"

#include <span>
#include <string_view>

namespace make {

// How a model becomes a template: the ranges its copies vary in, and how it meets the ground.
struct Entry {
    std::string_view name;
    std::string_view category;
    Mesh (*build)();
    io::Template look; // without name, category and model
};

std::span<const Entry> valleyEntries();
std::span<const Entry> forestEntries(); // exact triangle counts, in the order of the three sets

const Entry& entryOf(std::string_view name);
io::Model buildModel(std::string_view name, Textures& textures);
io::Template templateOf(const Entry& entry); // names models/NAME.glb

} // namespace make
