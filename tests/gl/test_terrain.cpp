// The ground has no holes, and near the eye it is the height map itself.
#include "renderer/terrain_tree.h"
#include "tests/gl/support/shared_renderer.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace {

constexpr glm::ivec2 kSize{320, 180};

double spikes(double x, double z)
{
    const int ix = int(std::floor(x / 6)), iz = int(std::floor(z / 6));
    return ((ix * 7 + iz * 13) % 11 == 0) ? 300.0 : std::sin(x * 0.9) * 3 + std::cos(z * 1.3) * 3;
}

int holes(const io::HeightMap& map, const io::Camera& camera)
{
    test::TestWorld world;
    world.scene.exchange(io::Terrain{.heightMap = "terrain/map.png"});
    world.assets.heights = std::make_shared<io::HeightMap>(map);
    test::load(world);
    renderer::FrameInput in = test::frame(kSize, camera);
    in.settings.shadows = false;
    test::shared().render(in);
    const auto ids = test::shared().readIds({0, 0}, kSize);
    return int(std::count(ids.begin(), ids.end(), 0u));
}

TEST(Terrain, HasNoCracks)
{
    const auto hills = test::heightMap({700, 1201}, 2, test::hills);
    const auto rough = test::heightMap({513, 513}, 1, spikes);
    for (const double x : {-90.0, 10.0, 130.0})
        for (const double height : {20.0, 90.0, 400.0}) {
            const io::Camera down{.eye = {x, hills->height(x, 40).value_or(0) + height, 40}, .yaw = float(x), .pitch = -88};
            EXPECT_EQ(holes(*hills, down), 0) << "hills, " << x << ", " << height;
            if (height > 100) continue; // further up one sees past its edge
            const io::Camera steep{.eye = {x * 0.5, 330 + height, 0}, .yaw = float(3 * x), .pitch = -87, .fov = 25};
            EXPECT_EQ(holes(*rough, steep), 0) << "spikes, " << x << ", " << height;
        }
}

TEST(Terrain, AnySizeIsDrawn)
{
    for (const glm::ivec2 size : {glm::ivec2{2, 2}, {257, 2}, {3, 500}, {33, 33}, {1024, 1024}, {1201, 77}}) {
        const auto map = test::heightMap(size, 1, [](double, double) { return 5.0; });
        const io::Camera down{.eye = {0, 5.4, 0}, .pitch = -90, .fov = 60};
        const int empty = holes(*map, down);
        const bool wide = size.x > 2 && size.y > 2;
        EXPECT_LT(empty, wide ? 1 : kSize.x * kSize.y) << size.x << " x " << size.y;
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(TerrainTree, CoversEachTexelOnceAndIsFineNearTheEye)
{
    const auto map = test::heightMap({300, 421}, 1, test::hills);
    const renderer::TerrainTree tree{*map};
    const auto nodes = tree.select({.texel = {120, 200}, .eyeAbove = 4, .firstRange = 110});
    std::vector<int> cover(300 * 421, 0);
    int finest = 0;
    for (const renderer::GroundNode& node : nodes) {
        const int side = TERRAIN_QUADS << node.level;
        glm::ivec2 low = node.origin, high = node.origin + side;
        if (node.quarter >= 0) {
            low += glm::ivec2{node.quarter & 1, node.quarter >> 1} * (side / 2);
            high = low + side / 2;
        }
        for (int z = low.y; z < std::min(high.y, 420); ++z)
            for (int x = low.x; x < std::min(high.x, 299); ++x) {
                ++cover[std::size_t(z) * 300 + std::size_t(x)];
                if (std::hypot(x - 120.0, z - 200.0) < 80 && node.level == 0 && node.quarter < 0) ++finest;
            }
    }
    int wrong = 0, near = 0;
    for (int z = 0; z < 420; ++z)
        for (int x = 0; x < 299; ++x) {
            wrong += cover[std::size_t(z) * 300 + std::size_t(x)] != 1;
            near += std::hypot(x - 120.0, z - 200.0) < 80;
        }
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(finest, near);
}

TEST(TerrainTree, NeighboursDifferByOneLevelAtMost)
{
    const auto map = test::heightMap({1025, 1025}, 1, spikes);
    const renderer::TerrainTree tree{*map};
    for (const double x : {3.0, 500.0, 777.0}) {
        const auto nodes = tree.select({.texel = {x, 400}, .eyeAbove = 10, .firstRange = 103});
        std::vector<int> level(1024 * 1024, -1);
        for (const renderer::GroundNode& node : nodes) {
            const int side = TERRAIN_QUADS << node.level;
            const int part = node.quarter < 0 ? side : side / 2;
            const glm::ivec2 low = node.origin + (node.quarter < 0 ? glm::ivec2{0} : glm::ivec2{node.quarter & 1, node.quarter >> 1} * part);
            for (int z = low.y; z < std::min(low.y + part, 1024); ++z)
                for (int tx = low.x; tx < std::min(low.x + part, 1024); ++tx)
                    level[std::size_t(z) * 1024 + std::size_t(tx)] = node.level;
        }
        int jumps = 0;
        for (int z = 1; z < 1024; ++z)
            for (int tx = 1; tx < 1024; ++tx) {
                const int own = level[std::size_t(z) * 1024 + std::size_t(tx)];
                jumps += std::abs(own - level[std::size_t(z) * 1024 + std::size_t(tx) - 1]) > 1;
                jumps += std::abs(own - level[std::size_t(z - 1) * 1024 + std::size_t(tx)]) > 1;
            }
        EXPECT_EQ(jumps, 0) << x;
    }
}

} // namespace
