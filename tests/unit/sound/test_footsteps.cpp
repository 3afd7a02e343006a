#include "io/scene/footsteps.h"

#include <gtest/gtest.h>

namespace {

// Level ground: grass west of x = 0 by its height, gravel east of it.
io::Scene land()
{
    io::HeightGrid grid;
    grid.size = {65, 65};
    grid.origin = {-32, -32};
    grid.metres.assign(65 * 65, 0.0f);
    for (int z = 0; z < 65; ++z)
        for (int x = 33; x < 65; ++x)
            grid.metres[std::size_t(z) * 65 + x] = 50;
    io::Scene scene;
    scene.exchange(io::Terrain{.heightMap = "terrain/x.png",
                               .origin = {-32, -32},
                               .layers = {{.name = "grass", .steps = "sounds/grass.ogg"}, {.name = "gravel", .altitude = {40, 1e5f}, .blend = 0.01f, .steps = "sounds/gravel.ogg"}}});
    scene.exchange(std::make_shared<const io::HeightMap>(grid));
    return scene;
}

TEST(Footsteps, SoundAsTheGroundThatShowsMost)
{
    const io::Scene scene = land();
    io::Footsteps feet;
    EXPECT_EQ(feet.soundUnder(scene, {.at = {-10, 0, 0}}), "sounds/grass.ogg");
    EXPECT_EQ(feet.soundUnder(scene, {.at = {10, 50, 0}}), "sounds/gravel.ogg");
    EXPECT_EQ(feet.soundUnder(scene, {.at = {1000, 0, 0}}), "");
}

TEST(Footsteps, SoundAsWhatOneStandsOn)
{
    io::Scene scene = land();
    const io::TemplateId bridge = scene.templateSlot("bridge"), rug = scene.templateSlot("rug");
    scene.exchange(bridge, io::Template{.name = "bridge", .steps = "sounds/wood.ogg"});
    scene.exchange(rug, io::Template{.name = "rug"});
    io::Footsteps feet;
    EXPECT_EQ(feet.soundUnder(scene, {.at = {-10, 0, 0}, .on = bridge}), "sounds/wood.ogg");
    EXPECT_EQ(feet.soundUnder(scene, {.at = {-10, 0, 0}, .on = rug}), "sounds/grass.ogg");
}

TEST(Footsteps, FollowNewGround)
{
    io::Scene scene = land();
    io::Footsteps feet;
    EXPECT_EQ(feet.soundUnder(scene, {.at = {-10, 0, 0}}), "sounds/grass.ogg");
    io::Terrain terrain = scene.terrain();
    terrain.layers[0].steps = "sounds/snow.ogg";
    scene.exchange(terrain);
    EXPECT_EQ(feet.soundUnder(scene, {.at = {-10, 0, 0}}), "sounds/snow.ogg");
}

TEST(Footsteps, ComeOncePerStride)
{
    const io::Scene scene = land();
    for (const float speed : {1.1f, 2.2f, 5.5f}) {
        io::Footsteps feet;
        int steps = 0;
        for (int i = 0; i < 600; ++i) // ten seconds
            steps += !feet.walk(scene, {.at = {-10, 0, 0}, .walked = speed / 60, .speed = speed}).empty();
        EXPECT_NEAR(steps, 10 * speed / io::strideAt(speed), 1.5) << speed;
        EXPECT_GT(steps, 11);
        EXPECT_LT(steps, 32);
    }
    io::Footsteps feet;
    for (int i = 0; i < 600; ++i) // in the air
        EXPECT_EQ(feet.walk(scene, {.at = {-10, 0, 0}, .walked = 0, .speed = 5}), "");
}

} // namespace
