// Levels of detail on disk: named by a hash of what they were made of, and trusted in nothing.
#pragma once

#include "io/base/content_hash.h"
#include "io/scene/model.h"

#include <optional>
#include <string>
#include <string_view>

namespace io::levels {

// What makeLevels made of a model: old numbers of the full model's vertices, the vertices that only levels use, and
// all triangles in their new order.
struct Made {
    std::vector<std::uint32_t> order;
    std::vector<Vertex> added;
    std::vector<std::uint32_t> indices;
    std::vector<Level> levels;
};

using Key = ContentKey;
Key keyOf(const Model& model); // of geometry, parts and how they are drawn, and of the way levels are made
std::string fileName(const Key& key);

std::string encode(const Key& key, const Made& made);
// Nothing when the bytes are damaged, are another model's or hold a number that does not fit `model`.
std::optional<Made> decode(std::string_view bytes, const Key& key, const Model& model);

void apply(Made made, Model& model);

} // namespace io::levels
