// Particles, rain and snow: how many there are, that nothing but time moves them, and what they do to a picture.
#include "renderer/particles.h"
#include "renderer/passes/precipitation.h"
#include "tests/gl/support/shared_renderer.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace {

constexpr glm::ivec2 kSize{160, 120};

io::TemplateId addSource(test::TestWorld& world, const std::string& name, const io::ParticleSource& what)
{
    const io::TemplateId id = world.scene.templateSlot(name);
    world.scene.exchange(id, io::Template{.name = name, .particles = what});
    world.assets.models.resize(world.scene.templates().size());
    return id;
}

io::ParticleSource smoke()
{
    return {.kind = io::ParticleKind::Smoke, .rate = 30, .life = 4, .size = 1.5f, .rise = 1, .spread = 0.3f};
}

test::TestWorld groundWorld(float grey = 0.3f)
{
    test::TestWorld world;
    io::Terrain terrain;
    terrain.heightMap = "terrain/flat.png";
    world.scene.exchange(test::heightMap({65, 65}, 1, [](double, double) { return 0.0; }));
    terrain.layers = {{.name = "grey", .colour = glm::vec3{grey}, .roughness = 1}};
    world.scene.exchange(std::move(terrain));
    world.assets.layers.resize(1);
    world.scene.exchange(test::plainEnvironment(135, 45));
    return world;
}

renderer::Eye eyeAt(const glm::dvec3& place)
{
    return renderer::eyeOf({.eye = place, .pitch = -5}, kSize);
}

struct Many {
    renderer::ParticleSources sources;
    renderer::Particles at(double time, std::size_t most = 100000) const
    {
        const std::optional<renderer::Volume> all;
        const io::Wind wind;
        const renderer::Eye eye = eyeAt({0, 2, 12});
        return renderer::particlesOf(sources.placed(), {.eye = eye, .volume = all, .wind = wind, .time = time, .most = most});
    }
};

Many manyOf(const test::TestWorld& world)
{
    Many many;
    many.sources.update(world.scene, {.everything = true});
    return many;
}

const io::Camera kLook{.eye = {0, 1.6, 7}, .pitch = 2, .fov = 50};

io::Image pictureOf(test::TestWorld& world, double time = 5, bool on = true, const io::Camera& camera = kLook)
{
    test::load(world);
    renderer::FrameInput in = test::frame(kSize, camera);
    in.time = time;
    in.markers = false;
    in.settings.particles = on;
    test::shared().render(in);
    return test::shared().readRadiance();
}

int differing(const io::Image& a, const io::Image& b)
{
    int count = 0;
    for (int i = 0; i < kSize.x * kSize.y; ++i)
        count += glm::length(a.row<glm::vec3>(0)[i] - b.row<glm::vec3>(0)[i]) > 1e-4f;
    return count;
}

TEST(Particles, AreAsManyAsRateTimesLife)
{
    for (const auto& [rate, life] : {std::pair{30.0f, 4.0f}, {7.5f, 0.8f}, {400.0f, 3.0f}}) {
        test::TestWorld world;
        io::ParticleSource what = smoke();
        what.rate = rate, what.life = life;
        test::addObject(world, addSource(world, "smoke", what), {});
        const Many many = manyOf(world);
        double sum = 0;
        for (int i = 0; i < 40; ++i) {
            const auto here = many.at(i * 0.377);
            EXPECT_NEAR(double(here.drawn.size()), double(rate) * double(life), 1.001) << i;
            for (const glsl::Particle& particle : here.drawn)
                EXPECT_TRUE(particle.age >= 0 && particle.age < life);
            sum += double(here.drawn.size());
        }
        EXPECT_NEAR(sum / 40, double(rate) * double(life), 0.6);
    }
}

TEST(Particles, FlyOnSmoothlyAndEndNearWhereTheWindTakesThem)
{
    test::TestWorld world;
    test::addObject(world, addSource(world, "smoke", smoke()), {});
    const Many many = manyOf(world);
    const glsl::ParticleSource s = many.at(0).sources.front();
    glsl::ParticleSource next = s;
    for (std::uint32_t seed = 1; seed < 200; ++seed)
        for (float age = 0; age < 3.9f; age += 0.1f) {
            next.time = s.time + 0.01f;
            const glm::vec3 step = glsl::particleCentre(next, seed, age + 0.01f) - glsl::particleCentre(s, seed, age);
            EXPECT_LT(glm::length(step), 0.01f * 9) << seed << " " << age; // m/s
        }
    EXPECT_NEAR(glm::length(glsl::particleCentre(s, 5, 0) - s.origin), 0, s.spread + 1e-4);
    EXPECT_GT(glsl::particleCentre(s, 5, 4).y, s.origin.y + 1);
    EXPECT_GT(glm::dot(glm::vec3{glsl::particleCentre(s, 5, 4) - s.origin}, s.drift), 0);
}

TEST(Particles, LieFromBackToFrontWhateverTheScenesOrder)
{
    const auto orderOf = [](bool turned) {
        test::TestWorld world;
        const io::TemplateId id = addSource(world, "smoke", smoke());
        std::vector<double> places{-6, 0, 3, 5};
        std::vector<io::ObjectId> ids;
        for (std::size_t i = 0; i < places.size(); ++i)
            ids.push_back(world.scene.freshId()), world.scene.exchange(ids.back(), io::Object{.id = ids.back()});
        if (turned) std::ranges::reverse(ids), std::ranges::reverse(places);
        Many many;
        many.sources.update(world.scene, {.everything = true});
        for (std::size_t i = 0; i < places.size(); ++i) {
            io::Transform t;
            t.position = {places[i], 0, places[i]};
            world.scene.exchange(ids[i], io::Object{.id = ids[i], .templateId = id, .transform = t});
            many.sources.update(world.scene, {.objects = {ids[i]}, .templates = i == 0 ? std::vector{id} : std::vector<io::TemplateId>{}});
        }
        return many.at(3.3);
    };
    const renderer::Particles a = orderOf(false), b = orderOf(true);
    ASSERT_EQ(a.drawn.size(), b.drawn.size());
    ASSERT_GT(a.drawn.size(), 400u);
    float last = 1e9f;
    const glm::vec3 forward{eyeAt({0, 2, 12}).forward};
    for (std::size_t i = 0; i < a.drawn.size(); ++i) {
        EXPECT_EQ(a.drawn[i].seed, b.drawn[i].seed);
        const float depth = glm::dot(glsl::particleCentre(a.sources[a.drawn[i].source], a.drawn[i].seed, a.drawn[i].age), forward);
        EXPECT_LE(depth, last);
        last = depth;
    }
}

TEST(Particles, TheMirrorFollowsChanges)
{
    test::TestWorld world;
    const io::TemplateId id = addSource(world, "smoke", smoke());
    const io::ObjectId object = test::addObject(world, id, {});
    renderer::ParticleSources sources;
    sources.update(world.scene, {.everything = true});
    ASSERT_EQ(sources.placed().size(), 1u);
    io::Transform moved;
    moved.position = {4, 5, 6};
    world.scene.exchange(object, io::Object{.id = object, .templateId = id, .transform = moved});
    sources.update(world.scene, {.objects = {object}});
    EXPECT_EQ(sources.placed().front().position, (glm::dvec3{4, 5, 6}));
    io::Template edited = *world.scene.find(id);
    edited.particles.offset = {0, 2, 0};
    world.scene.exchange(id, edited);
    sources.update(world.scene, {.templates = {id}});
    EXPECT_EQ(sources.placed().front().position, (glm::dvec3{4, 7, 6}));
    edited.particles.kind = io::ParticleKind::None;
    world.scene.exchange(id, edited);
    sources.update(world.scene, {.templates = {id}});
    EXPECT_TRUE(sources.placed().empty());
    edited.particles.kind = io::ParticleKind::Dust;
    world.scene.exchange(id, edited);
    sources.update(world.scene, {.templates = {id}});
    EXPECT_EQ(sources.placed().size(), 1u);
    world.scene.exchange(object, std::nullopt);
    sources.update(world.scene, {.objects = {object}});
    EXPECT_TRUE(sources.placed().empty());
}

TEST(Particles, ManySourcesAreThinnedToWhatIsAllowed)
{
    test::TestWorld world;
    io::ParticleSource what = smoke();
    what.rate = 500;
    const io::TemplateId id = addSource(world, "smoke", what);
    for (int i = 0; i < 30; ++i) {
        io::Transform t;
        t.position = {i - 15.0, 0, 0};
        test::addObject(world, id, t);
    }
    const Many many = manyOf(world);
    EXPECT_LE(many.at(1, 3000).drawn.size(), 3100u);
    EXPECT_GE(many.at(1, 3000).drawn.size(), 1400u);
}

TEST(Particles, SmokeFireAndDustShowAndOnlyWhereTheyAre)
{
    for (const io::ParticleKind kind : {io::ParticleKind::Fire, io::ParticleKind::Smoke, io::ParticleKind::Dust}) {
        test::TestWorld world = groundWorld();
        io::ParticleSource what = smoke();
        what.kind = kind;
        test::addObject(world, addSource(world, "source", what), {});
        const io::Image with = pictureOf(world), without = pictureOf(world, 5, false);
        const int shown = differing(with, without);
        EXPECT_GT(shown, 150) << int(kind);
        EXPECT_LT(shown, kSize.x * kSize.y / 2) << int(kind);
        if (kind == io::ParticleKind::Fire) { // it glows
            double brightest = 0;
            for (int i = 0; i < kSize.x * kSize.y; ++i)
                brightest = std::max(brightest, double(with.row<glm::vec3>(0)[i].x - without.row<glm::vec3>(0)[i].x));
            EXPECT_GT(brightest, 0.2);
        }
    }
}

TEST(Particles, TheSameTimeGivesTheSamePictureAndAnotherAnother)
{
    test::TestWorld world = groundWorld();
    test::addObject(world, addSource(world, "smoke", smoke()), {});
    const io::Image first = pictureOf(world, 7);
    EXPECT_GT(differing(pictureOf(world, 7.5), first), 100);
    EXPECT_EQ(pictureOf(world, 7).bytes, first.bytes);
}

// Where a puff stands in the ground there is no edge: along its foot no pixel leaps from its neighbours.
TEST(Particles, AreSoftWhereTheyMeetTheGround)
{
    test::TestWorld world = groundWorld(0.01f); // dark, so that what smoke adds tells how much of it there is
    io::ParticleSource what = smoke();
    what.rise = 0, what.size = 3, what.spread = 0.1f, what.rate = 20;
    test::addObject(world, addSource(world, "smoke", what), {});
    io::Environment still = test::plainEnvironment(135, 45);
    still.wind.speed = 0;
    world.scene.exchange(still);
    const io::Camera down{.eye = {0, 3, 6}, .pitch = -25, .fov = 40};
    const io::Image with = pictureOf(world, 5, true, down), without = pictureOf(world, 5, false, down);
    double largest = 0, leap = 0;
    for (int x = 40; x < 120; ++x)
        for (int y = 20; y + 1 < kSize.y; ++y) {
            const auto share = [&](int row) { return double(with.row<glm::vec3>(row)[x].y - without.row<glm::vec3>(row)[x].y); };
            largest = std::max(largest, std::abs(share(y)));
            leap = std::max(leap, std::abs(share(y) - share(y + 1)));
        }
    ASSERT_GT(largest, 0.02);
    EXPECT_LT(leap, 0.4 * largest);
}

TEST(Particles, SmokeIsDarkerInShadowThanInTheSun)
{
    test::TestWorld world = groundWorld();
    test::addObject(world, addSource(world, "smoke", smoke()), {});
    const auto added = [&] {
        const io::Image with = pictureOf(world), without = pictureOf(world, 5, false);
        double sum = 0;
        for (int i = 0; i < kSize.x * kSize.y; ++i)
            sum += double(with.row<glm::vec3>(0)[i].y - without.row<glm::vec3>(0)[i].y);
        return sum;
    };
    const double sunny = added();
    // A wall between it and the sun, out of the picture.
    const io::TemplateId wall = test::addTemplate(world, "wall", test::box({0.5f, 60, 60}, {1, 1, 1, 1}));
    io::Transform t;
    t.position = {14, 0, 14};
    t.rotation.y = -45;
    test::addObject(world, wall, t);
    EXPECT_LT(added(), 0.8 * sunny);
}

// Mean light that particles add to a picture.
double addedLight(test::TestWorld& world, renderer::FrameInput in)
{
    double sum = 0;
    test::load(world);
    for (const bool on : {true, false}) {
        in.settings.particles = on;
        test::shared().render(in);
        const io::Image image = test::shared().readRadiance();
        for (int i = 0; i < kSize.x * kSize.y; ++i)
            sum += (on ? 1 : -1) * double(image.row<glm::vec3>(0)[i].y) / (kSize.x * kSize.y);
    }
    return sum;
}

// By night, all that smoke has beside what the sky still gives.
TEST(Particles, SmokeIsLitByLampsWithinTheirRange)
{
    test::TestWorld world = groundWorld(0.01f);
    world.scene.exchange(test::plainEnvironment(0, -20));
    test::addObject(world, addSource(world, "smoke", smoke()), {});
    renderer::FrameInput in = test::frame(kSize, kLook);
    in.time = 5;
    in.markers = false;
    const double dark = addedLight(world, in);
    const io::TemplateId lamp = world.scene.templateSlot("lamp");
    world.scene.exchange(lamp, io::Template{.name = "lamp", .light = {.kind = io::LightKind::Point, .colour = {1, 1, 1}, .intensity = 2, .range = 8}});
    world.assets.models.resize(world.scene.templates().size());
    const io::ObjectId near = test::addObject(world, lamp, {.position = {1.5, 2, 0}});
    const double lit = addedLight(world, in);
    EXPECT_GT(lit, 20 * std::abs(dark) + 1e-4);
    io::Object away = world.scene.at(near);
    away.transform.position = {1.5, 2, 40};
    world.scene.exchange(near, away);
    EXPECT_NEAR(addedLight(world, in), dark, 0.02 * lit);
}

// Smoke far away in air is the colour of the air, as the wall behind it.
TEST(Particles, SmokeStandsInTheAir)
{
    test::TestWorld world;
    const io::TemplateId wall = test::addTemplate(world, "wall", test::box({400, 400, 1}, {0.02f, 0.02f, 0.02f, 1}));
    test::addObject(world, wall, {.position = {0, -200, -130}});
    io::ParticleSource what = smoke();
    what.size = 20;
    test::addObject(world, addSource(world, "smoke", what), {.position = {0, 0, -100}});
    renderer::FrameInput in = test::frame(kSize, {.eye = {0, 0, 0}, .fov = 40});
    in.time = 5;
    const auto added = [&](float aerial) {
        io::Environment environment = test::plainEnvironment(180, 45);
        environment.sky.aerial = aerial;
        world.scene.exchange(environment);
        return addedLight(world, in);
    };
    const double near = added(0);
    EXPECT_GT(near, 0.001);
    EXPECT_LT(std::abs(added(1200)), 0.1 * near); // 120 km
}

// Where a roof darkens the fog, it darkens the fog before smoke and rain too: they add as much as before lit fog.
TEST(Particles, FogInShadowIsDarkBeforeThemToo)
{
    for (const bool rain : {false, true}) {
        test::TestWorld world;
        const io::TemplateId box = test::addTemplate(world, "box", test::box({1600, 1, 1600}, {0.02f, 0.02f, 0.02f, 1}));
        test::addObject(world, box, {.position = {0, 90, 0}});
        test::addObject(world, box, {.position = {0, -40, 0}});
        io::ParticleSource what = smoke();
        what.size = 20;
        if (!rain) test::addObject(world, addSource(world, "smoke", what), {.position = {0, -10, -100}});
        io::Environment environment = test::plainEnvironment(0, 89);
        environment.fog = {.density = rain ? 0.3f : 0.03f, .height = 20000};
        environment.shadows.distance = 300;
        environment.weather.rain = rain ? 20 : 0;
        environment.sky.aerial = 0;
        world.scene.exchange(environment);
        renderer::FrameInput in = test::frame(kSize, {.eye = {0, 0, 0}, .pitch = -10, .fov = 40});
        in.time = 5;
        in.settings.froxels = true;
        const double dark = addedLight(world, in);
        in.settings.shafts = false;
        const double lit = addedLight(world, in);
        EXPECT_LT(dark - lit, 1e-4) << rain;
    }
    EXPECT_TRUE(test::shared().shaderFaults().empty());
}

TEST(Rain, AddsStreaksByItsRateAndNoneAtNone)
{
    test::TestWorld world = groundWorld();
    const auto streaks = [&](float rain, float snow) {
        io::Environment environment = test::plainEnvironment(135, 45);
        environment.weather.rain = rain;
        environment.weather.snow = snow;
        world.scene.exchange(environment);
        const io::Image with = pictureOf(world), without = pictureOf(world, 5, false);
        return differing(with, without);
    };
    EXPECT_EQ(streaks(0, 0), 0);
    const int drizzle = streaks(1, 0), rain = streaks(10, 0);
    EXPECT_GT(drizzle, 20);
    EXPECT_GT(rain, 2 * drizzle);
    const int flurry = streaks(0, 0.3f), snow = streaks(0, 3);
    EXPECT_GT(flurry, 20);
    EXPECT_GT(snow, 2 * flurry);
}

// Under clouds that take the sun away flakes are no brighter than snowy ground; the same in the shadow of a roof.
TEST(Rain, FlakesAreLitAsTheGroundIs)
{
    const auto brighter = [](float shadow, bool roof) {
        test::TestWorld world = groundWorld(0.8f);
        io::Environment environment = test::plainEnvironment(135, 45);
        environment.clouds = {.coverage = 1, .thickness = 3000, .shadow = shadow};
        environment.weather.snow = 5;
        world.scene.exchange(environment);
        if (roof) test::addObject(world, test::addTemplate(world, "roof", test::box({200, 1, 200}, {0.02f, 0.02f, 0.02f, 1})), {.position = {0, 60, 0}});
        const io::Camera down{.eye = {0, 30, 0}, .pitch = -60, .fov = 50};
        const io::Image with = pictureOf(world, 5, true, down), without = pictureOf(world, 5, false, down);
        std::vector<double> more;
        for (int i = 0; i < kSize.x * kSize.y; ++i)
            if (const double ground = double(without.row<glm::vec3>(0)[i].y), seen = double(with.row<glm::vec3>(0)[i].y); std::abs(seen - ground) > 1e-5) more.push_back(seen / ground);
        EXPECT_GT(more.size(), 50u);
        std::ranges::sort(more);
        return more.empty() ? 0 : more[more.size() * 99 / 100];
    };
    const double open = brighter(0, false);
    EXPECT_LT(brighter(1, false), 1.4 * open);
    EXPECT_LT(brighter(0, true), 1.6 * open);
}

TEST(Rain, FallsTheSameAtTheSameTimeAndStaysInTheWorldAsTheEyeMoves)
{
    const io::Wind wind{.speed = 3, .direction = 90};
    const auto a = renderer::precipitationOf({10, false}, wind, {100, 20, 7}, 50, 1000);
    const auto b = renderer::precipitationOf({10, false}, wind, {101, 20, 7}, 50, 1000);
    EXPECT_EQ(a.drops, b.drops);
    const auto apart = [](float x, float y) { return glm::mod(x - y, PRECIPITATION_NEAR); };
    EXPECT_NEAR(apart(a.movedNear.x, b.movedNear.x), 1, 1e-4); // a metre back, relative to the eye
    EXPECT_LT(a.fall.y, -5);
    EXPECT_GT(a.fall.x, 1);
    EXPECT_EQ(renderer::precipitationOf({0, false}, wind, {}, 1, 1000).drops, 0);
    EXPECT_EQ(renderer::precipitationOf({NAN, true}, wind, {}, 1, 1000).drops, 0);
    EXPECT_GT(renderer::precipitationOf({1, true}, wind, {}, 1, 1000).fall.y, -2); // flakes are slow
}

} // namespace
