// The curves that turn light into a picture.
#include "renderer/shaders/shared/brdf.h"
#include "renderer/shaders/shared/tone_map.h"

#include <cmath>
#include <gtest/gtest.h>

namespace {

TEST(ToneMap, NeutralIsKhronos)
{
    EXPECT_NEAR(glsl::toneMapNeutral(glm::vec3{0.5f}).x, 0.46, 1e-5);
    EXPECT_NEAR(glsl::toneMapNeutral(glm::vec3{0.18f}).x, 0.14, 1e-5);
    EXPECT_NEAR(glsl::toneMapNeutral(glm::vec3{1}).x, 0.869091, 1e-5);
    EXPECT_NEAR(glsl::toneMapNeutral(glm::vec3{4}).x, 0.983256, 1e-5);
    const glm::vec3 orange = glsl::toneMapNeutral({10, 2, 0.5f});
    EXPECT_NEAR(orange.x, 0.993898, 1e-5);
    EXPECT_NEAR(orange.y, 0.653454, 1e-5);
    EXPECT_NEAR(orange.z, 0.589621, 1e-5);
}

// Hill's published matrices, by rows, in double precision.
TEST(ToneMap, AcesIsHills)
{
    const auto rows = [](const double (&m)[3][3], const glm::dvec3& v) {
        glm::dvec3 r{0};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                r[i] += m[i][j] * v[j];
        return r;
    };
    constexpr double kIn[3][3] = {{0.59719, 0.35458, 0.04823}, {0.07600, 0.90834, 0.01566}, {0.02840, 0.13383, 0.83777}};
    constexpr double kOut[3][3] = {{1.60475, -0.53108, -0.07367}, {-0.10208, 1.10813, -0.00605}, {-0.00327, -0.07276, 1.07602}};
    for (const glm::dvec3 c : {glm::dvec3{0.18}, {1, 1, 1}, {4, 0.5, 0.1}, {0.02, 0.3, 0.9}, {0, 0, 0}, {50, 50, 50}}) {
        const glm::dvec3 v = rows(kIn, c);
        const glm::dvec3 fitted = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
        const glm::dvec3 wanted = glm::clamp(rows(kOut, fitted), 0.0, 1.0);
        const glm::dvec3 got{glsl::toneMapAces(glm::vec3{c})};
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(got[i], wanted[i], 2e-5) << c.x << " " << i;
    }
}

// Reinhard et al. 2002, equation 4: white where the luminance is that of white.
TEST(ToneMap, ReinhardIsReinhards)
{
    for (const double l : {0.01, 0.18, 1.0, 2.5, 4.0})
        EXPECT_NEAR(glsl::toneMapReinhard(glm::vec3{float(l)}).x, l * (1 + l / 16) / (1 + l), 1e-5) << l;
    EXPECT_NEAR(glsl::toneMapReinhard(glm::vec3{4}).x, 1, 1e-5);
    const glm::vec3 warm = glsl::toneMapReinhard({0.4f, 0.2f, 0.1f});
    EXPECT_NEAR(warm.x / warm.y, 2, 1e-4) << "hues stay";
}

// Sobotka's AgX: a sigmoid in log2 from 10 stops under middle grey to 6.5 above it, which puts middle grey at one half and
// rises there by 2, toe of power 3 and shoulder of 3.25; Wrensch fitted the polynomial to it.
TEST(ToneMap, AgxIsSobotkas)
{
    const auto sigmoid = [](double x) {
        constexpr double kPivotX = 10 / 16.5, kPivotY = 0.5, kSlope = 2;
        const bool shoulder = x >= kPivotX;
        const double power = shoulder ? 3.25 : 3.0; // as in his configuration
        const double reachX = shoulder ? 1 - kPivotX : kPivotX, reachY = shoulder ? 1 - kPivotY : kPivotY;
        const double scale = std::pow(std::pow(kSlope * reachX, -power) * (std::pow(kSlope * reachX / reachY, power) - 1), -1 / power);
        const double t = kSlope * std::abs(x - kPivotX) / scale;
        const double risen = scale * t / std::pow(1 + std::pow(t, power), 1 / power);
        return shoulder ? kPivotY + risen : kPivotY - risen;
    };
    double squares = 0;
    for (int i = 0; i <= 100; ++i) {
        const double error = double(glsl::agxCurve(float(i) / 100)) - sigmoid(i / 100.0);
        squares += error * error / 101;
        EXPECT_LT(std::abs(error), 0.01) << i;
    }
    RecordProperty("mean square error", std::to_string(squares));
    EXPECT_LT(squares, 1e-5);
    EXPECT_NEAR(glsl::agxCurve(float(10 / 16.5)), 0.5, 0.01);
}

TEST(ToneMap, EveryCurveRisesAndStaysInRange)
{
    for (const int curve : {TONE_AGX, TONE_NEUTRAL, TONE_ACES, TONE_REINHARD}) {
        float before = -1;
        for (int i = 0; i <= 400; ++i) {
            const float light = std::exp2(float(i) / 20 - 14);
            const glm::vec3 shown = glsl::toneMap(curve, glm::vec3{light});
            EXPECT_GE(shown.y, before - 2e-3f) << curve << " at " << light; // the fit of AgX may waver by less than a step
            EXPECT_GE(shown.y, 0);
            EXPECT_LE(shown.y, 1);
            EXPECT_NEAR(shown.x, shown.y, 0.02) << "grey stays grey";
            before = std::max(before, shown.y);
        }
        EXPECT_GT(before, 0.8f) << curve;
    }
}

TEST(ToneMap, SrgbThereAndBack)
{
    for (int i = 0; i <= 255; ++i) {
        const glm::vec3 c{float(i) / 255};
        EXPECT_NEAR(glsl::encodeSrgb(glsl::decodeSrgb(c)).x, c.x, 1e-4);
    }
    EXPECT_NEAR(glsl::encodeSrgb(glm::vec3{0.2140f}).x, 0.5, 1e-3);
}

// A white surface under even light gives back no more than it gets, and little less.
TEST(Brdf, WhiteFurnace)
{
    for (const float roughness : {0.3f, 0.5f, 0.8f, 1.0f})
        for (const float nov : {0.2f, 0.5f, 0.9f}) {
            const glm::vec3 view{std::sqrt(1 - nov * nov), nov, 0};
            const float alpha = roughness * roughness;
            double reflected = 0;
            constexpr int kRows = 400, kColumns = 200;
            for (int row = 0; row < kRows; ++row)
                for (int column = 0; column < kColumns; ++column) {
                    const float y = (float(row) + 0.5f) / kRows, s = std::sqrt(1 - y * y);
                    const float a = (float(column) + 0.5f) / kColumns * 6.2831853f;
                    const glm::vec3 light{s * std::cos(a), y, s * std::sin(a)};
                    const glm::vec3 half = glm::normalize(light + view);
                    const float f = glsl::fresnel(glm::vec3{1}, glm::dot(half, light)).x;
                    reflected += double(f * glsl::distributionGgx(alpha, half.y) * glsl::visibilitySmith(alpha, y, nov) * y);
                }
            reflected *= 6.2831853 / (kRows * kColumns);
            const double closedForm = 1 - nov * std::log((1 + nov) / nov); // of roughness 1
            EXPECT_TRUE(roughness < 1 || std::abs(reflected - closedForm) < 0.01) << reflected << " " << closedForm;
            EXPECT_LE(reflected, 1.03) << roughness << " " << nov;
            EXPECT_GE(reflected, roughness < 0.6f ? 0.8 : 0.3) << roughness << " " << nov; // rough metal loses what it scatters twice
        }
}

} // namespace
