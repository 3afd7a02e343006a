#include "renderer/film.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr double kNeutral = 6500;        // K
constexpr double kTintReach = 0.02;      // distance in CIE 1960 u, v from the curve of temperatures
constexpr double kPicturesASecond = 24;  // of film
constexpr double kPictures = 65536;      // after which grain repeats

// Krystek, "An algorithm to calculate correlated colour temperature" (1985): CIE 1960 u, v of a black body.
glm::dvec2 blackBody(double t)
{
    return {(0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) / (1 + 8.42420235e-4 * t + 7.08145163e-7 * t * t),
            (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) / (1 - 2.89741816e-5 * t + 1.61456053e-7 * t * t)};
}

glm::dvec2 xyOf(const glm::dvec2& uv)
{
    const double scale = 2 * uv.x - 8 * uv.y + 4;
    return {3 * uv.x / scale, 2 * uv.y / scale};
}

glm::dvec2 uvOf(const glm::dvec2& xy)
{
    const double scale = -2 * xy.x + 12 * xy.y + 3;
    return {4 * xy.x / scale, 6 * xy.y / scale};
}

// CIE 15:2004, of phases of daylight from 4000 to 25000 K.
glm::dvec2 daylight(double t)
{
    const double r = 1e3 / t;
    const double x = t <= 7000 ? 0.244063 + r * (0.09911 + r * (2.9678 - r * 4.6070)) : 0.237040 + r * (0.24748 + r * (1.9018 - r * 2.0064));
    return {x, -3 * x * x + 2.87 * x - 0.275};
}

// Linear sRGB (IEC 61966-2-1) to CIE XYZ; columns.
const glm::dmat3 kXyzFromRgb{0.4123908, 0.2126390, 0.0193308, 0.3575843, 0.7151687, 0.1191948, 0.1804808, 0.0721923, 0.9505322};
// XYZ to the cones of Bradford (Lam 1985); columns.
const glm::dmat3 kConesFromXyz{0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367, 1.0296};

glm::dvec3 conesOf(const glm::dvec2& xy)
{
    return kConesFromXyz * glm::dvec3{xy.x / xy.y, 1, (1 - xy.x - xy.y) / xy.y};
}

// Across the curve of temperatures, towards green.
glm::dvec2 tinted(double kelvin, double tint)
{
    const glm::dvec2 uv = uvOf(chromaticity(kelvin));
    const glm::dvec2 along = uvOf(chromaticity(kelvin * 1.01)) - uvOf(chromaticity(kelvin * 0.99));
    const glm::dvec2 across = glm::normalize(glm::dvec2{along.y, -along.x});
    return xyOf(uv + (across.y > 0 ? across : -across) * (tint * kTintReach));
}

} // namespace

glm::dvec2 chromaticity(double kelvin)
{
    const double t = std::clamp(kelvin, 1000.0, 25000.0);
    const double day = glm::smoothstep(4000.0, 5000.0, t);
    const glm::dvec2 warm = xyOf(blackBody(std::min(t, 5000.0)));
    return glm::mix(warm, daylight(std::max(t, 4000.0)), day);
}

glm::mat3 whiteBalance(double kelvin, double tint)
{
    if (kelvin == kNeutral && tint == 0) return glm::mat3{1};
    const glm::dvec3 gain = conesOf(chromaticity(kNeutral)) / glm::max(conesOf(tinted(kelvin, tint)), glm::dvec3{1e-3});
    const glm::dmat3 adapted = glm::inverse(kConesFromXyz) * glm::dmat3{gain.x, 0, 0, 0, gain.y, 0, 0, 0, gain.z} * kConesFromXyz;
    return glm::mat3{glm::inverse(kXyzFromRgb) * adapted * kXyzFromRgb};
}

glsl::Film filmOf(const io::Grading& grading, const Settings& settings, double time)
{
    const io::Grading neutral{};
    const io::Grading& g = settings.grading ? grading : neutral;
    const glm::mat3 white = whiteBalance(g.temperature, g.tint);
    glsl::Film film{};
    for (int column = 0; column < 3; ++column)
        film.white[column] = glm::vec4{white[column], 0};
    film.contrast = g.contrast;
    film.saturation = g.saturation;
    film.vignette = settings.vignette ? grading.vignette : 0.0f;
    film.grain = settings.grain ? grading.grain : 0.0f;
    film.bloom = settings.bloom ? grading.bloom : 0.0f;
    film.moment = float(std::fmod(std::floor(std::max(time, 0.0) * kPicturesASecond), kPictures));
    return film;
}

} // namespace renderer
