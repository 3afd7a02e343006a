// Culling on the GPU gives the CPU's answer, and what it knows beyond that, of things behind others, hides nothing seen.
#include "renderer/choosing.h"
#include "renderer/device.h"
#include "tests/gl/support/culling_oracle.h"

#include <algorithm>
#include <cstdio>
#include <gtest/gtest.h>
#include <random>

namespace {

constexpr glm::ivec2 kSize{320, 180};

// Counts are of a frame a little earlier.
void renderUntilCounted(const renderer::FrameInput& in)
{
    for (int i = 0; i < 6; ++i) {
        test::shared().render(in);
        renderer::waitForDevice();
    }
}

TEST(GpuCulling, DrawsThePictureThatTheCpuDraws)
{
    test::TestWorld world = test::makeWorld({.heightMap = {257, 257}, .trees = 400, .boxes = 80});
    test::load(world);
    std::mt19937 random{3};
    for (int i = 0; i < 8; ++i) {
        renderer::FrameInput in = test::frame(kSize, test::cameraIn(world, random));
        in.settings.occlusion = false;
        in.settings.culler = renderer::Culler::Cpu;
        test::shared().render(in);
        const auto ids = test::shared().readIds({0, 0}, kSize);
        const io::Image picture = test::shared().readPicture();
        const std::uint64_t drawn = test::shared().stats().instancesDrawn;
        in.settings.culler = renderer::Culler::Gpu;
        test::shared().render(in);
        EXPECT_TRUE(ids == test::shared().readIds({0, 0}, kSize)) << "camera " << i;
        EXPECT_TRUE(picture.bytes == test::shared().readPicture().bytes) << "camera " << i;
        renderUntilCounted(in);
        EXPECT_EQ(test::shared().stats().instancesDrawn, drawn) << "camera " << i;
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// The same for many more cameras: tests/bench/culling_oracle.
TEST(CullingOracle, NothingSeenIsMissingAtAnyWindowSize)
{
    const test::TestWorld trees = test::makeWorld({.heightMap = {257, 257}, .trees = 3000, .boxes = 300});
    for (test::TestWorld world : {trees, test::oracleWorld(3000)}) {
        test::load(world);
        std::mt19937 random{17};
        test::OracleCounts counts;
        const auto tell = [](const test::Missing& missing) {
            std::fprintf(stderr, "%s: object %u with %u pixels from %.2f %.2f %.2f, yaw %.1f, pitch %.1f, fov %.1f\n", missing.how,
                         missing.id, missing.pixels, missing.camera.eye.x, missing.camera.eye.y, missing.camera.eye.z,
                         double(missing.camera.yaw), double(missing.camera.pitch), double(missing.camera.fov));
        };
        for (const glm::ivec2 size : {glm::ivec2{320, 180}, glm::ivec2{213, 119}, glm::ivec2{55, 129}})
            for (int i = 0; i < 6; ++i)
                test::askOracle(test::cameraIn(world, random), size, counts, tell);
        EXPECT_GT(counts.ids, 500u);
        EXPECT_EQ(counts.cpuMissing, 0u);
        EXPECT_EQ(counts.gpuCutMissing, 0u);
        EXPECT_EQ(counts.gpuMissing, 0u);
        EXPECT_LT(counts.gpuDrawn, counts.drawn) << "what stands behind others is left out";
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(GpuCulling, AWallHidesWhatStandsBehindIt)
{
    test::TestWorld world;
    test::addObject(world, test::addTemplate(world, "wall", test::box({400, 200, 1}, glm::vec4{1})), {.position = {0, -50, -20}});
    const io::TemplateId box = test::addTemplate(world, "box", test::box({1, 1, 1}, glm::vec4{1}));
    for (int i = 0; i < 2000; ++i)
        test::addObject(world, box, {.position = {(i % 50 - 25) * 2.0, 0, -40.0 - i / 50 * 2.0}});
    test::load(world);
    renderer::FrameInput in = test::frame(kSize, {.eye = {0, 1.6, 0}});
    in.settings.culler = renderer::Culler::Gpu;
    renderUntilCounted(in);
    EXPECT_LE(test::shared().stats().instancesDrawn, 1u + 20u);
    EXPECT_GT(test::shared().stats().instancesHidden, 1500u);
    in.settings.occlusion = false;
    renderUntilCounted(in);
    EXPECT_GT(test::shared().stats().instancesDrawn, 1900u);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(GpuCulling, FollowsWhatIsMovedAddedAndTakenAway)
{
    test::TestWorld world;
    const io::TemplateId box = test::addTemplate(world, "box", test::box({1, 1, 1}, glm::vec4{1}));
    std::vector<io::ObjectId> objects;
    for (int i = 0; i < 40; ++i)
        objects.push_back(test::addObject(world, box, {.position = {(i - 20) * 1.5, 0, -30}}));
    test::load(world);
    renderer::FrameInput in = test::frame(kSize, {.eye = {0, 1, 0}});
    in.settings.culler = renderer::Culler::Gpu;
    std::mt19937 random{5};
    for (int step = 0; step < 30; ++step) {
        const io::ObjectId id = objects[random() % objects.size()];
        if (const io::Object* there = world.scene.find(id); there && step % 3) {
            io::Object moved = *there;
            moved.transform.position.y = double(random() % 8);
            world.scene.exchange(id, moved);
        } else if (there) {
            world.scene.exchange(id, std::nullopt);
        } else {
            world.scene.exchange(id, io::Object{.id = id, .templateId = box, .transform = {.position = {step - 15.0, 3, -25}}}); // no two in one place
        }
        test::shared().update(world.scene, world.assets, {.objects = {id}});
        in.settings.culler = renderer::Culler::Gpu;
        test::shared().render(in);
        const auto ids = test::shared().readIds({0, 0}, kSize);
        in.settings.culler = renderer::Culler::Cpu;
        test::shared().render(in);
        ASSERT_TRUE(ids == test::shared().readIds({0, 0}, kSize)) << "step " << step;
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

} // namespace

namespace {

TEST(DepthPyramid, HoldsTheLeastOfWhatEachTexelCovers)
{
    ASSERT_TRUE(test::haveContext());
    renderer::ShaderLibrary shaders{WOLD_SOURCE_DIR "/renderer/shaders"};
    renderer::DepthPyramid pyramid{shaders};
    std::mt19937 random{9};
    for (const glm::ivec2 size : {glm::ivec2{64, 32}, glm::ivec2{37, 61}, glm::ivec2{131, 77}}) {
        std::vector<float> depths(std::size_t(size.x) * size.y);
        for (float& depth : depths)
            depth = float(random() % 1000) / 1000;
        renderer::gl::Texture depth{{.label = "depth", .size = size, .format = GL_DEPTH_COMPONENT32F}};
        glTextureSubImage2D(depth.id(), 0, 0, 0, size.x, size.y, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
        renderer::GpuStream stream;
        renderer::PassTimers timers;
        renderer::FrameStats stats;
        const renderer::gl::VertexArray empty{"none"};
        renderer::GpuFrame gpu{stream, timers, stats, empty};
        const renderer::gl::Texture& levels = pyramid.make(gpu, depth);
        for (int mip = 0; mip < levels.mips(); ++mip) {
            const glm::ivec2 coarse = levels.size(mip);
            std::vector<float> made(std::size_t(coarse.x) * coarse.y);
            glGetTextureImage(levels.id(), mip, GL_RED, GL_FLOAT, GLsizei(made.size() * 4), made.data());
            for (int y = 0; y < coarse.y; ++y)
                for (int x = 0; x < coarse.x; ++x) {
                    float least = 1;
                    for (int v = y * size.y / coarse.y; v < ((y + 1) * size.y + coarse.y - 1) / coarse.y; ++v)
                        for (int u = x * size.x / coarse.x; u < ((x + 1) * size.x + coarse.x - 1) / coarse.x; ++u)
                            least = std::min(least, depths[std::size_t(v) * size.x + u]);
                    ASSERT_LE(made[std::size_t(y) * coarse.x + x], least) << mip << ": " << x << ", " << y;
                    if (mip == 0) {
                        ASSERT_EQ(made[std::size_t(y) * coarse.x + x], least) << x << ", " << y;
                    }
                }
        }
    }
}

// The buffers must grow for the one that comes, and the mover alone makes more changes than there are objects.
TEST(GpuCulling, KeepsTheOthersWhenOneMovesOftenAndOneComes)
{
    test::TestWorld world;
    const io::TemplateId box = test::addTemplate(world, "box", test::box({1, 1, 1}, glm::vec4{1}));
    const auto put = [&](int i) { return test::addObject(world, box, {.position = {i % 20 * 2.0 - 20, i / 20 * 2.0 - 8, -40}}); };
    const io::ObjectId mover = put(0);
    for (int i = 1; i < 200; ++i) // more than go up together because they lie near each other
        put(i);
    test::load(world);
    renderer::FrameInput in = test::frame(kSize, {.eye = {0, 1, 0}});
    in.settings.culler = renderer::Culler::Gpu;
    test::shared().render(in);
    for (int i = 0; i < 250; ++i) {
        io::Object moved = *world.scene.find(mover);
        moved.transform.position.z = -40 + i * 0.01;
        world.scene.exchange(mover, moved);
        test::shared().update(world.scene, world.assets, {.objects = {mover}});
    }
    test::shared().update(world.scene, world.assets, {.objects = {put(200)}});
    test::shared().render(in);
    const auto ids = test::shared().readIds({0, 0}, kSize);
    in.settings.culler = renderer::Culler::Cpu;
    test::shared().render(in);
    EXPECT_TRUE(ids == test::shared().readIds({0, 0}, kSize));
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

} // namespace
