#include "io/scene/height_map_builder.h"

#include <gtest/gtest.h>

namespace io {
namespace {

HeightGrid slope(glm::ivec2 size)
{
    HeightGrid grid{.size = size, .metresPerTexel = 3, .origin = {5, -6}};
    for (int i = 0; i < size.x * size.y; ++i)
        grid.metres.push_back(float(i % 977) - float(i % 31) * 0.25f);
    return grid;
}

HeightMapBuilder built(const HeightGrid& grid)
{
    HeightMapBuilder builder{grid.size};
    for (int z = 0; z < grid.size.y; ++z)
        builder.addRow({&grid.metres[std::size_t(z) * std::size_t(grid.size.x)], std::size_t(grid.size.x)});
    return builder;
}

TEST(HeightMapBuilder, RowsMakeTheMapThatTheWholeGridMakes)
{
    for (const glm::ivec2 size : {glm::ivec2{1, 1}, {3, 2}, {512, 512}, {513, 1024}, {1100, 700}}) {
        const HeightGrid grid = slope(size);
        const HeightMap map = built(grid).finish(3, {5, -6}), whole{grid};
        EXPECT_EQ(map, whole) << size.x << " x " << size.y;
        EXPECT_EQ(map.size, size);
        EXPECT_EQ(map.min, whole.min);
        EXPECT_EQ(map.max, whole.max);
    }
}

TEST(HeightMapBuilder, KnowsWhereTheVoidsAre)
{
    HeightGrid grid = slope({1100, 700});
    EXPECT_EQ(built(grid).voids(), 0u);
    EXPECT_TRUE(built(grid).voidRect().empty());
    const float none = std::numeric_limits<float>::quiet_NaN();
    for (const Texel at : {Texel{40, 500}, Texel{1030, 520}, Texel{600, 699}})
        grid.metres[std::size_t(at.y * 1100 + at.x)] = none;
    HeightMapBuilder builder = built(grid);
    EXPECT_EQ(builder.voids(), 3u);
    EXPECT_EQ(builder.voidRect(), (TexelRect{{40, 500}, {1031, 700}}));
    builder.set(40, 500, -50);
    builder.set(1030, 520, 5000);
    builder.set(600, 699, 3);
    const HeightMap map = builder.finish(1, {0, 0});
    EXPECT_EQ(map.at(1030, 520), 5000);
    EXPECT_EQ(map.min, -50);
    EXPECT_EQ(map.max, 5000);
    EXPECT_EQ(map.with(slope({1100, 700}), {0, 0}).max, HeightMap{slope({1100, 700})}.max); // each tile's range is its own
}

} // namespace
} // namespace io
