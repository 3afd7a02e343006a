#include "io/scene/instances.h"

#include "io/base/random.h"
#include "io/scene/scene.h"

#include <gtest/gtest.h>

namespace io {
namespace {

std::shared_ptr<const InstanceTile> tileOf(std::size_t count)
{
    InstanceTile tile;
    for (std::size_t i = 0; i < count; ++i)
        tile.instances.push_back({.x = std::uint16_t(i * 7), .z = std::uint16_t(i * 3), .y = int(i)});
    return std::make_shared<const InstanceTile>(std::move(tile));
}

TEST(Instances, HoldAPlaceToTheMillimetreAndATurnToAHundredthOfADegree)
{
    for (const glm::dvec3 position : {glm::dvec3{0, 0, 0}, {63.9999, 12.3456, -0.0001}, {-5e6 + 0.3333, 8848.86, 9.9e6}, {-64, -11000, 64}}) {
        for (const glm::vec3 rotation : {glm::vec3{0}, {12.34f, 271.3f, -89.7f}, {-400, 1000, 180}}) {
            const PlacedInstance placed = instanceAt({position, rotation, glm::vec3{1.37f}}, 3, kPaintedInstance);
            const Transform held = transformOf(placed.tile, placed.instance);
            EXPECT_LE(glm::distance(held.position, position), 0.001);
            EXPECT_GT(glm::abs(glm::dot(orientation(held.rotation), orientation(rotation))), 1 - 1e-8);
            EXPECT_EQ(held.scale, glm::vec3{1.37f});
            EXPECT_EQ(placed.tile, instanceTileAt(position));
            EXPECT_EQ(placed.instance.species, 3);
            EXPECT_EQ(placed.instance.flags, kPaintedInstance);
            const PlacedInstance again = instanceAt(held, 3, kPaintedInstance); // an object in between loses nothing
            EXPECT_EQ(again.instance, placed.instance);
            EXPECT_EQ(again.tile, placed.tile);
        }
    }
}

TEST(Instances, ErasedSquaresAreKnownByWhatStoodThere)
{
    InstanceTile tile;
    const Instance there{.x = 5 * 1024 + 100, .z = 63 * 1024}, beside{.x = 6 * 1024, .z = 63 * 1024};
    EXPECT_FALSE(isErased(tile, there));
    markErased(tile, there);
    EXPECT_TRUE(isErased(tile, there));
    EXPECT_FALSE(isErased(tile, beside));
    EXPECT_FALSE(tile.empty());
    unmarkErased(tile, {5, 63});
    EXPECT_TRUE(tile.empty());
}

TEST(Instances, ExchangingATileWithItsAnswerIsTheInverse)
{
    Scene scene;
    scene.exchange({ScatterLayer{.id = ScatterId{1}, .name = "firs"}});
    const LayerTile tile{ScatterId{1}, {-3, 7}};
    scene.exchange(tile, tileOf(10));
    const Scene before = scene;
    const std::uint64_t hash = instanceHash(scene.instances(tile.layer));

    auto held = scene.exchange(tile, tileOf(11));
    EXPECT_FALSE(sameContent(scene, before));
    EXPECT_NE(instanceHash(scene.instances(tile.layer)), hash);
    const InstanceTile* const shared = held.get();
    held = scene.exchange(tile, std::move(held));
    EXPECT_EQ(held->instances.size(), 11u);
    EXPECT_EQ(scene.find(tile), shared);
    EXPECT_TRUE(sameContent(scene, before));
    EXPECT_EQ(instanceHash(scene.instances(tile.layer)), hash);
    scene.exchange(tile, std::make_shared<const InstanceTile>()); // an empty one is none
    EXPECT_TRUE(scene.instances(tile.layer).empty());
}

TEST(Instances, AreCountedAndFoundOnlyWhileTheirLayerIsListed)
{
    Scene scene;
    const ScatterId id = scene.freshScatterId();
    scene.exchange({id, {2, 2}}, tileOf(5));
    EXPECT_EQ(scene.instanceCount(), 0u);
    const ObjectId number = scene.idOf({{id, {2, 2}}, 4});
    EXPECT_TRUE(isInstance(number));
    EXPECT_FALSE(scene.findInstance(number));
    scene.exchange({ScatterLayer{.id = id, .name = "firs"}});
    EXPECT_EQ(scene.instanceCount(), 5u);
    EXPECT_EQ(scene.findInstance(number), (InstanceRef{{id, {2, 2}}, 4}));
    EXPECT_FALSE(scene.findInstance(ObjectId{io::number(number) + 1}));
    EXPECT_NE(scene.freshScatterId(), id);
}

TEST(Instances, NumbersNameEachInstanceOnceWhateverTilesGrowAndGo)
{
    Scene scene;
    Random random{5};
    std::map<LayerTile, std::size_t> counts;
    for (int step = 0; step < 2000; ++step) {
        const LayerTile tile{ScatterId(1 + random.below(2)), {random.below(5), random.below(5)}};
        const std::size_t count = std::size_t(random.unit() * random.unit() * 600);
        scene.exchange(tile, tileOf(count));
        counts[tile] = count;
    }
    scene.exchange({ScatterLayer{.id = ScatterId{1}, .name = "a"}, ScatterLayer{.id = ScatterId{2}, .name = "b"}});
    std::map<ObjectId, InstanceRef> seen;
    for (const auto& [tile, count] : counts)
        for (std::uint32_t i = 0; i < count; ++i) {
            const ObjectId id = scene.idOf({tile, i});
            ASSERT_TRUE(isInstance(id));
            ASSERT_TRUE(seen.emplace(id, InstanceRef{tile, i}).second);
            ASSERT_EQ(scene.findInstance(id), (InstanceRef{tile, i}));
        }
    EXPECT_EQ(seen.size(), scene.instanceCount());
    EXPECT_LT(io::number(seen.rbegin()->first) - kFirstInstanceId, 200'000u); // blocks are used again
}

} // namespace
} // namespace io
