// The worlds that ship, each made whole into a folder of its own.
#pragma once

#include "io/base/result.h"
#include "projects/make/textures.h"

#include <filesystem>
#include <span>
#include <string_view>

namespace make {

struct WorldPlan {
    std::string_view name; // its folder
    io::Status (*make)(const std::filesystem::path& folder, Textures& textures);
};
std::span<const WorldPlan> worldPlans();

io::Status makeValley(const std::filesystem::path& folder, Textures& textures);
io::Status makeForest(const std::filesystem::path& folder, int set, Textures& textures); // 1..3
io::Status makeEmpty(const std::filesystem::path& folder, Textures& textures);

} // namespace make
