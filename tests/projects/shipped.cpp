#include "tests/projects/shipped.h"

#include <gtest/gtest.h>
#include <map>

namespace tests {

const Shipped& shipped(std::string_view name)
{
    static std::map<std::string, Shipped, std::less<>> opened;
    if (const auto known = opened.find(name); known != opened.end()) return known->second;
    Shipped result;
    const std::filesystem::path folder = std::filesystem::path{WOLD_SOURCE_DIR} / "projects" / name;
    io::Result<io::World> world = io::openWorld(folder, "", result.complaints);
    if (!world) {
        ADD_FAILURE() << world.error().text();
    } else {
        result.world = std::move(*world);
        io::Result<io::Assets> assets = io::readAssets(result.world, result.complaints);
        if (assets) result.assets = std::move(*assets);
    }
    return opened.emplace(std::string{name}, std::move(result)).first->second;
}

} // namespace tests
