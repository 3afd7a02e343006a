#include "io/scene/height_map.h"

#include <gtest/gtest.h>

namespace io {
namespace {

// 3 x 3 texels, 2 m apart, from (10, 20); one peak of 8 m in the middle.
HeightMap peak()
{
    return HeightMap{HeightGrid{.size = {3, 3}, .metres = {0, 0, 0, 0, 8, 0, 0, 0, 0}, .metresPerTexel = 2, .origin = {10, 20}}};
}

TEST(HeightMap, IsExactAtTheTexels)
{
    const HeightMap map = peak();
    EXPECT_EQ(map.height(12, 22), 8);
    EXPECT_EQ(map.height(10, 20), 0);
    EXPECT_EQ(map.height(14, 24), 0);
}

TEST(HeightMap, SquaresSplitAlongTheDiagonalFromTheRight)
{
    const HeightMap map = peak();
    // The first square's far corner is the peak: its near triangle is flat, its far one climbs to it.
    EXPECT_NEAR(*map.height(10.5, 20.5), 0, 1e-12);
    EXPECT_NEAR(*map.height(11, 21), 0, 1e-12); // on the diagonal
    EXPECT_NEAR(*map.height(11.5, 21.5), 4, 1e-12);
    // The square to the right has the peak at (x, z+1), an end of its diagonal.
    EXPECT_NEAR(*map.height(13, 21), 4, 1e-12);
}

TEST(HeightMap, EndsAtItsEdges)
{
    const HeightMap map = peak();
    EXPECT_FALSE(map.height(9.999, 22));
    EXPECT_FALSE(map.height(12, 24.001));
    EXPECT_FALSE(map.normal(0, 0));
    EXPECT_TRUE(map.contains(14, 24));
}

TEST(HeightMap, NormalsLeanAwayFromThePeak)
{
    const HeightMap map = peak();
    EXPECT_NEAR(map.normal(12, 22)->y, 1, 1e-12);
    EXPECT_LT(map.normal(11, 22)->x, 0);
    EXPECT_GT(map.normal(13, 22)->x, 0);
    EXPECT_LT(map.normal(12, 21)->z, 0);
    EXPECT_TRUE(map.normal(10, 20));
}

HeightGrid counted(glm::ivec2 size)
{
    HeightGrid grid{.size = size};
    for (int i = 0; i < size.x * size.y; ++i)
        grid.metres.push_back(float(i % 9973));
    return grid;
}

TEST(HeightMap, TilesHoldWhatTheRowsHeld)
{
    for (const glm::ivec2 size : {glm::ivec2{2, 2}, {512, 512}, {513, 40}, {700, 1201}}) {
        const HeightGrid grid = counted(size);
        const HeightMap map{grid};
        for (int z = 0; z < size.y; ++z)
            for (int x = 0; x < size.x; ++x)
                ASSERT_EQ(map.at(x, z), grid.at(x, z));
        EXPECT_EQ(map.read(map.texels()).metres, grid.metres);
        EXPECT_EQ(map.min, *std::min_element(grid.metres.begin(), grid.metres.end()));
        EXPECT_EQ(map.max, *std::max_element(grid.metres.begin(), grid.metres.end()));
    }
}

TEST(HeightMap, AChangeSharesTheTilesThatItDoesNotTouch)
{
    const HeightMap map{counted({1100, 1100})};
    HeightGrid part{.size = {30, 20}, .metres = std::vector<float>(600, -7)};
    const HeightMap changed = map.with(part, {500, 100}); // across two tiles
    for (int z = 0; z < 3; ++z)
        for (int x = 0; x < 3; ++x)
            EXPECT_EQ(changed.field().tile({x, z}) == map.field().tile({x, z}), z != 0 || x == 2) << x << ' ' << z;
    EXPECT_EQ(changed.at(500, 100), -7);
    EXPECT_EQ(changed.at(529, 119), -7);
    EXPECT_EQ(changed.at(530, 119), map.at(530, 119));
    EXPECT_EQ(changed.min, -7);
    EXPECT_FALSE(changed.sameHeights(map));
    EXPECT_TRUE(changed.with(map.read({{500, 100}, {530, 120}}), {500, 100}).sameHeights(map));
    const HeightMap edge = map.with(part, {1090, -10}); // what lies beyond is left out
    EXPECT_EQ(edge.at(1099, 9), -7);
    EXPECT_EQ(edge.at(1099, 10), map.at(1099, 10));
    EXPECT_EQ(edge.at(1089, 0), map.at(1089, 0));
}

} // namespace
} // namespace io
