// The sky against references: one that was integrated elsewhere, and tests/gl/sky_orders.csv, which tests/bench/sky_orders.cpp traces.
#include "renderer/light.h"
#include "renderer/shaders/shared/atmosphere.h"
#include "tests/gl/support/shared_renderer.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <sstream>

namespace glsl { // what sky_integral.h asks its includer for: no tables here, the integrals themselves

inline vec3 sunTransmittance(Atmosphere air, float altitude, float muSun)
{
    return muSun < horizonCosine(air, altitude) ? vec3{0} : integrateTransmittance(air, altitude, muSun, 64);
}
inline vec3 multipleScattering(Atmosphere, float, float)
{
    return vec3{0};
}

} // namespace glsl

#include "renderer/shaders/shared/sky_integral.h"

namespace {

struct Row {
    double altitude = 2, sunZenith = 0, viewZenith = 0, azimuth = 0; // m, degrees
    glm::dvec3 value{0};
    glm::dvec3 single{0};  // of sky_orders.csv
    double deviation = 0;  // share by which its value may be off, one sigma
};

std::vector<std::vector<std::string>> cellsOf(const std::string& file)
{
    std::ifstream in{file};
    std::vector<std::vector<std::string>> lines;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream cells{line};
        lines.emplace_back();
        for (std::string c; std::getline(cells, c, ',');)
            lines.back().push_back(c);
    }
    return lines;
}

std::vector<Row> reference(const std::string& quantity)
{
    const char* folder = std::getenv("WOLD_TEST_DATA");
    std::vector<Row> rows;
    for (const auto& cell : cellsOf(std::string{folder ? folder : ""} + "/sky_reference.csv")) {
        if (cell[0] != quantity) continue;
        const auto number = [&](std::size_t i) { return std::atof(cell.at(i).c_str()); };
        rows.push_back({number(2), number(3), number(4), number(5), {number(6), number(7), number(8)}});
    }
    return rows;
}

std::vector<Row> traced() // all orders, ground albedo 0.3, from 2 m to 30 km
{
    std::vector<Row> rows;
    for (const auto& cell : cellsOf(WOLD_SOURCE_DIR "/tests/gl/sky_orders.csv")) {
        const auto number = [&](std::size_t i) { return std::atof(cell.at(i).c_str()); };
        if (cell[0] == "obs_alt_m") continue;
        rows.push_back({number(0), number(1), number(2), number(3), {number(7), number(8), number(9)}, {number(4), number(5), number(6)}, number(10)});
    }
    return rows;
}

glsl::Atmosphere standardAir()
{
    return renderer::atmosphereOf(io::Sky{}, 2);
}

double cosine(double degrees)
{
    return std::cos(glm::radians(degrees));
}

double worstError(const glm::dvec3& got, const glm::dvec3& wanted)
{
    const glm::dvec3 error = glm::abs(got - wanted) / wanted;
    return std::max({error.x, error.y, error.z});
}

bool atDisc(const Row& row)
{
    return std::abs(row.sunZenith - row.viewZenith) < 1 && (row.azimuth == 0 || row.sunZenith == 0);
}

// What the picture holds in a direction.
glm::dvec3 pictureTowards(const Row& row, const io::Environment& environment, const renderer::Settings& settings = {})
{
    static test::TestWorld world;
    world.scene.exchange(environment);
    test::shared().update(world.scene, world.assets, {.environment = true});
    const io::Camera camera{.eye = {0, row.altitude, 0}, .yaw = float(-row.azimuth), .pitch = float(90 - row.viewZenith), .fov = 2};
    renderer::FrameInput in = test::frame({9, 9}, camera);
    in.settings = settings;
    test::shared().render(in);
    return glm::dvec3{test::shared().readRadiance().row<glm::vec3>(4)[4]};
}

void emptyWorld()
{
    test::TestWorld world;
    test::load(world);
}

std::string words(const Row& row)
{
    std::ostringstream out;
    out << row.altitude << " m, sun " << row.sunZenith << ", view " << row.viewZenith << ", azimuth " << row.azimuth;
    return out.str();
}

TEST(Sky, TransmittanceIsTheReferences)
{
    const auto rows = reference("transmit");
    if (rows.empty()) GTEST_SKIP() << "no sky_reference.csv";
    for (const Row& row : rows) {
        const glm::dvec3 got{glsl::integrateTransmittance(standardAir(), 0.002f, float(cosine(row.viewZenith)), 128)};
        const glm::dvec3 error = glm::abs(got - row.value);
        EXPECT_LE(std::max({error.x, error.y, error.z}), 0.002) << row.viewZenith;
    }
}

// The middle of the sun's disc is as much darker than without air as the air takes away.
TEST(Sky, TheDiscShowsTheTablesTransmittance)
{
    emptyWorld();
    for (const double zenith : {0.0, 35.0, 60.0, 75.0, 83.0, 87.0, 88.9}) {
        const glm::dvec3 wanted{glsl::integrateTransmittance(standardAir(), 0.002f, float(cosine(zenith)), 2000)};
        io::Environment environment = test::plainEnvironment(0, float(90 - zenith));
        environment.sun.irradiance = glm::vec3{0.5f};
        const Row row{.altitude = 2, .sunZenith = zenith, .viewZenith = zenith};
        const glm::dvec3 seen = pictureTowards(row, environment);
        environment.sky.rayleigh = environment.sky.ozone = glm::vec3{0};
        environment.sky.mieExtinction = environment.sky.mieScattering = 0;
        const glm::dvec3 error = glm::abs(seen / pictureTowards(row, environment) - wanted);
        EXPECT_LE(std::max({error.x, error.y, error.z}), 0.002) << zenith;
    }
}

TEST(Sky, SingleScatteringIsTheReferences)
{
    const auto rows = reference("single");
    if (rows.empty()) GTEST_SKIP() << "no sky_reference.csv";
    for (const Row& row : rows) {
        const double muView = cosine(row.viewZenith), muSun = cosine(row.sunZenith);
        const double nu = muView * muSun + std::sqrt((1 - muView * muView) * (1 - muSun * muSun)) * cosine(row.azimuth);
        const glsl::SkyRay ray = glsl::integrateSky(standardAir(), 0.002f, float(muView), float(muSun), float(nu), 0, 48);
        EXPECT_LE(worstError(glm::dvec3{ray.radiance}, row.value), 0.02) << words(row);
    }
}

// The switch for comparison, as the picture holds it.
TEST(Sky, IntegralOfThePictureIsTheFirstOrder)
{
    emptyWorld();
    std::vector<Row> rows = reference("single");
    for (Row row : traced()) {
        row.value = row.single;
        if (row.viewZenith < 90) rows.push_back(row);
    }
    for (const Row& row : rows) {
        if (atDisc(row)) continue;
        io::Environment environment = test::plainEnvironment(0, float(90 - row.sunZenith));
        environment.sky.groundAlbedo = 0;
        const glm::dvec3 got = pictureTowards(row, environment, {.sky = renderer::SkyFrom::Integral});
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(got[c], row.value[c], 0.02 * row.value[c] + 3e-7) << words(row) << " channel " << c;
    }
}

// All orders, from the picture itself.
TEST(Sky, RadianceOfThePictureIsNearTheReferences)
{
    emptyWorld();
    std::vector<Row> rows = reference("all_orders");
    for (const Row& row : traced())
        if (row.deviation < 0.1) rows.push_back(row);
    for (const Row& row : rows) {
        if (atDisc(row)) continue;
        const glm::dvec3 got = pictureTowards(row, test::plainEnvironment(0, float(90 - row.sunZenith)));
        for (int c = 0; c < 3; ++c) {
            const double ratio = got[c] / row.value[c], noise = 2 * row.deviation;
            const double most = row.sunZenith > 94 ? 2 : 1.5, blue = c == 2 ? 1.5 : 1;
            const double allowed = (row.sunZenith <= 75 ? 0.10 : 0.20) * blue;
            const bool near = row.sunZenith <= 90 ? std::abs(ratio - 1) <= allowed + noise : ratio < most + noise && ratio > 1 / most - noise;
            // Towards the ground its own light counts, which the tables know as even from all around.
            const bool ground = row.viewZenith > 90 && ratio < 1.35 + noise && ratio > 1 / 1.5 - noise;
            EXPECT_TRUE(near || ground) << words(row) << " channel " << c << ": " << ratio;
        }
    }
}

// Made at a lower resolution and looked up, as on the tiers without a GPU, it is the same sky.
TEST(Sky, CoarseSkyIsTheSameSky)
{
    emptyWorld();
    for (const float elevation : {35.0f, 3.0f, -4.0f})
        for (const double zenith : {5.0, 50.0, 80.0}) {
            const Row row{.viewZenith = zenith, .azimuth = 70};
            const io::Environment environment = test::plainEnvironment(0, elevation);
            EXPECT_LT(worstError(pictureTowards(row, environment, {.skyPixels = 3}), pictureTowards(row, environment)), 0.02) << elevation << " " << zenith;
        }
}

// From day to the end of dusk: darker by the degree, without jumps, and never anything but light.
TEST(Sky, DuskFallsEvenly)
{
    emptyWorld();
    double before = std::numeric_limits<double>::max();
    for (int zenith = 0; zenith <= 180; ++zenith) {
        const Row up{.sunZenith = double(zenith), .viewZenith = 0}, side{.sunZenith = double(zenith), .viewZenith = 80, .azimuth = 40};
        const io::Environment environment = test::plainEnvironment(0, float(90 - zenith));
        const glm::dvec3 overhead = pictureTowards(up, environment), low = pictureTowards(side, environment);
        for (const glm::dvec3& light : {overhead, low})
            for (int c = 0; c < 3; ++c) {
                ASSERT_TRUE(std::isfinite(light[c])) << zenith;
                ASSERT_GE(light[c], 0) << zenith;
            }
        const double luminance = glm::dot(overhead, glm::dvec3{0.2126, 0.7152, 0.0722});
        if (zenith > 60 && zenith <= 108) {
            EXPECT_LE(luminance, before) << zenith;
        }
        if (zenith > 2 && zenith < 90) {
            EXPECT_LT(std::abs(luminance / before - 1), 0.25) << zenith;
        }
        before = luminance;
    }
}

TEST(Sky, TablesAreMadeOnlyWhenSunOrAirChange)
{
    emptyWorld();
    io::Environment environment = test::plainEnvironment(0, 20);
    const auto calls = [&](double altitude = 2) {
        pictureTowards({.altitude = altitude, .viewZenith = 30}, environment);
        return test::shared().stats().drawCalls;
    };
    calls();
    const std::uint64_t still = calls();
    EXPECT_EQ(calls(), still);
    environment.exposure += 1;
    environment.sky.stars = 2;
    EXPECT_EQ(calls(), still);
    environment.sun.elevation = 21;
    EXPECT_EQ(calls(), still + 2); // the sky and its mirrored image; the air's own tables stay
    EXPECT_EQ(calls(), still);
    environment.sky.rayleighHeight = 8100;
    EXPECT_EQ(calls(), still + 5);
    EXPECT_EQ(calls(), still);
    EXPECT_EQ(calls(300), still + 2); // another height
}

TEST(Sky, BadAirIsClamped)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    emptyWorld();
    std::vector<io::Sky> skies(6);
    skies[0].planetRadius = 0;
    skies[1].airDepth = nan;
    skies[2].rayleigh = {-5, nan, 1e9f};
    skies[3].mieScattering = -1;
    skies[3].mieExtinction = -3;
    skies[4].mieHeight = 0;
    skies[4].rayleighHeight = nan;
    skies[5].mieG = 1;
    skies[5].groundAlbedo = 7;
    for (const io::Sky& sky : skies) {
        const glsl::Atmosphere air = renderer::atmosphereOf(sky, std::nan(""));
        EXPECT_GE(air.groundRadius, 100);
        EXPECT_GE(air.airDepth, 10);
        EXPECT_GE(std::min({air.rayleigh.x, air.rayleigh.y, air.rayleigh.z, air.mieScattering}), 0);
        EXPECT_GE(air.mieExtinction, air.mieScattering);
        EXPECT_LE(air.groundAlbedo, 1);
        io::Environment environment = test::plainEnvironment(0, 30);
        environment.sky = sky;
        for (const double view : {0.0, 80.0, 120.0}) {
            const glm::dvec3 got = pictureTowards({.viewZenith = view, .azimuth = 90}, environment);
            for (int c = 0; c < 3; ++c)
                EXPECT_TRUE(std::isfinite(got[c]) && got[c] >= 0) << view;
        }
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// A smaller planet and a thinner air look different, at once.
TEST(Sky, PlanetAndAirAreFields)
{
    emptyWorld();
    const Row row{.viewZenith = 85, .azimuth = 90};
    io::Environment environment = test::plainEnvironment(0, 10);
    const glm::dvec3 usual = pictureTowards(row, environment);
    environment.sky.planetRadius = 600;
    const glm::dvec3 small = pictureTowards(row, environment);
    EXPECT_GT(std::abs(small.x / usual.x - 1), 0.1);
    environment.sky.planetRadius = 6360;
    environment.sky.airDepth = 12;
    EXPECT_LT(pictureTowards({.viewZenith = 0}, environment).z, 0.97 * pictureTowards({.viewZenith = 0}, test::plainEnvironment(0, 10)).z);
}

TEST(Sky, SunLightOnTheGroundIsTheReferences)
{
    const auto rows = reference("ground_irradiance_sun");
    if (rows.empty()) GTEST_SKIP() << "no sky_reference.csv";
    for (const Row& row : rows) {
        const double mu = cosine(row.sunZenith);
        const glm::dvec3 toward{std::sqrt(1 - mu * mu), mu, 0};
        const glm::dvec3 got = glm::dvec3{renderer::sunThrough(standardAir(), 0, toward, glm::radians(0.265))} * mu;
        EXPECT_LE(worstError(got, row.value), 0.02) << row.sunZenith;
    }
}

// Ground has the light of its own height: none comes or goes as the eye climbs.
TEST(Sky, SunLightOnTheGroundIsOneFromEveryEye)
{
    constexpr double kAway = 3000;
    test::TestWorld world;
    test::addObject(world, test::addTemplate(world, "tower", test::box({300, 3000, 300}, {0.6f, 0.6f, 0.6f, 1})), {});
    io::Environment environment = test::plainEnvironment(180, -1); // behind the eye
    environment.sky.ambient = environment.sky.aerial = 0;
    world.scene.exchange(environment);
    test::load(world);
    const auto seen = [&](double eye, double height) {
        const io::Camera camera{.eye = {0, eye, kAway}, .pitch = float(glm::degrees(std::atan2(height - eye, kAway))), .fov = 1};
        test::shared().render(test::frame({9, 9}, camera));
        return double(test::shared().readRadiance().row<glm::vec3>(4)[4].x);
    };
    for (const double height : {50.0, 2400.0}) // which of its sheen an eye sees still differs
        EXPECT_NEAR(seen(2500, height), seen(300, height), 0.1 * seen(2500, 2400)) << height;
    EXPECT_GT(seen(300, 2400), 20 * seen(300, 50)) << "peaks keep the sun when valleys have lost it";
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// From high up the sun is seen long after it has sunk below the horizon of what shadows are drawn for.
TEST(Sky, DuskTakesNoStepInTheMountains)
{
    test::TestWorld world;
    world.scene.exchange(io::Terrain{.heightMap = "terrain/ridges.png"});
    world.scene.exchange(test::heightMap({257, 257}, 16, [](double x, double z) { return 2000 * std::pow(std::abs(std::sin(x / 500) * std::cos(z / 700)), 2.0); }));
    double most = 0, before = 0;
    for (double elevation = 0.5; elevation > -2; elevation -= 0.1) {
        io::Environment environment = test::plainEnvironment(90, float(elevation));
        environment.sky.aerial = environment.sky.ambient = 0;
        world.scene.exchange(environment);
        test::load(world);
        test::shared().render(test::frame({96, 54}, {.eye = {-300, 3000, 0}, .yaw = 90, .pitch = -50}));
        const io::Image image = test::shared().readRadiance();
        double sum = 0;
        for (int i = 0; i < 96 * 54; ++i)
            sum += double(image.row<glm::vec3>(0)[i].x);
        if (before > 0) {
            EXPECT_LT(sum, before * 1.01) << elevation;
            EXPECT_GT(sum, before - 0.1 * most) << elevation;
        }
        most = std::max(most, sum);
        before = sum;
    }
}

TEST(Sky, TheDiscIsAsWideAsTheSun)
{
    test::TestWorld world;
    world.scene.exchange(test::plainEnvironment(0, 45));
    test::load(world);
    constexpr glm::ivec2 kSize{200, 200};
    const io::Camera camera{.eye = {0, 2, 0}, .pitch = 45, .fov = 2};
    test::shared().render(test::frame(kSize, camera));
    const io::Image image = test::shared().readRadiance();
    int bright = 0;
    for (int i = 0; i < kSize.x * kSize.y; ++i)
        bright += image.row<glm::vec3>(0)[i].y > 1000;
    const double degreesAPixel = 2.0 / kSize.y;
    EXPECT_NEAR(2 * std::sqrt(bright / 3.14159265) * degreesAPixel, 0.53, 0.03);
}

TEST(Sky, NightIsDarkButNotBlackAndNeverNan)
{
    test::TestWorld world = test::makeWorld({.heightMap = {65, 65}, .trees = 5, .boxes = 2});
    for (const float elevation : {-90.0f, -30.0f, -6.0f, -0.3f, 0.0f, 0.3f, 90.0f}) {
        world.scene.exchange(test::plainEnvironment(77, elevation));
        test::load(world);
        test::shared().render(test::frame({96, 54}, {.eye = {0, 120, 0}, .pitch = -60}));
        const io::Image image = test::shared().readRadiance();
        double sum = 0;
        for (int i = 0; i < 96 * 54; ++i) {
            const glm::vec3 texel = image.row<glm::vec3>(0)[i];
            ASSERT_TRUE(std::isfinite(texel.x) && std::isfinite(texel.y) && std::isfinite(texel.z)) << elevation;
            ASSERT_GE(std::min({texel.x, texel.y, texel.z}), 0) << elevation;
            sum += texel.y;
        }
        EXPECT_GT(sum, 0) << elevation;
        if (elevation < -5) {
            EXPECT_LT(sum / (96 * 54), 5e-5) << elevation << ": a day has 0.08";
        }
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// A wall without light of its own, `metres` away across the view.
test::TestWorld wall(double metres, const glm::vec4& colour)
{
    test::TestWorld world;
    const io::TemplateId id = test::addTemplate(world, "wall", test::box({float(metres * 6), float(metres * 6), 0.02f}, colour));
    test::addObject(world, id, {.position = {0, -metres * 3, -metres}});
    return world;
}

// The air before things grows from nothing into the sky behind them.
TEST(Sky, AirBeforeThingsAgreesWithTheSky)
{
    constexpr double kMetres = 2560;
    io::Environment environment = test::plainEnvironment(20, 25);
    environment.sky.ambient = 0; // and the sun is behind: the wall is black
    for (const float pitch : {4.0f, 12.0f, 30.0f})
        for (const float yaw : {0.0f, 60.0f}) {
            const io::Camera camera{.eye = {0, 2, 0}, .yaw = yaw, .pitch = pitch, .fov = 2};
            const auto seen = [&](test::TestWorld world, float aerial) {
                environment.sky.aerial = aerial;
                world.scene.exchange(environment);
                test::load(world);
                test::shared().render(test::frame({9, 9}, camera));
                return glm::dvec3{test::shared().readRadiance().row<glm::vec3>(4)[4]};
            };
            const glm::dvec3 sky = seen({}, 1);
            const double slant = kMetres / (cosine(pitch) * cosine(yaw));
            const glm::dvec3 far = seen(wall(kMetres, {0, 0, 0, 1}), float(128000 / slant));
            EXPECT_LT(worstError(far, sky), 0.10) << pitch << " " << yaw << ": " << far.x << " " << far.y << " " << far.z << " for " << sky.x << " " << sky.y << " " << sky.z;
            glm::dvec3 before{0};
            const glm::dvec3 bare = seen(wall(kMetres, {0, 0, 0, 1}), 0);
            for (const float km : {2.0f, 8.0f, 30.0f, 80.0f}) { // on and on, without steps back
                const glm::dvec3 lit = seen(wall(kMetres, {0, 0, 0, 1}), float(km * 1000 / slant)) - bare;
                EXPECT_GT(lit.z, before.z) << km;
                before = lit;
            }
        }
    const io::Camera close{.eye = {0, 2, 0}, .fov = 2};
    const auto near = [&](float aerial) {
        test::TestWorld world = wall(0.3, {0.5f, 0.5f, 0.5f, 1});
        environment.sky.aerial = aerial;
        world.scene.exchange(environment);
        test::load(world);
        io::Camera camera = close;
        camera.eye.y = 0;
        test::shared().render(test::frame({9, 9}, camera));
        return glm::dvec3{test::shared().readRadiance().row<glm::vec3>(4)[4]};
    };
    const glm::dvec3 added = glm::abs(near(1) - near(0));
    EXPECT_LT(std::max({added.x, added.y, added.z}), 1e-4);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// A level white plate under the sky alone: its light over pi, as the reference has it.
TEST(Sky, LightOnLevelGroundIsTheReferences)
{
    const auto rows = reference("ground_irradiance_sky");
    if (rows.empty()) GTEST_SKIP() << "no sky_reference.csv";
    for (const Row& row : rows) {
        const auto plate = [&](float ambient, float white) {
            test::TestWorld world;
            test::addObject(world, test::addTemplate(world, "plate", test::box({50, 1, 50}, {white, white, white, 1})), {.position = {0, -1, 0}});
            io::Environment environment = test::plainEnvironment(0, float(90 - row.sunZenith));
            environment.sky.ambient = ambient;
            world.scene.exchange(environment);
            test::load(world);
            renderer::FrameInput in = test::frame({9, 9}, {.eye = {3, 3, 0}, .pitch = -89.9f, .fov = 2});
            in.settings.ao = false;
            test::shared().render(in);
            return glm::dvec3{test::shared().readRadiance().row<glm::vec3>(4)[4]};
        };
        // What is white more than what is black, which mirrors as much.
        const glm::dvec3 got = (plate(1, 1) - plate(0, 1)) - (plate(1, 0) - plate(0, 0));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(got[c] * 3.14159265 / row.value[c], 1, c == 2 ? 0.20 : 0.15) << row.sunZenith << " channel " << c;
    }
}

// A level mirror shows the sky that it faces; the rougher it is, the more of the sky around.
TEST(Sky, MetalMirrorsTheSky)
{
    const io::Environment environment = test::plainEnvironment(0, 20);
    const auto lit = [&](float roughness, float ambient) {
        auto model = std::make_shared<io::Model>(*test::box({50, 1, 50}, {1, 1, 1, 1}));
        model->materials.at(0).metallic = 1;
        model->materials.at(0).roughness = roughness;
        test::TestWorld world;
        test::addObject(world, test::addTemplate(world, "plate", model), {.position = {0, -1, 0}});
        io::Environment shown = environment;
        shown.sky.ambient = ambient;
        world.scene.exchange(shown);
        test::load(world);
        // Away from the sun, and down at an angle whose mirrored image rises as far.
        test::shared().render(test::frame({9, 9}, {.eye = {0, 2, -3}, .yaw = 180, .pitch = -35, .fov = 2}));
        return glm::dvec3{test::shared().readRadiance().row<glm::vec3>(4)[4]};
    };
    const auto mirrored = [&](float roughness) { return lit(roughness, 1) - lit(roughness, 0); }; // without the sun's lobe
    const glm::dvec3 smooth = mirrored(0.05f), rough = mirrored(0.5f);
    emptyWorld();
    const glm::dvec3 sky = pictureTowards({.viewZenith = 55, .azimuth = 180}, environment);
    EXPECT_LT(worstError(smooth, sky), 0.06) << smooth.x << " " << smooth.z << " for " << sky.x << " " << sky.z;
    for (int c = 0; c < 3; ++c)
        EXPECT_TRUE(rough[c] > 0.6 * sky[c] && rough[c] < 2.0 * sky[c]) << rough[c] / sky[c];
    EXPECT_GT(worstError(rough, sky), worstError(smooth, sky));
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

} // namespace
