// The sky against a reference that was integrated elsewhere.
#include "renderer/light.h"
#include "renderer/shaders/shared/atmosphere.h"
#include "tests/gl/support/shared_renderer.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace glsl { // what sky_integral.h asks its includer for: no tables here, the integrals themselves

inline vec3 sunTransmittance(Atmosphere air, float altitude, float muSun)
{
    return muSun < horizonCosine(altitude) ? vec3{0} : integrateTransmittance(air, altitude, muSun, 64);
}
inline vec3 multipleScattering(Atmosphere, float, float)
{
    return vec3{0};
}

} // namespace glsl

#include "renderer/shaders/shared/sky_integral.h"

namespace {

struct Row {
    std::string quantity;
    double sunZenith = 0, viewZenith = 0, azimuth = 0;
    glm::dvec3 value{0};
};

std::vector<Row> reference(const std::string& quantity)
{
    const char* folder = std::getenv("WOLD_TEST_DATA");
    std::ifstream file{std::string{folder ? folder : ""} + "/sky_reference.csv"};
    std::vector<Row> rows;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with(quantity + ",")) continue;
        std::istringstream cells{line};
        std::vector<std::string> cell;
        for (std::string c; std::getline(cells, c, ',');)
            cell.push_back(c);
        const auto number = [&](std::size_t i) { return std::atof(cell.at(i).c_str()); };
        rows.push_back({cell[0], number(3), number(4), number(5), {number(6), number(7), number(8)}});
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

TEST(Sky, SingleScatteringIsTheReferences)
{
    const auto rows = reference("single");
    if (rows.empty()) GTEST_SKIP() << "no sky_reference.csv";
    for (const Row& row : rows) {
        const double muView = cosine(row.viewZenith), muSun = cosine(row.sunZenith);
        const double nu = muView * muSun + std::sqrt((1 - muView * muView) * (1 - muSun * muSun)) * cosine(row.azimuth);
        const glsl::SkyRay ray = glsl::integrateSky(standardAir(), 0.002f, float(muView), float(muSun), float(nu), 48);
        EXPECT_LE(worstError(glm::dvec3{ray.radiance}, row.value), row.sunZenith > 90 ? 0.03 : 0.02)
            << row.sunZenith << " " << row.viewZenith << " " << row.azimuth;
    }
}

// All orders, from the picture itself, with the approximation that is known to be about this good.
TEST(Sky, RadianceOfThePictureIsNearTheReferences)
{
    const auto rows = reference("all_orders");
    if (rows.empty()) GTEST_SKIP() << "no sky_reference.csv";
    test::TestWorld world;
    constexpr glm::ivec2 kSize{64, 64};
    for (const Row& row : rows) {
        if (row.sunZenith > 90) continue;
        const bool atDisc = std::abs(row.sunZenith - row.viewZenith) < 1 && (row.azimuth == 0 || row.sunZenith == 0);
        if (atDisc) continue;
        io::Environment environment = test::plainEnvironment(0, float(90 - row.sunZenith));
        world.scene.exchange(environment);
        test::load(world);
        const io::Camera camera{.eye = {0, 2, 0}, .yaw = float(-row.azimuth), .pitch = float(90 - row.viewZenith), .fov = 2};
        test::shared().render(test::frame(kSize, camera));
        const io::Image image = test::shared().readRadiance();
        const glm::dvec3 got{image.row<glm::vec3>(32)[32]};
        const glm::dvec3 allowed = row.sunZenith <= 75 ? glm::dvec3{0.10, 0.10, 0.15} : glm::dvec3{0.20, 0.20, 0.30};
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(got[c] / row.value[c], 1, allowed[c])
                << "sun " << row.sunZenith << " view " << row.viewZenith << " azimuth " << row.azimuth << " channel " << c;
    }
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
        test::shared().render(test::frame({96, 54}, {.eye = {0, 120, 0}, .pitch = -10}));
        const io::Image image = test::shared().readRadiance();
        double sum = 0;
        for (int i = 0; i < 96 * 54; ++i) {
            const glm::vec3 texel = image.row<glm::vec3>(0)[i];
            ASSERT_TRUE(std::isfinite(texel.x) && std::isfinite(texel.y) && std::isfinite(texel.z)) << elevation;
            ASSERT_GE(std::min({texel.x, texel.y, texel.z}), 0) << elevation;
            sum += texel.y;
        }
        EXPECT_GT(sum, 0) << elevation;
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

} // namespace
