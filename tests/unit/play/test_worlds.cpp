// The worlds that ship, walked about in: what random input for an hour and running against a hundred of their things may not do.
#include "app/play/session.h"
#include "io/base/random.h"
#include "io/files/project.h"
#include "io/scene/ground.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace play {
namespace {

struct Shipped {
    io::World world;
    io::Assets assets;
};

Shipped open(const char* name)
{
    io::Complaints complaints;
    auto world = io::openWorld(std::filesystem::path{WOLD_PROJECTS} / name, {}, complaints);
    if (!world) throw std::runtime_error{world.error().text()};
    auto assets = io::readAssets(*world, complaints);
    if (!assets) throw std::runtime_error{assets.error().text()};
    return {*std::move(world), *std::move(assets)};
}

// Never inside of a thing by more than a centimetre, never below the ground, never nowhere.
testing::AssertionResult sound(const Walker& walker, Surroundings& surroundings)
{
    const glm::dvec3& feet = walker.feet();
    if (!std::isfinite(feet.x + feet.y + feet.z)) return testing::AssertionFailure() << "the place is no number";
    if (const double depth = walker.depth(surroundings); !(depth <= 0.01)) return testing::AssertionFailure() << depth << " m inside at " << feet.x << ", " << feet.y << ", " << feet.z;
    const auto ground = io::groundHeight(surroundings.scene(), feet.x, feet.z);
    if (ground && feet.y < *ground - 0.01) return testing::AssertionFailure() << *ground - feet.y << " m below the ground at " << feet.x << ", " << feet.z;
    return testing::AssertionSuccess();
}

TEST(Worlds, AnHourOfRandomInputInTheValley)
{
    const Shipped valley = open("valley");
    Session session{valley.world.scene, valley.assets, {}};
    io::Random random{2};
    Wish wish;
    for (long step = 0; step < 60L * 60 * 60; ++step) {
        if (step % 40 == 0)
            wish = {.move = {random.signedUnit(), random.range(-0.3f, 1)}, .yaw = random.range(-2, 2), .run = random.chance(0.6f), .crouch = random.chance(0.1f), .jump = random.chance(0.3f)};
        session.step(wish);
        ASSERT_TRUE(sound(session.walker(), session.surroundings())) << step;
    }
}

// Things that are met, of as many templates as there are, and planted ones.
std::vector<glm::dvec3> thingsOf(const Shipped& shipped, std::size_t wanted)
{
    Surroundings surroundings{shipped.world.scene, shipped.assets};
    const io::HeightMap& map = *shipped.world.scene.heights();
    const glm::dvec2 low = map.origin, size = glm::dvec2{map.size - 1} * double(map.metresPerTexel);
    io::Random random{5};
    std::set<io::TemplateId> kinds;
    std::vector<glm::dvec3> places;
    std::vector<Standing> found;
    for (int tries = 0; tries < 4000 && places.size() < wanted; ++tries) {
        const glm::dvec3 at{low.x + size.x * double(random.unit()), 0, low.y + size.y * double(random.unit())};
        found.clear();
        surroundings.standing({at - glm::dvec3{6, 1e4, 6}, at + glm::dvec3{6, 1e4, 6}}, found);
        std::erase_if(found, [&](const Standing& thing) { return surroundings.shapes().of(thing.templateId).form == Form::None; });
        if (found.empty()) continue;
        const auto fresh = std::ranges::find_if(found, [&](const Standing& thing) { return kinds.insert(thing.templateId).second; });
        places.push_back((fresh != found.end() ? *fresh : found.front()).transform.position);
    }
    return places;
}

class WorldsOf : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Shipped, WorldsOf, testing::Values("valley", "forest-3"));

TEST_P(WorldsOf, AHundredOfItsThingsAreRunAgainst)
{
    const Shipped shipped = open(GetParam());
    const std::vector<glm::dvec3> places = thingsOf(shipped, 100);
    ASSERT_EQ(places.size(), 100u);
    Surroundings surroundings{shipped.world.scene, shipped.assets};
    Walker walker;
    io::Random random{9};
    std::size_t met = 0;
    for (const glm::dvec3& place : places) {
        bool touched = false;
        for (int side = 0; side < 3; ++side) {
            const double angle = double(random.unit()) * 6.283;
            const glm::dvec3 from = place + glm::dvec3{std::cos(angle), 0, std::sin(angle)} * 8.0;
            const double yaw = glm::degrees(std::atan2(-(place.x - from.x), -(place.z - from.z)));
            walker.put(from + glm::dvec3{0, io::groundHeight(surroundings.scene(), from.x, from.z).value_or(from.y) - from.y + 0.1, 0}, yaw, 0, surroundings);
            for (int step = 0; step < 150; ++step) {
                walker.step({.move = {0, 1}, .run = true, .jump = side == 2 && step % 40 == 30}, surroundings);
                ASSERT_TRUE(sound(walker, surroundings)) << "against what stands at " << place.x << ", " << place.z;
                for (const Touched& thing : walker.touched())
                    touched |= thing.id != io::ObjectId::None;
            }
        }
        met += touched;
    }
    EXPECT_GT(met, 70u) << "some stand behind others";
}

} // namespace
} // namespace play
