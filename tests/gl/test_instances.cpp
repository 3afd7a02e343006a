// Instances of scatter layers are drawn as objects are, and followed by the tile.
#include "io/base/random.h"
#include "renderer/world.h"
#include "tests/gl/support/shared_renderer.h"

#include <gtest/gtest.h>

namespace {

constexpr glm::ivec2 kSize{320, 180};
constexpr std::uint64_t kUploaded = sizeof(glsl::Instance) + sizeof(glsl::CullRecord);
const io::Camera kFront{.eye = {0, 20, 60}, .pitch = -15};
const io::ScatterId kLayer{1};

test::TestWorld twoKinds()
{
    test::TestWorld world;
    test::addTemplate(world, "box", test::box({1, 2, 1}, glm::vec4{1}));
    test::addTemplate(world, "post", test::box({0.4f, 5, 0.4f}, glm::vec4{0.6f, 0.2f, 0.1f, 1}));
    world.scene.exchange({io::ScatterLayer{.id = kLayer, .name = "things", .species = {{.templateName = "box"}, {.templateName = "post"}}}});
    return world;
}

io::PlacedInstance anyInstance(io::Random& random)
{
    const glm::dvec3 at{random.range(-70, 70), random.range(0, 4), random.range(-90, 30)};
    return io::instanceAt({.position = at, .rotation = {random.range(-8, 8), random.range(0, 360), 0}, .scale = glm::vec3{random.range(0.5f, 2)}}, random.below(2));
}

void plant(io::Scene& scene, int count, std::uint64_t seed)
{
    io::Random random{seed};
    std::map<glm::ivec2, io::InstanceTile, io::TileOrder> tiles;
    for (int i = 0; i < count; ++i) {
        const io::PlacedInstance placed = anyInstance(random);
        tiles[placed.tile].instances.push_back(placed.instance);
    }
    for (auto& [place, tile] : tiles)
        scene.exchange({kLayer, place}, std::make_shared<const io::InstanceTile>(std::move(tile)));
}

// Each has its record where it stands, and nothing else is there.
void expectFollowed(const renderer::World& gpu, const io::Scene& scene)
{
    EXPECT_EQ(gpu.instances(), scene.instanceCount() + scene.objects().size());
    for (const auto& [place, tile] : scene.instances(kLayer))
        for (std::uint32_t i = 0; i < tile->instances.size(); ++i) {
            const glsl::CullRecord* record = gpu.recordOf(scene.idOf({{kLayer, place}, i}));
            ASSERT_TRUE(record);
            const io::Transform transform = io::transformOf(place, tile->instances[i]);
            ASSERT_LT(glm::distance(glm::dvec3{record->centre}, transform.position), 6.0 * transform.scale.x);
        }
}

TEST(Instances, LookAsObjectsAtTheirPlacesDo)
{
    test::TestWorld world = twoKinds();
    plant(world.scene, 400, 7);
    test::load(world);
    const renderer::FrameInput in = test::frame(kSize, kFront);
    test::shared().render(in);
    const std::vector<std::uint32_t> ids = test::shared().readIds({0, 0}, kSize);
    const io::Image picture = test::shared().readPicture();
    const renderer::FrameStats stats = test::shared().stats();
    EXPECT_EQ(stats.instances, 400u);

    test::TestWorld objects = twoKinds();
    std::map<std::uint32_t, io::InstanceRef> instanceOf;
    for (const auto& [place, tile] : world.scene.instances(kLayer))
        for (std::uint32_t i = 0; i < tile->instances.size(); ++i) {
            const io::ObjectId id = test::addObject(objects, io::TemplateId{1u + tile->instances[i].species}, io::transformOf(place, tile->instances[i]));
            instanceOf[io::number(id)] = {{kLayer, place}, i};
        }
    test::load(objects);
    test::shared().render(in);
    EXPECT_EQ(test::shared().readPicture().bytes, picture.bytes);
    const std::vector<std::uint32_t> objectIds = test::shared().readIds({0, 0}, kSize);
    int seen = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const auto instance = world.scene.findInstance(io::ObjectId{ids[i]});
        const auto object = instanceOf.find(objectIds[i]);
        ASSERT_EQ(bool(instance), object != instanceOf.end());
        if (instance) {
            ASSERT_EQ(*instance, object->second);
        }
        seen += bool(instance);
    }
    EXPECT_GT(seen, 1000);
}

class InstancesMirror : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(test::haveContext()); }
    void update(const io::Changes& changes)
    {
        gpu.update(world.scene, world.assets, changes);
        gpu.upload(true);
    }
    test::TestWorld world = twoKinds();
    renderer::World gpu;
};

TEST_F(InstancesMirror, AChangedTileUploadsWhatChangedInIt)
{
    plant(world.scene, 3000, 3);
    update({.everything = true});
    expectFollowed(gpu, world.scene);
    const std::uint64_t before = gpu.uploadedBytes();
    const io::LayerTile at{kLayer, {0, -1}};
    io::InstanceTile tile = *world.scene.find(at);
    tile.instances[5].y += 2048;
    tile.instances.push_back(tile.instances[0]);
    world.scene.exchange(at, std::make_shared<const io::InstanceTile>(tile));
    update({.instances = {at}});
    EXPECT_LE(gpu.uploadedBytes() - before, 2 * kUploaded) << "one moved and one came";
    expectFollowed(gpu, world.scene);
}

TEST_F(InstancesMirror, FollowsTilesThatGrowShrinkAndGo)
{
    plant(world.scene, 300, 3);
    update({.everything = true});
    io::Random random{9};
    for (int step = 0; step < 200; ++step) {
        std::vector<io::LayerTile> changed;
        for (int i = random.below(3); i >= 0; --i) {
            const io::LayerTile at{kLayer, {random.below(4) - 2, random.below(3) - 2}};
            const io::InstanceTile* now = world.scene.find(at);
            io::InstanceTile tile = now ? *now : io::InstanceTile{};
            if (random.chance(0.2f)) tile.instances.clear();
            else if (random.chance(0.5f)) tile.instances.resize(tile.instances.size() * 2 / 3);
            else
                for (int more = random.below(200); more > 0; --more)
                    tile.instances.push_back(anyInstance(random).instance);
            world.scene.exchange(at, std::make_shared<const io::InstanceTile>(std::move(tile)));
            changed.push_back(at);
        }
        std::sort(changed.begin(), changed.end());
        changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
        update({.instances = changed});
    }
    expectFollowed(gpu, world.scene);
}

TEST_F(InstancesMirror, GoAndComeBackWithTheirLayerAndItsSpecies)
{
    plant(world.scene, 200, 3);
    update({.everything = true});
    std::vector<io::ScatterLayer> layers = world.scene.exchange(std::vector<io::ScatterLayer>{});
    update({.scatter = true});
    EXPECT_EQ(gpu.instances(), 0u);
    layers[0].species[1].templateName = "nothing";
    world.scene.exchange(layers);
    update({.scatter = true});
    EXPECT_GT(gpu.instances(), 50u);
    EXPECT_LT(gpu.instances(), 150u);
    layers[0].species[1].templateName = "post";
    world.scene.exchange(layers);
    update({.scatter = true});
    expectFollowed(gpu, world.scene);
    world.assets.models[0] = test::box({3, 3, 3}, glm::vec4{1});
    update({.templates = {io::TemplateId{1}}});
    expectFollowed(gpu, world.scene);
}

} // namespace
