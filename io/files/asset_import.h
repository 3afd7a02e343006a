// Files from outside for a project: what they are, whether they can be read, and the bytes that go into its folders.
#pragma once

#include "io/base/complaint.h"
#include "io/base/result.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

namespace io {

enum class AssetKind { HeightMap, Model, Texture, Sound };
constexpr auto enumNames(AssetKind) { return std::array<std::string_view, 4>{"heights", "model", "texture", "sound"}; }

// By its name, and of pictures by what they hold: one channel of 16 bits or floats is a height map.
Result<AssetKind> assetKind(const std::filesystem::path& file);

struct CheckedAsset {
    std::string target; // models/…, textures/…, sounds/…: relative to the project
    std::string bytes;
    bool there = false; // the project holds just these bytes under that name
};
// Reads a model, a texture or a sound whole. A model that names other files becomes one .glb with all of them; of a sound only its
// container is looked at. A name that is taken by another file gets a number.
Result<CheckedAsset> checkAsset(const std::filesystem::path& file, AssetKind kind, const std::filesystem::path& project, Complaints& complaints);

} // namespace io
