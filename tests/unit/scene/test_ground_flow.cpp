// Water gathers in valleys, whatever the map's resolution.
#include "io/scene/ground_flow.h"

#include <cmath>
#include <gtest/gtest.h>

namespace {

// A valley along z, 400 m wide, that falls by a tenth; 4 km long.
io::HeightMap valley(double metresPerTexel)
{
    const glm::ivec2 size{int(800 / metresPerTexel) + 1, int(4000 / metresPerTexel) + 1};
    io::HeightGrid grid{.size = size, .metresPerTexel = metresPerTexel};
    for (int z = 0; z < size.y; ++z)
        for (int x = 0; x < size.x; ++x)
            grid.metres.push_back(float(std::abs(x * metresPerTexel - 400) * 0.3 + z * metresPerTexel * 0.1));
    return io::HeightMap{grid};
}

float at(const io::GroundFlow& flow, double x, double z)
{
    return flow.values[std::size_t(std::lround(z / flow.cell)) * std::size_t(flow.size.x) + std::size_t(std::lround(x / flow.cell))];
}

TEST(GroundFlow, GathersDownhill)
{
    const io::GroundFlow flow = io::flowOf(valley(8));
    EXPECT_EQ(flow.size, (glm::ivec2{101, 501}));
    EXPECT_LT(at(flow, 16, 2000), 0.2f) << "a crest";
    EXPECT_GT(at(flow, 400, 200), at(flow, 400, 3000)) << "grows downstream";
    EXPECT_GT(at(flow, 400, 2000), at(flow, 200, 2000) + 0.3f) << "the bed against its slope";
    EXPECT_NEAR(at(flow, 400, 200), std::log10(800.0 * 3800 / 100) / 5, 0.08) << "all that lies above";
}

TEST(GroundFlow, IsTheSameForFinerMapsAndNeverLargerThanItsGrid)
{
    const io::GroundFlow coarse = io::flowOf(valley(16)), fine = io::flowOf(valley(8)), finest = io::flowOf(valley(2));
    EXPECT_LE(std::max(finest.size.x, finest.size.y), io::kFlowSide);
    for (const double z : {400.0, 1600.0, 3200.0}) {
        EXPECT_NEAR(at(coarse, 400, z), at(fine, 400, z), 0.06f);
        EXPECT_NEAR(at(finest, 400, z), at(fine, 400, z), 0.06f);
    }
}

TEST(GroundFlow, LevelAndTinyGroundHaveOne)
{
    io::HeightGrid level{.size = {2, 2}, .metres = {5, 5, 5, 5}, .metresPerTexel = 10};
    const io::GroundFlow flow = io::flowOf(io::HeightMap{level});
    EXPECT_EQ(flow.size, (glm::ivec2{2, 2}));
    for (const float value : flow.values)
        EXPECT_EQ(value, 0);
}

} // namespace
