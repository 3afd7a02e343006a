// What a frame tells of itself: the instances that each test of culling let through, triangles, memory, uploads.
#include "tests/gl/support/shared_renderer.h"

#include <gtest/gtest.h>

namespace {

using renderer::Culler;

constexpr glm::ivec2 kSize{320, 180};

renderer::FrameStats statsOf(renderer::FrameInput in, Culler culler)
{
    in.settings.culler = culler;
    for (int i = 0; i < 6; ++i) // the GPU's are of a frame a little earlier
        test::shared().render(in);
    return test::shared().stats();
}

TEST(CullingCounts, AreTheSameOfBothCullers)
{
    test::TestWorld world = test::makeWorld({.heightMap = {257, 257}, .trees = 500, .boxes = 200});
    const io::TemplateId pebble = test::addTemplate(world, "pebble", test::box({0.02f, 0.02f, 0.02f}, glm::vec4{1}));
    for (int i = 0; i < 200; ++i)
        test::addObject(world, pebble, {.position = {i - 100.0, 40, -150}});
    io::Template direct = *world.scene.find(pebble);
    direct.drawPath = io::DrawPath::Direct; // the CPU culls these whoever culls the rest
    test::load(world);
    for (const bool somePathsDirect : {false, true}) {
        if (somePathsDirect) {
            world.scene.exchange(pebble, direct);
            test::load(world);
        }
        renderer::FrameInput in = test::frame(kSize, {.eye = {0, 60, 60}, .pitch = -15});
        in.settings.shadows = false;
        in.settings.occlusion = false;
        const renderer::FrameStats cpu = statsOf(in, Culler::Cpu), gpu = statsOf(in, Culler::Gpu);
        EXPECT_LT(cpu.instancesInside, cpu.instances);
        EXPECT_LT(cpu.instancesLarge, cpu.instancesInside);
        EXPECT_GT(cpu.instancesLarge, 100u);
        EXPECT_EQ(cpu.instancesLarge, cpu.instancesDrawn);
        EXPECT_EQ(cpu.instancesInside, gpu.instancesInside);
        EXPECT_EQ(cpu.instancesLarge, gpu.instancesLarge);
        EXPECT_EQ(cpu.instancesDrawn, gpu.instancesDrawn);
        EXPECT_EQ(cpu.trianglesOfLevel, gpu.trianglesOfLevel);
        EXPECT_EQ(cpu.trianglesDrawn, gpu.trianglesDrawn);
        EXPECT_EQ(cpu.trianglesSubmitted, gpu.trianglesSubmitted);
        EXPECT_FALSE(cpu.occlusionTested);
        EXPECT_FALSE(gpu.occlusionTested);
        in.settings.occlusion = true;
        const renderer::FrameStats hiding = statsOf(in, Culler::Gpu);
        EXPECT_TRUE(hiding.occlusionTested);
        EXPECT_GT(hiding.instancesHidden, 0u);
        EXPECT_EQ(hiding.instancesDrawn, hiding.instancesLarge - hiding.instancesHidden);
    }
}

TEST(CullingCounts, NothingLargeEnoughIsStillInside)
{
    test::TestWorld world;
    const io::TemplateId pebble = test::addTemplate(world, "pebble", test::box({0.02f, 0.02f, 0.02f}, glm::vec4{1}));
    for (int i = 0; i < 50; ++i)
        test::addObject(world, pebble, {.position = {i - 25.0, 0, -300}});
    test::load(world);
    const renderer::FrameStats stats = statsOf(test::frame(kSize, {}), Culler::Cpu);
    EXPECT_EQ(stats.instancesInside, 50u);
    EXPECT_EQ(stats.instancesLarge, 0u);
    EXPECT_EQ(stats.instancesDrawn, 0u);
}

TEST(FrameStatistics, MemoryIsToldByKindAndUploadsByFrame)
{
    test::TestWorld world = test::makeWorld({.heightMap = {129, 129}, .trees = 40, .boxes = 100});
    test::load(world);
    renderer::FrameInput in = test::frame(kSize, {.eye = {0, 200, 200}, .pitch = -45});
    test::shared().render(in);
    const renderer::FrameStats before = test::shared().stats();
    const renderer::GpuMemory& memory = before.gpuMemory;
    EXPECT_EQ(memory.textures + memory.buffers + memory.shadowMaps + memory.targets, before.gpuBytes);
    EXPECT_GE(memory.shadowMaps, 4u * 1024 * 1024 * 4);
    const std::uint64_t aPixel = 4 + 4 + 4 + 4 + 4 + 8 + 4; // the GBuffer, radiance, the picture
    EXPECT_GE(memory.targets, std::uint64_t(kSize.x) * kSize.y * aPixel);
    EXPECT_GE(memory.textures, 4u * 256 * 256 * 4) << "layers of the ground";
    in.size = {640, 360};
    test::shared().render(in);
    EXPECT_GE(test::shared().stats().gpuMemory.targets, memory.targets + std::uint64_t(kSize.x) * kSize.y * aPixel * 3);
    EXPECT_EQ(test::shared().stats().gpuMemory.textures, memory.textures);

    in.settings.culler = Culler::Cpu; // copies what it draws
    test::shared().render(in);
    EXPECT_GT(test::shared().stats().uploadedBytes, test::shared().stats().instancesDrawn * 80);
    in.settings.culler = Culler::Gpu; // once all of it, then nothing but constants
    test::shared().render(in);
    EXPECT_GT(test::shared().stats().uploadedBytes, before.instances * (80 + 32));
    test::shared().render(in);
    EXPECT_LT(test::shared().stats().uploadedBytes, 40'000u);
}

} // namespace
