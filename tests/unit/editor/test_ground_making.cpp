// Landscapes: the same recipe is the same ground, a coarser one the same landscape, and what cannot be made says why.
#include "editor/ground_making.h"
#include "editor/ground_picture.h"
#include "io/scene/resampling.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using namespace editor;

namespace {

GroundRecipe small(int side = 129)
{
    return coarser({.seed = 5}, side);
}

io::HeightGrid made(const GroundRecipe& recipe)
{
    io::Result<io::HeightGrid> ground = generateGround(recipe);
    EXPECT_TRUE(ground) << ground.error().text();
    return *std::move(ground);
}

double correlation(const std::vector<float>& a, const std::vector<float>& b)
{
    double meanA = 0, meanB = 0, ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        meanA += double(a[i]) / double(a.size()), meanB += double(b[i]) / double(b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double x = double(a[i]) - meanA, y = double(b[i]) - meanB;
        ab += x * y, aa += x * x, bb += y * y;
    }
    return ab / std::sqrt(aa * bb);
}

TEST(GroundMaking, IsTheSameEachTimeAndAnotherForAnotherSeed)
{
    GroundRecipe recipe = small();
    const io::HeightGrid ground = made(recipe);
    EXPECT_EQ(ground.metres, made(recipe).metres);
    recipe.seed = 6;
    const io::HeightGrid other = made(recipe);
    EXPECT_NE(ground.metres, other.metres);
    EXPECT_LT(correlation(ground.metres, other.metres), 0.6);
}

TEST(GroundMaking, ReachesItsHeightsAndLiesAroundTheOrigin)
{
    GroundRecipe recipe = small();
    recipe.width = 90;
    recipe.depth = 141;
    recipe.lowest = -30;
    recipe.highest = 450;
    for (const float terraces : {0.0f, 1.0f}) {
        recipe.terraces = terraces;
        const io::HeightGrid ground = made(recipe);
        EXPECT_EQ(ground.size, glm::ivec2(90, 141));
        EXPECT_EQ(ground.metresPerTexel, recipe.metresPerTexel);
        EXPECT_EQ(ground.origin, -0.5 * glm::dvec2(89, 140) * recipe.metresPerTexel);
        const auto [low, high] = std::ranges::minmax(ground.metres);
        EXPECT_NEAR(low, -30, 1e-3);
        EXPECT_NEAR(high, 450, 1e-3);
    }
}

TEST(GroundMaking, ACoarserOneIsTheSameLandscape)
{
    const GroundRecipe recipe = small(513);
    const io::HeightGrid fine = made(recipe);
    for (const int side : {129, 161, 257}) {
        const io::HeightGrid coarse = made(coarser(recipe, side));
        const io::HeightGrid shrunk = io::resampled(fine, coarse.size, coarse.metresPerTexel, coarse.origin);
        EXPECT_GT(correlation(coarse.metres, shrunk.metres), 0.97) << side;
        double away = 0;
        for (std::size_t i = 0; i < coarse.metres.size(); ++i)
            away += double(std::abs(coarse.metres[i] - shrunk.metres[i])) / double(coarse.metres.size());
        EXPECT_LT(away, 0.07 * double(recipe.highest - recipe.lowest)) << side;
    }
}

// Water that runs downhill from anywhere on the land seldom ends in a hollow: rivers have cut their way out.
TEST(GroundMaking, RiversDrainTheLand)
{
    const auto hollows = [](const io::HeightGrid& ground) {
        int count = 0;
        for (int z = 1; z + 1 < ground.size.y; ++z)
            for (int x = 1; x + 1 < ground.size.x; ++x) {
                bool lowest = ground.at(x, z) > 100;
                for (int i = 0; i < 9 && lowest; ++i)
                    lowest = i == 4 || ground.at(x + i % 3 - 1, z + i / 3 - 1) > ground.at(x, z);
                count += lowest;
            }
        return count;
    };
    GroundRecipe recipe = small(257);
    const int worn = hollows(made(recipe));
    recipe.erosion = 0;
    EXPECT_LT(worn * 20, hollows(made(recipe)));
}

TEST(GroundMaking, MoreLandIsMoreLand)
{
    double last = 0;
    for (const float land : {0.2f, 0.5f, 0.8f, 1.0f}) {
        GroundRecipe recipe = small();
        recipe.land = land;
        const io::HeightGrid ground = made(recipe);
        int above = 0;
        for (const float metres : ground.metres)
            above += metres > recipe.lowest + 0.12f * (recipe.highest - recipe.lowest);
        const double share = double(above) / double(ground.metres.size());
        EXPECT_GT(share, last);
        EXPECT_LT(share, double(land) + 0.05);
        last = share;
    }
}

TEST(GroundMaking, CanBeStopped)
{
    for (const int calls : {0, 3, 40, 200}) {
        int left = calls;
        float last = 0;
        const auto ground = generateGround(small(257), [&](float fraction, std::string_view) {
            EXPECT_GE(fraction, last - 1e-5f);
            EXPECT_LE(fraction, 1);
            last = fraction;
            return left-- > 0;
        });
        ASSERT_FALSE(ground) << calls;
        EXPECT_NE(ground.error().text().find("cancelled"), std::string::npos);
    }
}

TEST(GroundMaking, SaysWhatIsWrongWithARecipe)
{
    const float nothing = std::numeric_limits<float>::quiet_NaN();
    const std::pair<const char*, GroundRecipe> bad[] = {{"width", {.width = 0}},
                                                        {"depth", {.depth = -5}},
                                                        {"width", {.width = 100'000}},
                                                        {"metres_per_texel", {.metresPerTexel = -1}},
                                                        {"metres_per_texel", {.metresPerTexel = double(nothing)}},
                                                        {"lowest", {.lowest = nothing}},
                                                        {"highest", {.lowest = 10, .highest = 10}},
                                                        {"erosion", {.erosion = 2}},
                                                        {"talus", {.talus = std::numeric_limits<float>::infinity()}},
                                                        {"ridge_scale", {.ridgeScale = 0}}};
    for (const auto& [key, recipe] : bad) {
        const auto ground = generateGround(recipe);
        ASSERT_FALSE(ground) << key;
        EXPECT_TRUE(ground.error().text().starts_with(key)) << ground.error().text();
    }
}

TEST(GroundMaking, TheSmallestMapsAreMadeToo)
{
    for (const int side : {2, 3, 17, 65, 66}) {
        const io::HeightGrid ground = made({.width = side, .depth = 2, .metresPerTexel = 30});
        EXPECT_EQ(ground.metres.size(), std::size_t(side) * 2);
        for (const float metres : ground.metres)
            EXPECT_TRUE(std::isfinite(metres));
    }
}

TEST(GroundPicture, IsBrightTowardsTheNorthWest)
{
    io::HeightGrid roof{.size = {9, 9}, .metres = std::vector<float>(81)};
    for (int z = 0; z < 9; ++z)
        for (int x = 0; x < 9; ++x)
            roof.at(x, z) = 4 - std::abs(float(x - 4));
    const auto colours = shadedRelief(roof, 0, 4);
    ASSERT_EQ(colours.size(), 81u);
    EXPECT_GT(colours[4 * 9 + 2] & 255, (colours[4 * 9 + 6] & 255) + 40);
    EXPECT_EQ(colours[0] >> 24, 255u);
}

} // namespace
