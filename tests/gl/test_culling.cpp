// What is left out was not to be seen.
#include "renderer/cull.h"
#include "tests/gl/support/shared_renderer.h"

#include <gtest/gtest.h>
#include <random>

namespace {

constexpr glm::ivec2 kSize{320, 180};

TEST(Culling, SameIdsAndSamePictureWithAndWithout)
{
    test::TestWorld world = test::makeWorld({.heightMap = {257, 257}, .trees = 150, .boxes = 60});
    test::load(world);
    std::mt19937 random{11};
    std::uniform_real_distribution<double> place{-200, 200}, turn{-180, 180}, tilt{-60, 25};
    for (int i = 0; i < 6; ++i) {
        io::Camera camera{.eye = {place(random), 0, place(random)}, .yaw = float(turn(random)), .pitch = float(tilt(random))};
        camera.eye.y = world.assets.heights->height(camera.eye.x, camera.eye.z).value_or(0) + 12;
        renderer::FrameInput in = test::frame(kSize, camera);
        test::shared().render(in);
        const auto ids = test::shared().readIds({0, 0}, kSize);
        const io::Image picture = test::shared().readPicture();
        const std::uint64_t drawn = test::shared().stats().instancesDrawn;
        in.settings.culling = false;
        test::shared().render(in);
        EXPECT_EQ(ids, test::shared().readIds({0, 0}, kSize)) << "camera " << i;
        EXPECT_EQ(picture.bytes, test::shared().readPicture().bytes) << "camera " << i;
        EXPECT_LT(drawn, test::shared().stats().instancesDrawn);
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Culling, AgreesWithDoublesAwayFromThePlanes)
{
    std::mt19937 random{5};
    std::uniform_real_distribution<double> place{-4000, 4000}, size{0.1, 30};
    constexpr int kCount = 20000;
    renderer::Spheres spheres;
    spheres.resize(kCount);
    std::vector<glm::dvec4> exact;
    for (int i = 0; i < kCount; ++i) {
        exact.emplace_back(place(random), place(random) * 0.1, place(random), size(random));
        spheres.set(std::size_t(i), glm::dvec3{exact.back()}, exact.back().w, renderer::kCastsShadow);
    }
    const renderer::Eye eye = renderer::eyeOf({.eye = {30, 40, -20}, .yaw = 70, .pitch = -8}, kSize);
    const renderer::Volume volume = renderer::volumeOf(eye);
    std::vector<std::uint32_t> visible;
    renderer::cull(spheres, {.volume = volume, .eye = eye.position}, visible);
    std::vector<bool> seen(kCount);
    for (const std::uint32_t slot : visible)
        seen[slot] = true;
    for (int i = 0; i < kCount; ++i) {
        double least = 1e30;
        for (const glm::dvec4& plane : volume.planes)
            least = std::min(least, glm::dot(glm::dvec3{plane}, glm::dvec3{exact[std::size_t(i)]}) + plane.w + exact[std::size_t(i)].w);
        EXPECT_FALSE(least > 0 && !seen[std::size_t(i)]) << i;
        EXPECT_FALSE(least < -0.1 && seen[std::size_t(i)]) << i;
    }
    EXPECT_GT(visible.size(), 100u);
    EXPECT_LT(visible.size(), kCount / 2u);
}

TEST(Culling, FlagsAndSmallThingsAreLeftOut)
{
    renderer::Spheres spheres;
    spheres.resize(3);
    spheres.set(0, {0, 0, -10}, 1, renderer::kCastsShadow);
    spheres.set(1, {0, 0, -10}, 1, renderer::kMarker);
    spheres.set(2, {0, 0, -1000}, 0.1, renderer::kCastsShadow);
    std::vector<std::uint32_t> visible;
    renderer::cull(spheres, {.smallestAngle = 0.001f, .refused = renderer::kMarker}, visible);
    EXPECT_EQ(visible, (std::vector<std::uint32_t>{0}));
    renderer::cull(spheres, {.smallestRadius = 0.05f, .required = renderer::kCastsShadow}, visible);
    EXPECT_EQ(visible, (std::vector<std::uint32_t>{0, 2}));
}

} // namespace
