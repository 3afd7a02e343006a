// Culling that is frozen stays as it was while the camera flies on, whoever culls.
#include "tests/gl/support/shared_renderer.h"

#include <gtest/gtest.h>
#include <set>

namespace {

using renderer::Culler;

constexpr glm::ivec2 kSize{320, 180};

// Counts of the GPU are of a frame a little earlier.
void renderUntilCounted(const renderer::FrameInput& in)
{
    for (int i = 0; i < 6; ++i)
        test::shared().render(in);
}

std::set<std::uint32_t> idsNow()
{
    const auto ids = test::shared().readIds({0, 0}, kSize);
    return {ids.begin(), ids.end()};
}

renderer::FrameInput looking(const io::Camera& camera, Culler culler)
{
    renderer::FrameInput in = test::frame(kSize, camera);
    in.settings.culler = culler;
    return in;
}

class Freeze : public testing::TestWithParam<Culler> {};

TEST_P(Freeze, WhatIsDrawnStaysWhileTheCameraFliesOn)
{
    test::TestWorld world = test::makeWorld({.heightMap = {257, 257}, .trees = 200, .boxes = 60});
    test::load(world);
    const double ground = *world.scene.heights()->height(0, 0);
    renderer::FrameInput in = looking({.eye = {0, ground + 6, 0}, .yaw = 30, .pitch = -5}, GetParam());
    renderUntilCounted(in);
    const renderer::FrameStats before = test::shared().stats();
    const io::Image seen = test::shared().readPicture();
    ASSERT_GT(before.instancesDrawn, 5u);
    EXPECT_FALSE(before.cullingFrozen);

    in.freezeCulling = true;
    renderUntilCounted(in);
    EXPECT_TRUE(test::shared().stats().cullingFrozen);
    const std::set<std::uint32_t> kept = idsNow();

    in.camera = {.eye = {0, 260, 260}, .pitch = -45}; // from where all of the world is in view
    renderUntilCounted(in);
    EXPECT_EQ(test::shared().stats().instancesDrawn, before.instancesDrawn);
    EXPECT_EQ(test::shared().stats().trianglesDrawn, before.trianglesDrawn) << "of the ground too";
    const std::set<std::uint32_t> fromAbove = idsNow();
    EXPECT_TRUE(fromAbove.contains(0)) << "where no ground was in view there is none";

    in.freezeCulling = false;
    renderUntilCounted(in);
    EXPECT_GT(test::shared().stats().instancesDrawn, 2 * before.instancesDrawn);
    EXPECT_GT(idsNow().size(), 2 * fromAbove.size());

    in.camera = {.eye = {0, ground + 6, 0}, .yaw = 30, .pitch = -5};
    renderUntilCounted(in);
    EXPECT_EQ(seen.bytes, test::shared().readPicture().bytes);
    EXPECT_EQ(kept, idsNow());
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST_P(Freeze, AnotherWorldIsCulledForTheCameraThatLooksThen)
{
    test::TestWorld world;
    const io::TemplateId box = test::addTemplate(world, "box", test::box({1, 1, 1}, glm::vec4{1}));
    const io::ObjectId before = test::addObject(world, box, {.position = {0, 0, -20}});
    const io::ObjectId behind = test::addObject(world, box, {.position = {0, 0, 20}});
    test::load(world);
    renderer::FrameInput in = looking({.eye = {0, 0.5, 0}}, GetParam());
    in.freezeCulling = true;
    test::shared().render(in);
    EXPECT_TRUE(idsNow().contains(io::number(before)));
    in.camera.yaw = 180;
    test::shared().render(in);
    EXPECT_FALSE(idsNow().contains(io::number(behind)));
    test::load(world);
    test::shared().render(in);
    EXPECT_TRUE(idsNow().contains(io::number(behind)));
}

INSTANTIATE_TEST_SUITE_P(Cullers, Freeze, testing::Values(Culler::Cpu, Culler::Gpu),
                         [](const auto& one) { return one.param == Culler::Cpu ? "Cpu" : "Gpu"; });

TEST(FrozenCulling, WhatAWallHidStaysHidden)
{
    test::TestWorld world;
    test::addObject(world, test::addTemplate(world, "wall", test::box({400, 200, 1}, glm::vec4{1})), {.position = {0, -50, -20}});
    const io::TemplateId box = test::addTemplate(world, "box", test::box({1, 1, 1}, glm::vec4{1}));
    for (int i = 0; i < 200; ++i)
        test::addObject(world, box, {.position = {(i % 20 - 10) * 2.0, 0, -40.0 - i / 20 * 2.0}});
    test::load(world);
    renderer::FrameInput in = looking({.eye = {0, 1.6, 0}}, Culler::Gpu);
    renderUntilCounted(in);
    in.freezeCulling = true;
    test::shared().render(in);
    in.camera = {.eye = {0, 5, -100}, .yaw = 180, .pitch = -5};
    renderUntilCounted(in);
    EXPECT_EQ(idsNow().size(), 2u) << "the wall and the sky";
    EXPECT_EQ(test::shared().stats().instancesHidden, 200u);
    in.settings.occlusion = false;
    test::shared().render(in);
    EXPECT_GT(idsNow().size(), 50u) << "one sees what was hidden";
    in.settings.occlusion = true;
    test::shared().render(in);
    EXPECT_EQ(idsNow().size(), 2u) << "what was kept is still known";
    in.freezeCulling = false;
    test::shared().render(in);
    EXPECT_GT(idsNow().size(), 50u);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(FrozenCulling, ItsViewIsDrawnAsLines)
{
    test::TestWorld world;
    test::addObject(world, test::addTemplate(world, "box", test::box({1, 1, 1}, glm::vec4{0.2f, 0.2f, 0.2f, 1})), {.position = {0, 0, -40}});
    world.scene.exchange(test::plainEnvironment(150, 50));
    test::load(world);
    const io::Camera frozen{.eye = {0, 2, 0}};
    renderer::FrameInput in = looking(frozen, Culler::Cpu);
    in.freezeCulling = true;
    test::shared().render(in);
    in.camera = {.eye = {30, 20, 10}, .yaw = 90, .pitch = -25};
    for (const renderer::Show show : {renderer::Show::Final, renderer::Show::Lod}) {
        in.show = show;
        test::shared().render(in);
        const io::Image picture = test::shared().readPicture();
        const io::Ray edge = renderer::rayThrough(frozen, kSize, {0, 0});
        const auto pixel = renderer::project(in.camera, kSize, edge.origin + edge.direction * 15.0);
        ASSERT_TRUE(pixel);
        const glm::ivec4 texel{picture.row<glm::u8vec4>(int(pixel->y))[int(pixel->x)]};
        EXPECT_GT(texel.x, texel.z + 60) << "amber, show " << int(show);
    }
}

} // namespace
