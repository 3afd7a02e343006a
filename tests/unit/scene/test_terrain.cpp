#include "io/scene/terrain.h"

#include <gtest/gtest.h>

namespace io {
namespace {

// 3 x 3 texels, 2 m apart, from (10, 20); one peak of 8 m in the middle.
HeightMap peak()
{
    HeightMap map;
    map.size = {3, 3};
    map.metres = {0, 0, 0, 0, 8, 0, 0, 0, 0};
    map.metresPerTexel = 2;
    map.origin = {10, 20};
    return map;
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

} // namespace
} // namespace io
