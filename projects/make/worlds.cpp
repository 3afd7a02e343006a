#include "projects/make/worlds.h"

namespace make {

std::span<const WorldPlan> worldPlans()
{
    static constexpr WorldPlan kPlans[] = {
        {"valley", makeValley},
        {"forest-1",
         [](const std::filesystem::path& folder, Textures& textures) { return makeForest(folder, 1, textures); }},
        {"forest-2",
         [](const std::filesystem::path& folder, Textures& textures) { return makeForest(folder, 2, textures); }},
        {"forest-3",
         [](const std::filesystem::path& folder, Textures& textures) { return makeForest(folder, 3, textures); }},
        {"empty", makeEmpty},
    };
    return kPlans;
}

} // namespace make
