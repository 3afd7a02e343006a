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
