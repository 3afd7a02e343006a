// Every field of the shadows acts in the next frame, and what they are made of can be looked at.
#include "renderer/cascades.h"
#include "renderer/shaders/shared/shadows.h"
#include "tests/gl/support/shared_renderer.h"

#include <cmath>
#include <gtest/gtest.h>

namespace {

constexpr glm::ivec2 kSize{480, 270};
const io::Camera kCamera{.eye = {-20, 7, 30}, .yaw = 25, .pitch = -16};

test::TestWorld town(const io::Shadows& shadows)
{
    test::TestWorld world;
    world.scene.exchange(io::Terrain{.heightMap = "terrain/flat.png"});
    world.scene.exchange(test::heightMap({257, 257}, 4, [](double x, double z) { return 3 * std::sin(x * 0.05) * std::cos(z * 0.04); }));
    const io::TemplateId id = test::addTemplate(world, "tower", test::box({2, 9, 2}, glm::vec4{0.6f}));
    for (int i = 0; i < 150; ++i)
        test::addObject(world, id, {.position = {(i % 15 - 7) * 11.0, -2, (i / 15 - 7) * 12.0}});
    io::Environment environment = test::plainEnvironment(150, 35);
    environment.shadows = shadows;
    world.scene.exchange(environment);
    test::load(world);
    return world;
}

io::Image shown(renderer::Show show, bool frozen = false, const io::Camera& camera = kCamera)
{
    renderer::FrameInput in = test::frame(kSize, camera);
    in.show = show;
    in.freezeCulling = frozen;
    test::shared().render(in);
    return test::shared().readPicture();
}

int differing(const io::Image& a, const io::Image& b)
{
    int count = 0;
    for (int i = 0; i < kSize.x * kSize.y; ++i)
        count += a.row<glm::u8vec4>(0)[i] != b.row<glm::u8vec4>(0)[i];
    return count;
}

bool near(const glm::u8vec4& texel, const glm::vec3& colour, int by = 6)
{
    const glm::ivec3 d = glm::abs(glm::ivec3{texel} - glm::ivec3{colour * 255.0f});
    return std::max({d.x, d.y, d.z}) <= by;
}

int pixelsLike(const io::Image& image, const glm::vec3& colour, int by = 6)
{
    int count = 0;
    for (int i = 0; i < kSize.x * kSize.y; ++i)
        count += near(image.row<glm::u8vec4>(0)[i], colour, by);
    return count;
}

TEST(ShadowFields, EachActsInTheNextFrame)
{
    const io::Shadows base{.cascades = 4, .distance = 120, .splits = io::Splits::Manual, .end1 = 15, .end2 = 32, .end3 = 60, .resolution = 512};
    test::TestWorld world = town(base);
    const auto act = [&](const char* name, auto&& change) {
        io::Environment environment = world.scene.environment();
        environment.shadows = base;
        world.scene.exchange(environment);
        test::shared().update(world.scene, world.assets, {.environment = true});
        const io::Image before = shown(renderer::Show::Shadow);
        change(environment);
        world.scene.exchange(environment);
        test::shared().update(world.scene, world.assets, {.environment = true});
        EXPECT_GT(differing(before, shown(renderer::Show::Shadow)), 30) << name;
    };
    act("cascades", [](io::Environment& e) { e.shadows.cascades = 2; });
    act("distance", [](io::Environment& e) { e.shadows.distance = 75; });
    act("splits", [](io::Environment& e) { e.shadows.splits = io::Splits::Practical; });
    act("lambda", [](io::Environment& e) { e.shadows.splits = io::Splits::Practical, e.shadows.lambda = 0.1f; });
    act("end_1", [](io::Environment& e) { e.shadows.end1 = 25; });
    act("end_2", [](io::Environment& e) { e.shadows.end2 = 50; });
    act("end_3", [](io::Environment& e) { e.shadows.end3 = 90; });
    act("end_4", [](io::Environment& e) { e.shadows.cascades = 5, e.shadows.end4 = 80; });
    act("end_5", [](io::Environment& e) { e.shadows.cascades = 6, e.shadows.end4 = 80, e.shadows.end5 = 100; });
    act("resolution", [](io::Environment& e) { e.shadows.resolution = 1024; });
    act("filter", [](io::Environment& e) { e.shadows.filter = io::ShadowFilter::Pcf5; });
    act("softness", [](io::Environment& e) { e.shadows.softness = 1.4f; });
    act("contact", [](io::Environment& e) { e.shadows.contact = true; });
    act("contact of a wide sun", [](io::Environment& e) { e.shadows.contact = true, e.sun.angularDiameter = 4; });
    act("blend", [](io::Environment& e) { e.shadows.blend = 0.5f; });
    act("fade", [](io::Environment& e) { e.shadows.fade = 0.5f; });
    act("bias", [](io::Environment& e) { e.shadows.bias = 4; });
    act("depth_bias", [](io::Environment& e) { e.shadows.depthBias = 6; });
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// Softer filters, as far as they go, give light between 0 and 1 and no fault.
TEST(ShadowFields, AllOfTheirRangeWorks)
{
    for (const io::Shadows& shadows : {io::Shadows{.cascades = 1, .softness = 0, .blend = 0, .fade = 0, .bias = 0, .depthBias = 0},
                                       io::Shadows{.cascades = 6, .resolution = 256, .filter = io::ShadowFilter::Pcf7, .softness = 4, .blend = 0.5f, .fade = 0.5f, .bias = 8, .depthBias = 16},
                                       io::Shadows{.cascades = 2, .distance = 10, .resolution = 300, .filter = io::ShadowFilter::Pcf7, .softness = 4, .contact = true},
                                       io::Shadows{.cascades = 6, .distance = 50, .splits = io::Splits::Manual, .end1 = 400, .end2 = 2, .resolution = 256}}) {
        town(shadows);
        const io::Image picture = shown(renderer::Show::Shadow);
        int lit = 0;
        for (int i = 0; i < kSize.x * kSize.y; ++i)
            lit += picture.row<glm::u8vec4>(0)[i].x > 200;
        EXPECT_GT(lit, kSize.x * kSize.y / 4);
        EXPECT_TRUE(test::shared().shaderFaults().empty());
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(ShadowShows, MapsAreFramedInTheirCascadesColoursAndShowWhatStandsInThem)
{
    for (const int cascades : {1, 4, 6}) {
        town({.cascades = cascades, .distance = 150, .resolution = 512});
        const io::Image picture = shown(renderer::Show::ShadowMaps);
        for (int i = 0; i < MAX_CASCADES; ++i) {
            const int framed = pixelsLike(picture, glsl::cascadeTint(i));
            if (i < cascades) EXPECT_GT(framed, 300) << i << " of " << cascades;
            else EXPECT_EQ(framed, 0) << i << " of " << cascades;
        }
        int dark = 0, bright = 0;
        for (int i = 0; i < kSize.x * kSize.y; ++i) {
            const glm::u8vec4 texel = picture.row<glm::u8vec4>(0)[i];
            if (texel.x != texel.y || texel.y != texel.z) continue; // frames and emptiness
            dark += texel.x > 10 && texel.x < 50;
            bright += texel.x > 130;
        }
        EXPECT_GT(dark, 300) << cascades;
        EXPECT_GT(bright, 300) << cascades;
    }
    renderer::FrameInput off = test::frame(kSize, kCamera);
    off.settings.shadows = false;
    off.show = renderer::Show::ShadowMaps;
    test::shared().render(off);
    EXPECT_EQ(pixelsLike(test::shared().readPicture(), {0, 0, 0}), kSize.x * kSize.y);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(ShadowShows, AllSixCascadesAreTinted)
{
    town({.cascades = 6, .distance = 150, .lambda = 0, .resolution = 256});
    const io::Image picture = shown(renderer::Show::Cascade);
    int tinted = 0;
    for (int i = 0; i < MAX_CASCADES; ++i) {
        int like = 0; // grey times the tint
        for (int p = 0; p < kSize.x * kSize.y; ++p) {
            const glm::vec3 texel{picture.row<glm::u8vec4>(0)[p]};
            const glm::vec3 tint = glsl::cascadeTint(i);
            const float grey = glm::dot(texel, tint) / glm::dot(tint, tint);
            like += grey > 40 && glm::length(texel - tint * grey) < 5;
        }
        tinted += like > 60;
    }
    EXPECT_EQ(tinted, 6);
}

// How much of a cascade's box is drawn in its colour, along lines that a camera sees.
int drawnAlong(const io::Image& picture, const io::Camera& camera, const glm::dvec3& from, const glm::dvec3& to, const glm::vec3& colour)
{
    int found = 0;
    for (int i = 0; i <= 400; ++i) {
        const auto pixel = renderer::project(camera, kSize, glm::mix(from, to, i / 400.0));
        if (!pixel || pixel->x < 1 || pixel->y < 1 || pixel->x > kSize.x - 2 || pixel->y > kSize.y - 2) continue;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const glm::vec3 texel{picture.row<glm::u8vec4>(int(pixel->y) + dy)[int(pixel->x) + dx]};
                const glm::vec3 hue = texel / std::max({texel.x, texel.y, texel.z, 1.0f});
                if (std::max({texel.x, texel.y, texel.z}) < 120 || glm::length(hue - colour) > 0.35f) continue;
                ++found;
                dy = dx = 2;
            }
    }
    return found;
}

TEST(ShadowShows, BoxesOfTheFrozenCameraStayWhileAnotherLooks)
{
    const io::Shadows shadows{.cascades = 2, .distance = 60, .resolution = 512};
    test::TestWorld world = town(shadows);
    shown(renderer::Show::ShadowBoxes, true);
    const io::Camera above{.eye = {60, 130, 160}, .yaw = -20, .pitch = -38};
    const io::Image picture = shown(renderer::Show::ShadowBoxes, true, above);
    const glm::dvec3 sun = io::towardSun(world.scene.environment());
    const auto cascades = renderer::cascadesOf(renderer::eyeOf(kCamera, kSize), shadows, sun, 0.0046);
    const glm::dmat3 worldFromLight = glm::transpose(renderer::lightAxes(sun));
    for (std::size_t i = 0; i < cascades.size(); ++i) {
        const renderer::Cascade& c = cascades[i];
        const auto corner = [&](bool x, bool y, bool z) {
            const io::TexelRect window = c.window();
            return worldFromLight * glm::dvec3{double(x ? window.high.x : window.low.x) * c.texel, double(y ? window.high.y : window.low.y) * c.texel,
                                               c.bottom + (z ? c.depthRange : 0)};
        };
        int found = 0;
        for (const bool x : {false, true})
            for (const bool y : {false, true})
                found += drawnAlong(picture, above, corner(x, y, false), corner(x, y, true), glsl::cascadeTint(int(i)));
        EXPECT_GT(found, 60) << i;
    }
    shown(renderer::Show::Final); // thaws
}

} // namespace
