// The GPU's mirror follows the scene at the price of what changed.
#include "renderer/world.h"
#include "tests/gl/support/shared_renderer.h"

#include <gtest/gtest.h>

namespace {

constexpr glm::ivec2 kSize{320, 180};
constexpr std::uint64_t kUploaded = sizeof(glsl::Instance) + sizeof(glsl::CullRecord);
const io::Camera kFront{.eye = {0, 1, 12}};

struct Mirror {
    test::TestWorld world;
    renderer::World gpu;

    void update(const io::Changes& changes)
    {
        gpu.update(world.scene, world.assets, changes);
        gpu.upload(true);
    }
};

class WorldTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(test::haveContext()); }
};

TEST_F(WorldTest, MovingOneObjectUploadsOneRecord)
{
    Mirror m{test::makeWorld({.heightMap = {0, 0}, .trees = 3000, .boxes = 0}), {}};
    m.update({.everything = true});
    const std::uint64_t before = m.gpu.uploadedBytes();
    const io::ObjectId id = m.world.scene.objects()[1234].id;
    io::Object moved = m.world.scene.at(id);
    moved.transform.position.x += 1;
    m.world.scene.exchange(id, moved);
    m.update({.objects = {id}});
    EXPECT_EQ(m.gpu.uploadedBytes() - before, kUploaded);

    m.world.scene.exchange(id, std::nullopt);
    m.update({.objects = {id}});
    EXPECT_EQ(m.gpu.uploadedBytes() - before, 2 * kUploaded) << "the last one took its place";
    EXPECT_EQ(m.gpu.instances(), 2999u);
    EXPECT_FALSE(m.gpu.modelOf(io::TemplateId::None));
}

TEST_F(WorldTest, ReplacedModelsDoNotPileUp)
{
    Mirror m{test::makeWorld({.heightMap = {0, 0}, .trees = 3, .boxes = 2}), {}};
    m.update({.everything = true});
    for (int i = 0; i < 60; ++i) {
        m.world.assets.models[1] = test::box({1, 1 + float(i), 1}, glm::vec4{1});
        m.update({.templates = {io::TemplateId{2}}});
    }
    EXPECT_LT(m.gpu.sharedModels().size(), 20);
    EXPECT_EQ(m.gpu.instances(), 5u);
    EXPECT_FLOAT_EQ(m.gpu.modelOf(io::TemplateId{2}).entry().bounds.max.y, 60);
}

TEST_F(WorldTest, GroupsAndUnknownTemplatesAreNotDrawn)
{
    Mirror m;
    test::addObject(m.world, io::TemplateId::None, {});
    test::addObject(m.world, io::TemplateId{77}, {});
    m.update({.everything = true});
    EXPECT_EQ(m.gpu.instances(), 0u);
}

std::vector<std::uint32_t> idsOf(const renderer::FrameInput& in)
{
    test::shared().render(in);
    return test::shared().readIds({0, 0}, in.size);
}

TEST(WorldPicture, TheObjectAtThePixelIsTheOneThatStandsThere)
{
    test::TestWorld world;
    const io::TemplateId id = test::addTemplate(world, "box", test::box({1, 1, 1}, glm::vec4{1}));
    std::vector<io::ObjectId> objects;
    for (int i = -2; i <= 2; ++i)
        objects.push_back(test::addObject(world, id, {.position = {i * 2.0, 0, 0}}));
    // A mirrored copy keeps its front: nothing of its inside is to be seen.
    objects.push_back(test::addObject(world, id, {.position = {0, 3, 0}, .scale = {-1, 1, 1}}));
    test::load(world);
    idsOf(test::frame(kSize, kFront));
    for (int i = 0; i < 6; ++i) {
        const glm::dvec3 centre = world.scene.at(objects[std::size_t(i)]).transform.position + glm::dvec3{0, 0.5, 0.5};
        const auto pixel = renderer::project(kFront, kSize, centre);
        ASSERT_TRUE(pixel);
        EXPECT_EQ(test::shared().readIds(glm::ivec2{*pixel}, {1, 1})[0], io::number(objects[std::size_t(i)])) << i;
    }
    EXPECT_EQ(test::shared().readIds({-5, -5}, {3, 3}), std::vector<std::uint32_t>(9, 0u)) << "outside is nobody";
}

TEST(WorldPicture, WhatIsDrawnElsewhereComesBackWithTheNextUpdate)
{
    test::TestWorld world;
    const io::TemplateId box = test::addTemplate(world, "box", test::box({1, 1, 1}, glm::vec4{1}));
    const io::ObjectId id = test::addObject(world, box, {.position = {-2, 0, 0}});
    test::load(world);
    const auto idAt = [&](const glm::dvec3& place) {
        idsOf(test::frame(kSize, kFront));
        return test::shared().readIds(glm::ivec2{*renderer::project(kFront, kSize, place + glm::dvec3{0, 0.5, 0.5})}, {1, 1})[0];
    };
    const std::vector<io::Moved> moved{{id, {.position = {2, 0, 0}}}, {io::ObjectId{4711}, {}}};
    test::shared().move(moved);
    EXPECT_EQ(idAt({2, 0, 0}), io::number(id));
    EXPECT_EQ(idAt({-2, 0, 0}), 0u);
    test::shared().update(world.scene, world.assets, {.objects = {id}});
    EXPECT_EQ(idAt({2, 0, 0}), 0u);
    EXPECT_EQ(idAt({-2, 0, 0}), io::number(id));
}

TEST(WorldPicture, IsTheSameWhereIdsAreNotKept)
{
    test::TestWorld world;
    const io::TemplateId id = test::addTemplate(world, "box", test::box({1, 1, 1}, glm::vec4{1}));
    const io::ObjectId object = test::addObject(world, id, {});
    test::load(world);
    renderer::FrameInput in = test::frame(kSize, kFront);
    in.ids = false;
    test::shared().render(in);
    const io::Image without = test::shared().readPicture();
    in.ids = true;
    const std::vector<std::uint32_t> ids = idsOf(in);
    EXPECT_TRUE(std::ranges::find(ids, io::number(object)) != ids.end());
    EXPECT_EQ(test::shared().readPicture().bytes, without.bytes);
    in.ids = false;
    in.show = renderer::Show::Id; // needs them all the same
    test::shared().render(in);
    EXPECT_TRUE(test::shared().readIds({0, 0}, kSize) == ids);
}

TEST(WorldPicture, FarFromTheOriginThingsStandStill)
{
    for (const double far : {0.0, 90000.0}) {
        test::TestWorld world;
        const io::TemplateId id = test::addTemplate(world, "box", test::box({1, 1, 1}, glm::vec4{1}));
        const io::ObjectId object = test::addObject(world, id, {.position = {far + 0.125, 0, far}});
        test::load(world);
        const auto ids = idsOf(test::frame(kSize, {.eye = {far + 0.125, 0.5, far + 2.5}}));
        // Edges of a face of 1 m seen from 2 m.
        int width = 0;
        for (int x = 0; x < kSize.x; ++x)
            width += ids[std::size_t(kSize.y / 2 * kSize.x + x)] == io::number(object);
        EXPECT_EQ(width, 78) << far;
    }
}

TEST(WorldPicture, MarkersCanBeHidden)
{
    test::TestWorld world;
    const io::TemplateId id = world.scene.templateSlot("start");
    world.scene.exchange(id, io::Template{.name = "start"});
    world.assets.models = {test::box({1, 1, 1}, {1, 0.5f, 0, 1})};
    const io::ObjectId object = test::addObject(world, id, {});
    test::load(world);
    renderer::FrameInput in = test::frame(kSize, kFront);
    const auto shown = idsOf(in);
    in.markers = false;
    const auto hidden = idsOf(in);
    EXPECT_GT(std::count(shown.begin(), shown.end(), io::number(object)), 50);
    EXPECT_EQ(std::count(hidden.begin(), hidden.end(), io::number(object)), 0);
}

TEST(WorldPicture, ThreeHundredTexturesEachKeepTheirColour)
{
    test::TestWorld world;
    constexpr int kColumns = 20, kRows = 15;
    std::vector<glm::u8vec4> colours;
    for (int i = 0; i < kColumns * kRows; ++i) {
        auto model = std::make_shared<io::Model>(*test::box({1, 1, 0.1f}, glm::vec4{1}));
        auto image = std::make_shared<io::Image>();
        image->size = glm::ivec2{1 << (i % 6)};
        const glm::u8vec4 colour{40 + (i * 37) % 200, 40 + (i * 91) % 200, 40 + (i * 53) % 200, 255};
        for (int t = 0; t < image->size.x * image->size.y; ++t)
            for (int c = 0; c < 4; ++c)
                image->bytes.push_back(std::byte(colour[c]));
        model->images = {image};
        model->materials[0].baseColourTexture.image = 0;
        colours.push_back(colour);
        const io::TemplateId id = test::addTemplate(world, "box" + std::to_string(i), model);
        test::addObject(world, id, {.position = {(i % kColumns - 9.5) * 1.1, (i / kColumns - 7.5) * 1.1, 0}});
    }
    test::load(world);
    const io::Camera camera{.eye = {0, 0, 18}};
    renderer::FrameInput in = test::frame({640, 360}, camera);
    in.show = renderer::Show::Albedo;
    test::shared().render(in);
    const io::Image image = test::shared().readPicture();
    for (int i = 0; i < kColumns * kRows; ++i) {
        const auto pixel = renderer::project(camera, image.size, {(i % kColumns - 9.5) * 1.1, (i / kColumns - 7.5) * 1.1 + 0.5, 0.05});
        ASSERT_TRUE(pixel);
        const glm::u8vec4 shown = image.row<glm::u8vec4>(int(pixel->y))[int(pixel->x)];
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(int(shown[c]), int(colours[std::size_t(i)][c]), 2) << i;
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(WorldPicture, MissingImageIsACheckerboardAndNoImageIsPlain)
{
    test::TestWorld world;
    auto missing = std::make_shared<io::Model>(*test::box({2, 2, 2}, glm::vec4{1}));
    missing->images = {nullptr};
    missing->materials[0].baseColourTexture.image = 0;
    auto wild = std::make_shared<io::Model>(*missing);
    wild->images.clear(); // the material names an image that is not there
    test::addObject(world, test::addTemplate(world, "missing", missing), {.position = {-2, 0, 0}});
    test::addObject(world, test::addTemplate(world, "wild", wild), {.position = {2, 0, 0}});
    test::addObject(world, test::addTemplate(world, "empty", std::make_shared<io::Model>()), {});
    test::load(world);
    renderer::FrameInput in = test::frame(kSize, {.eye = {0, 1, 6}});
    in.show = renderer::Show::Albedo;
    test::shared().render(in);
    const io::Image image = test::shared().readPicture();
    for (const double x : {-2.0, 2.0}) {
        const auto pixel = renderer::project(in.camera, kSize, {x, 1, 1});
        int violet = 0;
        for (int dx = -20; dx <= 20; ++dx) {
            const glm::u8vec4 t = image.row<glm::u8vec4>(int(pixel->y))[int(pixel->x) + dx];
            violet += t.x > 200 && t.y < 90;
        }
        EXPECT_GT(violet, 8) << x;
        EXPECT_LT(violet, 34) << x;
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(WorldPicture, BlendedPartsLetTheBackThroughAndCanBePointedAt)
{
    test::TestWorld world;
    auto glass = std::make_shared<io::Model>(*test::box({2, 2, 0.1f}, {0.1f, 0.9f, 0.1f, 0.4f}));
    glass->materials[0].alphaMode = io::AlphaMode::Blend;
    test::addObject(world, test::addTemplate(world, "wall", test::box({6, 6, 0.1f}, {0.9f, 0.1f, 0.1f, 1})), {.position = {0, -2, -3}});
    const io::ObjectId pane = test::addObject(world, test::addTemplate(world, "glass", glass), {});
    world.scene.exchange(test::plainEnvironment(170, 35));
    test::load(world);
    const io::Camera camera{.eye = {0, 1, 6}};
    test::shared().render(test::frame(kSize, camera));
    const io::Image image = test::shared().readPicture();
    const auto at = [&](double x) {
        const auto pixel = renderer::project(camera, kSize, {x, 1, 0});
        return glm::ivec4{image.row<glm::u8vec4>(int(pixel->y))[int(pixel->x)]};
    };
    EXPECT_GT(at(0).y, at(1.6).y + 15) << "greener through the pane";
    EXPECT_GT(at(0).x, 40) << "and still red";
    EXPECT_EQ(test::shared().readIds(kSize / 2, {1, 1})[0], io::number(pane));
}

} // namespace
