#include "stage.h"

#include "io/base/random.h"
#include "io/scene/ground.h"

#include <cmath>
#include <gtest/gtest.h>

namespace play {
namespace {

using test::Stage;
using test::walk;

io::PlayerStart like(io::PlayerShape shape)
{
    return {.shape = shape};
}

class WalkerOf : public testing::TestWithParam<io::PlayerShape> {
protected:
    Stage stage;
    Walker walker{like(GetParam())};
    void start(const glm::dvec3& at, double yaw = 0)
    {
        walker.put(at, yaw, 0, stage.surroundings());
        walk(walker, stage, {}, 60);
    }
};
INSTANTIATE_TEST_SUITE_P(Shapes, WalkerOf, testing::Values(io::PlayerShape::Capsule, io::PlayerShape::SweptBox));

constexpr Wish kAhead{.move = {0, 1}};
double flat(double, double)
{
    return 0;
}

TEST_P(WalkerOf, WalksAsFastAsItsStartSays)
{
    stage.setGround(flat);
    start({0, 0, 20});
    ASSERT_TRUE(walker.grounded());
    walk(walker, stage, kAhead, 60);
    const double before = walker.feet().z;
    walk(walker, stage, kAhead, 60);
    EXPECT_NEAR(before - walker.feet().z, 2.2, 0.02);
    EXPECT_NEAR(walker.feet().y, 0, 0.01);
}

TEST_P(WalkerOf, SlidesAlongAWallAndStopsInACorner)
{
    stage.setGround(flat);
    const io::TemplateId wall = stage.addBox({20, 3, 1});
    stage.place(wall, {0, 0, -5});
    stage.place(wall, {5, 0, 0}, {0, 90, 0});
    start({0, 0, 0}, -30);
    walk(walker, stage, kAhead, 240, [&] { EXPECT_LT(walker.depth(stage.surroundings()), 0.01); });
    walk(walker, stage, kAhead, 240);
    const glm::dvec3 corner = walker.feet();
    EXPECT_NEAR(corner.z, -4.2, 0.02);
    EXPECT_NEAR(corner.x, 4.2, 0.02);
    walk(walker, stage, kAhead, 60, [&] { EXPECT_LT(glm::length(walker.feet() - corner), 1e-3); }); // no jitter
}

TEST_P(WalkerOf, StandsStillInWideCornersToo)
{
    for (const double angle : {110.0, 120.0, 130.0, 140.0, 150.0, 160.0, 170.0})
        for (const double yaw : {-6.0, 0.0, 3.0}) {
            Stage room;
            room.setGround(flat);
            const io::TemplateId side = room.addBox({30, 3, 1});
            const double half = (180 - angle) / 2, r = glm::radians(half);
            if (std::abs(yaw) >= half) continue; // slides along one of them
            // Two walls that meet before the player, each turned by half of what is missing to straight.
            room.place(side, {-15 * std::cos(r), 0, -6 + 15 * std::sin(r)}, {0, float(half), 0});
            room.place(side, {15 * std::cos(r), 0, -6 + 15 * std::sin(r)}, {0, float(-half), 0});
            Walker in{like(GetParam())};
            in.put({0, 0, 0}, yaw, 0, room.surroundings());
            walk(in, room, kAhead, 1800);
            const glm::dvec3 corner = in.feet();
            walk(in, room, kAhead, 120, [&] { EXPECT_LT(glm::length(in.feet() - corner), 1e-3) << angle << " " << yaw; });
            if (HasFailure()) return;
        }
}

TEST_P(WalkerOf, ClimbsStairsAndNoHigherOnes)
{
    stage.setGround(flat);
    for (int i = 0; i < 6; ++i)
        stage.place(stage.addBox({3, 0.3f * float(i + 1), 0.5f}), {0, 0, -2 - 0.5 * i});
    stage.place(stage.addBox({3, 2.4f, 3}), {0, 0, -6.25});
    start({0, 0, 0});
    walk(walker, stage, kAhead, 240);
    EXPECT_NEAR(walker.feet().y, 1.8, 0.02);
    EXPECT_NEAR(walker.feet().z, -4.75 + 0.3, 0.03);
    EXPECT_TRUE(walker.grounded());
    walk(walker, stage, {.move = {0, -1}}, 300, [&] { EXPECT_TRUE(walker.grounded()); }); // down them without a fall
    EXPECT_NEAR(walker.feet().y, 0, 0.01);
}

TEST_P(WalkerOf, StandsOnSlopesUpToItsLimitAndSlidesDownSteeperOnes)
{
    for (int degrees = 5; degrees <= 80; degrees += 5) {
        Stage hill;
        const double rise = std::tan(glm::radians(double(degrees)));
        hill.setGround([&](double, double z) { return -z * rise; });
        Walker on{like(GetParam())};
        on.put({0.3, 0, 0.2}, 0, 0, hill.surroundings());
        walk(on, hill, {}, 60);
        const glm::dvec3 before = on.feet();
        walk(on, hill, {}, 60);
        const glm::dvec3 moved = on.feet() - before;
        if (degrees <= 45) {
            EXPECT_LT(glm::length(moved), 1e-3) << degrees;
            walk(on, hill, kAhead, 60);
            EXPECT_NEAR(before.z - on.feet().z, 2.2, 0.1) << degrees; // uphill as fast as on level ground, seen from above
        } else {
            EXPECT_GT(moved.z, 0.5) << degrees; // down the gradient
            if (GetParam() == io::PlayerShape::Capsule) { // the box stands on a corner and turns aside at the ground's edges
                EXPECT_NEAR(moved.y / moved.z, -rise, 0.05 * rise) << degrees;
                EXPECT_NEAR(moved.x, 0, 0.01) << degrees;
            }
            const double z = on.feet().z;
            walk(on, hill, kAhead, 120);
            EXPECT_GT(on.feet().z, z - 0.1) << degrees; // not up it
        }
    }
}

TEST_P(WalkerOf, FallsOntoTheGroundAndJumpsAsHighAsItMay)
{
    stage.setGround(flat);
    walker.put({0, 30, 0}, 0, 0, stage.surroundings());
    int steps = 0;
    for (; !walker.grounded() && steps < 600; ++steps)
        walker.step({}, stage.surroundings());
    EXPECT_NEAR(steps / 60.0, std::sqrt(60 / 9.81), 0.05);
    double highest = 0;
    walker.step({.jump = true}, stage.surroundings());
    walk(walker, stage, {}, 90, [&] { highest = std::max(highest, walker.feet().y); });
    EXPECT_NEAR(highest, 1.1, 0.12);
    EXPECT_TRUE(walker.grounded());
}

TEST_P(WalkerOf, AHundredMetresASecondStopAtAThinWall)
{
    stage.setGround(flat);
    stage.place(stage.addBox({20, 20, 0.02f}, io::Collision::Mesh), {0, 0, -10});
    walker.put({0, 5, 0}, 0, 0, stage.surroundings());
    walker.setVelocity({0, 0, -100});
    walk(walker, stage, {}, 60, [&] { EXPECT_GT(walker.feet().z, -9.7); });
}

TEST_P(WalkerOf, ACeilingStopsAJumpAndAnswersCrouching)
{
    stage.setGround(flat);
    stage.place(stage.addBox({4, 1, 4}), {0, 1.4, -4});
    start({0, 0, 0});
    walk(walker, stage, kAhead, 120);
    EXPECT_GT(walker.feet().z, -1.8); // too low to walk under
    walk(walker, stage, {.move = {0, 1}, .crouch = true}, 120);
    EXPECT_LT(walker.feet().z, -2.2);
    walk(walker, stage, {}, 30);
    EXPECT_TRUE(walker.crouching()); // no room to stand up
    EXPECT_LT(walker.depth(stage.surroundings()), 0.01);
}

TEST_P(WalkerOf, IsCarriedByWhatItStandsOn)
{
    stage.setGround(flat);
    const io::ObjectId lift = stage.place(stage.addBox({4, 0.5f, 4}), {0, 0, 0});
    start({0.5, 0.6, 0.5});
    ASSERT_EQ(walker.ground(), lift);
    for (int i = 1; i <= 120; ++i) {
        const glm::dvec3 before = stage.scene.at(lift).transform.position, after{0.01 * i, 0.02 * i, 0};
        stage.move(lift, after);
        walker.carry(glm::dmat4{glm::dvec4{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {after - before, 1}}, 0, stage.surroundings());
        walker.step({}, stage.surroundings());
        EXPECT_TRUE(walker.grounded()) << i;
        EXPECT_LT(walker.depth(stage.surroundings()), 0.01) << i;
    }
    EXPECT_NEAR(walker.feet().x, 1.7, 0.02);
    EXPECT_NEAR(walker.feet().y, 2.9, 0.02);
}

TEST_P(WalkerOf, BeginsAboveTheGroundAndOutsideOfWalls)
{
    stage.setGround(flat);
    stage.place(stage.addBox({2, 5, 2}), {4, 0, 0});
    walker.put({0, -20, 0}, 0, 0, stage.surroundings());
    EXPECT_GE(walker.feet().y, 0);
    walker.put({4, 0, 0.2}, 0, 0, stage.surroundings());
    EXPECT_LT(walker.depth(stage.surroundings()), 0.01);
}

TEST_P(WalkerOf, BeginsAboveTheGroundAlsoBesideAWallOnASlope)
{
    const auto slope = [](double x, double) { return -x * 0.9; }; // 42 degrees
    stage.setGround(slope);
    stage.place(stage.addBox({8, 30, 8}), {0, -15, 0});
    for (const double x : {-3.0, -1.0, 0.0, 1.0, 3.0}) {
        walker.put({x, slope(x, 0), 0.3}, 0, 0, stage.surroundings());
        EXPECT_GE(walker.feet().y, *io::groundHeight(stage.scene, walker.feet().x, walker.feet().z) - 0.01) << x;
        EXPECT_LT(walker.depth(stage.surroundings()), 0.01) << x;
        walk(walker, stage, {}, 120);
        EXPECT_GE(walker.feet().y, *io::groundHeight(stage.scene, walker.feet().x, walker.feet().z) - 0.01) << x;
    }
}

TEST_P(WalkerOf, FallsThroughHolesOnly)
{
    stage.setGround(flat);
    std::vector<std::uint32_t> cover(65 * 65, 0);
    for (int z = 28; z < 36; ++z)
        for (int x = 28; x < 36; ++x)
            cover[std::size_t(z * 65 + x)] = io::kHoleBit;
    stage.scene.exchange(std::make_shared<const io::CoverMap>(glm::ivec2{65, 65}, std::span<const std::uint32_t>{cover}));
    stage.place(stage.addBox({30, 1, 30}), {0, -6, 0});
    start({0, 0.5, 8});
    EXPECT_NEAR(walker.feet().y, 0, 0.01);
    walk(walker, stage, kAhead, 240);
    EXPECT_NEAR(walker.feet().y, -5, 0.01);
}

TEST_P(WalkerOf, MeshesWithoutAreaDoNoHarm)
{
    stage.setGround(flat);
    io::Model flatModel = io::boxModel({1, 1, 1}, glm::vec4{1});
    for (io::Vertex& vertex : flatModel.vertices)
        vertex.position = {0, 0, 0};
    flatModel.bounds = {{0, 0, 0}, {0, 0, 0}};
    stage.place(stage.addTemplate("nothing", io::Collision::Mesh, flatModel), {0, 0, -2});
    stage.place(stage.addBox({1, 1, 1}, io::Collision::Mesh), {0, 0, -6}, {}, {1e-6f, 1e-6f, 1e-6f});
    start({0, 0, 0});
    walk(walker, stage, kAhead, 240, [&] { EXPECT_TRUE(std::isfinite(walker.feet().y)); });
}

// Walked against from everywhere: never inside, never below, never NaN.
TEST_P(WalkerOf, AHundredThingsAreWalkedAgainst)
{
    io::Random random{17};
    stage.setGround([&](double x, double z) { return std::sin(x * 0.2) * 2 + std::cos(z * 0.17) * 2; });
    std::vector<io::TemplateId> kinds;
    for (const io::Collision collision : {io::Collision::Box, io::Collision::Capsule, io::Collision::Hull, io::Collision::Mesh})
        kinds.push_back(stage.addBox({1.5f, 2, 1}, collision));
    for (int i = 0; i < 100; ++i) {
        const double x = random.range(-25, 25), z = random.range(-25, 25);
        const float size = random.range(0.3f, 2);
        stage.place(kinds[std::size_t(i % 4)], {x, *stage.scene.heights()->height(x, z) - 0.2, z}, {random.range(-30, 30), random.range(0, 360), random.range(-30, 30)},
                    {size, random.range(0.3f, 2), i % 3 ? size : -size});
    }
    start({0, 6, 0});
    for (int i = 0; i < 120; ++i) {
        const Wish wish{.move = {random.signedUnit(), 1}, .yaw = random.range(-4, 4), .run = random.chance(0.5f), .crouch = random.chance(0.1f), .jump = random.chance(0.3f)};
        walk(walker, stage, wish, 30, [&] {
            ASSERT_LT(walker.depth(stage.surroundings()), 0.01);
            ASSERT_GT(walker.feet().y, *stage.scene.heights()->height(walker.feet().x, walker.feet().z) - 0.01);
        });
        if (HasFatalFailure()) FAIL() << i;
    }
}

TEST_P(WalkerOf, ClimbsAStepOfTheVeryHeightItMayAndNoHigherOne)
{
    stage.setGround(flat);
    stage.place(stage.addBox({3, walker.likes().step, 3}), {0, 0, -4});
    stage.place(stage.addBox({3, walker.likes().step + 0.02f, 3}), {8, 0, -4});
    start({0, 0, 0});
    walk(walker, stage, kAhead, 120);
    EXPECT_NEAR(walker.feet().y, double(walker.likes().step), 0.01);
    start({8, 0, 0});
    walk(walker, stage, kAhead, 120);
    EXPECT_NEAR(walker.feet().y, 0, 0.01);
}

TEST_P(WalkerOf, BeginsOutsideOfTheSolidOfAMesh)
{
    stage.setGround(flat);
    stage.place(stage.addBox({8, 6, 8}, io::Collision::Mesh), {0, 0, 0}, {0, 30, 0}); // walls alone: nothing touches one in its middle
    walker.put({0, 1, 0}, 0, 0, stage.surroundings());
    EXPECT_FALSE(stage.surroundings().buried(walker.centre()));
    EXPECT_LT(walker.depth(stage.surroundings()), 0.01);
    const glm::dvec3 inside = glm::abs(walker.feet());
    EXPECT_TRUE(inside.x > 3.5 || inside.z > 3.5 || inside.y > 5.9);
}

TEST_P(WalkerOf, BeginsInTheRoomOfAMeshWhereOneStands)
{
    stage.setGround(flat);
    io::Model room = io::boxModel({8, 6, 8}, glm::vec4{1});
    for (std::size_t i = 0; i + 2 < room.indices.size(); i += 3)
        std::swap(room.indices[i + 1], room.indices[i + 2]); // its faces look inwards
    stage.place(stage.addTemplate("room", io::Collision::Mesh, room), {0, -0.1, 0});
    walker.put({1, 0.5, 1}, 0, 0, stage.surroundings());
    EXPECT_NEAR(walker.feet().x, 1, 0.01);
    EXPECT_NEAR(walker.feet().z, 1, 0.01);
}

TEST_P(WalkerOf, BeginsAtTheEdgeOfTheMapWhereItsStartLiesBesideIt)
{
    stage.setGround(flat);
    for (const glm::dvec3& beside : {glm::dvec3{500, 3, 0}, {0, 3, -90}, {-40, -10, 40}}) {
        walker.put(beside, 0, 0, stage.surroundings());
        walk(walker, stage, {}, 240);
        EXPECT_TRUE(walker.grounded()) << beside.x;
        EXPECT_NEAR(walker.feet().y, 0, 0.01) << beside.x;
        EXPECT_LT(std::max(std::abs(walker.feet().x), std::abs(walker.feet().z)), 32) << beside.x;
    }
}

TEST_P(WalkerOf, ComesBackToWhereItStoodFromWhereThereIsNothing)
{
    stage.place(stage.addBox({4, 1, 4}), {0, -1, 0}); // a world without ground
    start({0, 0, 0});
    walk(walker, stage, kAhead, 180);
    EXPECT_LT(walker.feet().y, -2);
    const double edge = walker.feet().z;
    walk(walker, stage, {}, 900); // 200 m take 7 s
    EXPECT_TRUE(walker.grounded());
    EXPECT_NEAR(walker.feet().y, 0, 0.01);
    EXPECT_GT(walker.feet().z, edge);
}

TEST_P(WalkerOf, SwimsWhereTheWaterIsDeepAndWalksOutOfIt)
{
    stage.setGround([](double, double z) { return std::clamp(z * 0.4, -6.0, 4.0); });
    io::Environment lake;
    lake.water.on = true;
    lake.water.level = 0;
    stage.scene.exchange(lake);
    start({0, 3.2, 8});
    EXPECT_FALSE(walker.swimming());
    walk(walker, stage, kAhead, 600); // into it
    ASSERT_TRUE(walker.swimming());
    const double from = walker.feet().z;
    walk(walker, stage, kAhead, 60);
    EXPECT_NEAR(from - walker.feet().z, double(walker.likes().swim), 0.1);
    walk(walker, stage, {.move = {0, 1}, .pitch = -1}, 240, [&] { EXPECT_LT(walker.depth(stage.surroundings()), 0.01); }); // down, as far as one looks down
    EXPECT_LT(walker.feet().y, -2.5);
    walk(walker, stage, {.jump = true}, 240); // up to the surface and no further
    EXPECT_NEAR(walker.feet().y, -0.7 * 1.8, 0.3);
    walker.put(walker.feet(), 180, 0, stage.surroundings());
    walk(walker, stage, kAhead, 1500);
    EXPECT_FALSE(walker.swimming());
    EXPECT_TRUE(walker.grounded());
    EXPECT_GT(walker.feet().y, 0);
}

} // namespace
} // namespace play
