// Any size, any mode, any content: a picture, and no word from OpenGL.
#include "tests/gl/support/shared_renderer.h"

#include <gtest/gtest.h>

namespace {

TEST(Frames, OddSizesAndAnEmptyScene)
{
    test::TestWorld world;
    test::load(world);
    for (const glm::ivec2 size : {glm::ivec2{1, 1}, {333, 177}, {2, 500}, {640, 3}, {320, 180}}) {
        renderer::FrameInput in = test::frame(size, {});
        in.settings.antiAliasing = renderer::AntiAliasing::Fxaa;
        const renderer::Picture picture = test::shared().render(in);
        EXPECT_EQ(picture.size, size);
        const io::Image image = test::shared().readPicture();
        EXPECT_EQ(image.size, size);
        EXPECT_EQ(image.bytes.size(), std::size_t(size.x) * size.y * 4);
        EXPECT_EQ(test::shared().readRadiance().size, size);
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Frames, EveryShowEveryCurveEveryShading)
{
    test::TestWorld world = test::makeWorld({.heightMap = {129, 129}, .trees = 40, .boxes = 10});
    test::load(world);
    renderer::FrameInput in = test::frame({160, 90}, {.eye = {0, 90, 60}, .pitch = -30});
    std::vector<std::vector<std::byte>> seen;
    for (std::size_t i = 0; i < enumNames(renderer::Show{}).size(); ++i) {
        in.show = renderer::Show(i);
        test::shared().render(in);
        std::vector<std::byte> bytes = test::shared().readPicture().bytes;
        for (const auto& other : seen)
            EXPECT_NE(bytes, other) << enumNames(renderer::Show{})[i] << " shows the same as another";
        seen.push_back(std::move(bytes));
    }
    in.show = renderer::Show::Final;
    for (int curve = 0; curve < 4; ++curve)
        for (const renderer::Shading shading : {renderer::Shading::Pbr, renderer::Shading::BlinnPhong}) {
            in.settings.toneMap = renderer::ToneMap(curve);
            in.settings.shading = shading;
            test::shared().render(in);
            std::vector<std::byte> bytes = test::shared().readPicture().bytes;
            if (curve == 0 && shading == renderer::Shading::Pbr) continue; // the first picture once more
            for (const auto& other : seen)
                EXPECT_NE(bytes, other);
            seen.push_back(std::move(bytes));
        }
    EXPECT_TRUE(test::shared().shaderFaults().empty());
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Frames, SelectionGhostsAndLinesAreSeen)
{
    test::TestWorld world;
    const io::TemplateId id = test::addTemplate(world, "box", test::box({1, 1, 1}, glm::vec4{0.5f, 0.5f, 0.5f, 1}));
    const io::ObjectId object = test::addObject(world, id, {});
    world.scene.exchange(test::plainEnvironment(150, 50));
    test::load(world);
    const io::Camera camera{.eye = {0, 1.5, 5}, .pitch = -10};
    renderer::FrameInput in = test::frame({320, 180}, camera);
    test::shared().render(in);
    const io::Image plain = test::shared().readPicture();
    const auto changedAt = [&](const glm::dvec3& place) {
        const auto pixel = renderer::project(camera, in.size, place);
        const io::Image now = test::shared().readPicture();
        const auto texel = [&](const io::Image& image) { return glm::ivec4{image.row<glm::u8vec4>(int(pixel->y))[int(pixel->x)]}; };
        return texel(now) - texel(plain);
    };
    const std::vector<io::ObjectId> selection{object};
    in.selection = selection;
    test::shared().render(in);
    EXPECT_GT(changedAt({0, 0.5, 0.5}).z, changedAt({0, 0.5, 0.5}).y + 5) << "violet";
    const auto corner = renderer::project(camera, in.size, {0.5, 0.5, 0.5});
    const glm::u8vec4 line = test::shared().readPicture().row<glm::u8vec4>(int(corner->y))[int(corner->x) + 2];
    EXPECT_GT(line.z, 180) << "outlined";

    in.selection = {};
    const std::vector<renderer::Ghost> ghosts{{id, {.position = {1.5, 0, 0}}}};
    in.ghosts = ghosts;
    test::shared().render(in);
    EXPECT_NE(changedAt({1.5, 0.5, 0.5}), glm::ivec4{0});
    EXPECT_EQ(test::shared().readIds({0, 0}, in.size), test::shared().readIds({0, 0}, in.size));

    in.ghosts = {};
    const std::vector<renderer::Line> lines{{{-1.5, 0.5, 0}, {1.5, 0.5, 0}, {1, 0, 0, 1}, false},
                                            {{-1.5, 0.8, 0}, {1.5, 0.8, 0}, {1, 0, 0, 1}, true},
                                            {{0, 0.5, 4}, {0, 0.5, 900}, {0, 1, 0, 1}, true}}; // runs behind the eye
    in.lines = lines;
    test::shared().render(in);
    EXPECT_GT(changedAt({-1, 0.5, 0}).x, 30);
    EXPECT_EQ(changedAt({0, 0.5, 0.5}), glm::ivec4{0}) << "hidden by the box";
    const auto front = renderer::project(camera, in.size, {0, 0.8, 0});
    EXPECT_GT(test::shared().readPicture().row<glm::u8vec4>(int(front->y))[int(front->x)].x, 200) << "on top of it";
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Frames, ThumbnailsAreKeptAndDoNotDisturbThePicture)
{
    test::TestWorld world = test::makeWorld({.heightMap = {33, 33}, .trees = 3, .boxes = 1});
    test::load(world);
    const renderer::FrameInput in = test::frame({160, 90}, {.eye = {0, 90, 60}, .pitch = -30});
    test::shared().render(in);
    const auto before = test::shared().readPicture().bytes;
    const renderer::Picture first = test::shared().thumbnail(io::TemplateId{1}, 96);
    EXPECT_NE(first.texture, 0u);
    EXPECT_EQ(first.size, glm::ivec2(96));
    EXPECT_EQ(test::shared().thumbnail(io::TemplateId{1}, 96).texture, first.texture);
    EXPECT_NE(test::shared().thumbnail(io::TemplateId{999}, 64).texture, 0u) << "an unknown one is an empty studio";
    test::shared().render(in);
    EXPECT_EQ(before, test::shared().readPicture().bytes);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Frames, RaysAndProjectionAreEachOthersInverse)
{
    const io::Camera camera{.eye = {10, 20, 30}, .yaw = 40, .pitch = -25, .fov = 70};
    constexpr glm::ivec2 kSize{333, 177};
    for (const glm::dvec2 pixel : {glm::dvec2{0.5, 0.5}, {332.5, 0.5}, {100.25, 90}, {166.5, 88.5}}) {
        const io::Ray ray = renderer::rayThrough(camera, kSize, pixel);
        const auto back = renderer::project(camera, kSize, ray.origin + ray.direction * 57.0);
        ASSERT_TRUE(back);
        EXPECT_NEAR(back->x, pixel.x, 1e-9);
        EXPECT_NEAR(back->y, pixel.y, 1e-9);
    }
    EXPECT_FALSE(renderer::project(camera, kSize, camera.eye - io::forward(camera)));
    const io::Ray middle = renderer::rayThrough(camera, kSize, glm::dvec2{kSize} / 2.0);
    EXPECT_NEAR(glm::dot(middle.direction, io::forward(camera)), 1, 1e-12);
}

} // namespace
