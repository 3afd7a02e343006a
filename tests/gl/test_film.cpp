// Lens and film: white balance, contrast, saturation, vignette, grain, dithering. What is neutral changes nothing.
#include "renderer/film.h"
#include "renderer/shader_library.h"
#include "renderer/shaders/shared/film.h"
#include "renderer/shaders/shared/view.h"
#include "tests/gl/support/shared_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <gtest/gtest.h>

namespace {

constexpr glm::ivec2 kSize{320, 180};

glm::dvec3 lightOf(double kelvin) // linear sRGB
{
    const glm::dvec2 xy = renderer::chromaticity(kelvin);
    const glm::dvec3 xyz{xy.x / xy.y, 1, (1 - xy.x - xy.y) / xy.y};
    const glm::dmat3 rgbFromXyz{3.2409699, -0.9692436, 0.0556301, -1.5373832, 1.8759675, -0.2039770, -0.4986108, 0.0415551, 1.0569715};
    return rgbFromXyz * xyz;
}

TEST(Film, TemperaturesAreThoseOfTheCie)
{
    const auto expectNear = [](double kelvin, const glm::dvec2& xy, double within) {
        const glm::dvec2 got = renderer::chromaticity(kelvin);
        EXPECT_NEAR(got.x, xy.x, within) << kelvin;
        EXPECT_NEAR(got.y, xy.y, within) << kelvin;
    };
    expectNear(6504, {0.31271, 0.32902}, 3e-4); // D65
    expectNear(5003, {0.34567, 0.35850}, 3e-4); // D50
    expectNear(7504, {0.29902, 0.31485}, 3e-4); // D75
    expectNear(2856, {0.44758, 0.40745}, 1e-3); // illuminant A
    expectNear(2000, {0.5267, 0.4133}, 1e-3);   // a black body
}

TEST(Film, TheLightThatIsToLookWhiteDoes)
{
    EXPECT_EQ(renderer::whiteBalance(6500, 0), glm::mat3{1});
    for (const double kelvin : {1500.0, 2700.0, 4000.0, 4500.0, 5000.0, 9000.0, 20000.0}) {
        const glm::dvec3 seen = glm::dmat3{renderer::whiteBalance(kelvin, 0)} * lightOf(kelvin);
        const glm::dvec3 white = lightOf(6500);
        EXPECT_NEAR(seen.x / seen.y, white.x / white.y, 2e-3) << kelvin;
        EXPECT_NEAR(seen.z / seen.y, white.z / white.y, 2e-3) << kelvin;
        EXPECT_NEAR(seen.y, white.y, 0.05) << kelvin << ": as bright";
    }
    const glm::vec3 magenta = renderer::whiteBalance(6500, 0.8) * glm::vec3{1}, green = renderer::whiteBalance(6500, -0.8) * glm::vec3{1};
    EXPECT_LT(magenta.y, std::min(magenta.x, magenta.z));
    EXPECT_GT(green.y, std::max(green.x, green.z));
}

TEST(Film, GradingTurnsAroundMiddleGrey)
{
    glsl::Film film = renderer::filmOf({}, {}, 0);
    EXPECT_EQ(film.vignette, 0.15f);
    film.contrast = 1.7f;
    EXPECT_NEAR(glsl::contrasted(film, glm::vec3{0.18f}).x, 0.18, 1e-6);
    EXPECT_NEAR(std::log2(glsl::contrasted(film, glm::vec3{0.36f}).x / 0.18), 1.7, 1e-5) << "a stop becomes 1.7";
    film.saturation = 0;
    const glm::vec3 grey = glsl::saturated(film, {0.9f, 0.2f, 0.1f});
    EXPECT_NEAR(grey.x, grey.z, 1e-6);
    EXPECT_NEAR(grey.y, glsl::luminance({0.9f, 0.2f, 0.1f}), 1e-6);
    film.vignette = 0.4f;
    EXPECT_EQ(glsl::vignetteAt(film, glm::vec2{0.5f}), 1);
    for (const glm::vec2 corner : {glm::vec2{0, 0}, {1, 0}, {0, 1}, {1, 1}})
        EXPECT_NEAR(glsl::vignetteAt(film, corner), 0.6, 1e-6);
}

TEST(Film, DiceFallEvenlyAroundNought)
{
    double sum = 0, squares = 0;
    constexpr int kThrows = 100000;
    for (int i = 0; i < kThrows; ++i) {
        const double t = glsl::triangular((float(i) + 0.5f) / kThrows);
        ASSERT_LT(std::abs(t), 1.0);
        sum += t / kThrows;
        squares += t * t / kThrows;
    }
    EXPECT_NEAR(sum, 0, 1e-4);
    EXPECT_NEAR(squares, 1.0 / 6, 1e-3) << "the variance of a triangle";
}

// The blocks that both compilers read lie alike in both.
TEST(Film, BlocksAgree)
{
    ASSERT_TRUE(test::haveContext());
    renderer::ShaderLibrary shaders{WOLD_SOURCE_DIR "/renderer/shaders"};
    const renderer::gl::Program& p = shaders.fullScreen(
        "tone_map", {"CURVE 0", "BLOOM", "VIGNETTE", "GRAIN", "CONTRAST", "SATURATION", "WHITE_BALANCE", "CHOSEN_EXPOSURE"});
    ASSERT_TRUE(p);
    const auto offset = [&p](const char* name) {
        const GLuint index = glGetProgramResourceIndex(p.id(), GL_UNIFORM, name);
        constexpr GLenum kOffset = GL_OFFSET;
        GLint found = -1;
        if (index != GL_INVALID_INDEX) glGetProgramResourceiv(p.id(), GL_UNIFORM, index, 1, &kOffset, 1, nullptr, &found);
        return found;
    };
    EXPECT_EQ(offset("view.jitter"), offsetof(glsl::View, jitter));
    EXPECT_EQ(offset("film.white[0]"), offsetof(glsl::Film, white));
    EXPECT_EQ(offset("film.contrast"), offsetof(glsl::Film, contrast));
    EXPECT_EQ(offset("film.grain"), offsetof(glsl::Film, grain));
    EXPECT_EQ(offset("film.moment"), offsetof(glsl::Film, moment));
    EXPECT_EQ(offset("chosen.before"), 4);
}

class FilmPicture : public testing::Test {
protected:
    using Change = std::function<void(io::Environment&)>;
    void SetUp() override
    {
        world = test::makeWorld({.heightMap = {65, 65}, .trees = 20, .boxes = 6});
        test::load(world);
        in = test::frame(kSize, {.eye = {0, 100, 60}, .pitch = -20});
    }
    io::Image draw(const Change& change = [](io::Environment&) {}, double exposure = 2)
    {
        io::Environment environment = test::plainEnvironment(150, 40);
        environment.exposure = float(exposure);
        change(environment);
        world.scene.exchange(environment);
        test::shared().update(world.scene, world.assets, {.environment = true});
        test::shared().render(in);
        EXPECT_EQ(test::shared().glErrors(), 0u);
        return test::shared().readPicture();
    }
    test::TestWorld world;
    renderer::FrameInput in;
};

TEST_F(FilmPicture, NeutralValuesAreTheSameAsOff)
{
    const Change any = [](io::Environment& e) {
        e.grading = {.bloom = 0.3f, .temperature = 4000, .tint = 0.4f, .contrast = 1.4f, .saturation = 0.5f, .vignette = 0.5f, .grain = 0.5f};
        e.autoExposure.on = true;
    };
    const auto plain = draw().bytes;
    const auto rich = draw(any).bytes;
    EXPECT_NE(rich, plain);
    for (bool renderer::Settings::*off : {&renderer::Settings::bloom, &renderer::Settings::grading, &renderer::Settings::vignette,
                                          &renderer::Settings::grain, &renderer::Settings::autoExposure})
        in.settings.*off = false;
    EXPECT_EQ(draw(any).bytes, plain) << "off is neutral, to the last bit";
}

TEST_F(FilmPicture, EachFieldAndEachSwitchChangesThePicture)
{
    struct Case {
        const char* name;
        Change change;
        bool renderer::Settings::*off;
    };
    const Case cases[] = {{"bloom", [](io::Environment& e) { e.grading.bloom = 0.4f; }, &renderer::Settings::bloom},
                          {"temperature", [](io::Environment& e) { e.grading.temperature = 5000; }, &renderer::Settings::grading},
                          {"tint", [](io::Environment& e) { e.grading.tint = 0.3f; }, &renderer::Settings::grading},
                          {"contrast", [](io::Environment& e) { e.grading.contrast = 1.2f; }, &renderer::Settings::grading},
                          {"saturation", [](io::Environment& e) { e.grading.saturation = 0.7f; }, &renderer::Settings::grading},
                          {"vignette", [](io::Environment& e) { e.grading.vignette = 0.3f; }, &renderer::Settings::vignette},
                          {"grain", [](io::Environment& e) { e.grading.grain = 0.3f; }, &renderer::Settings::grain},
                          {"exposure", [](io::Environment& e) { e.autoExposure.on = true; }, &renderer::Settings::autoExposure}};
    const auto plain = draw().bytes;
    for (const Case& one : cases) {
        EXPECT_NE(draw(one.change).bytes, plain) << one.name;
        in.settings.*one.off = false;
        EXPECT_EQ(draw(one.change).bytes, plain) << one.name;
        in.settings.*one.off = true;
    }
}

double lightAt(const io::Image& image, glm::ivec2 middle) // of 5 x 5 pixels around it, linear
{
    double sum = 0;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x)
            sum += glsl::decodeSrgb(glm::vec3{image.row<glm::u8vec4>(middle.y + y)[middle.x + x]} / 255.0f).y / 25;
    return sum;
}

TEST_F(FilmPicture, VignetteDarkensCornersAndLeavesTheMiddle)
{
    in.settings.toneMap = renderer::ToneMap::Reinhard; // close to even with little light
    const io::Image plain = draw([](io::Environment&) {}, -1);
    const io::Image dark = draw([](io::Environment& e) { e.grading.vignette = 0.5f; }, -1);
    const glm::ivec2 last = kSize - 3;
    EXPECT_NEAR(lightAt(dark, kSize / 2) / lightAt(plain, kSize / 2), 1, 0.01);
    for (const glm::ivec2 corner : {glm::ivec2{2, 2}, {last.x, 2}, {2, last.y}, last})
        EXPECT_NEAR(lightAt(dark, corner) / lightAt(plain, corner), 0.53, 0.05) << corner.x << " " << corner.y;
}

TEST_F(FilmPicture, GrainIsOfItsTimeAndKeepsTheMean)
{
    const Change grainy = [](io::Environment& e) { e.grading.grain = 0.5f; };
    const auto mean = [](const io::Image& image) {
        double sum = 0;
        for (const std::byte b : image.bytes)
            sum += double(b) / double(image.bytes.size());
        return sum;
    };
    const io::Image plain = draw(), first = draw(grainy);
    EXPECT_EQ(draw(grainy).bytes, first.bytes);
    in.time = 0.5;
    EXPECT_NE(draw(grainy).bytes, first.bytes);
    EXPECT_NEAR(mean(first), mean(plain), 0.5);
}

// The longest run of pixels of the same value, of one channel, in rows of a sky.
int longestRun(const io::Image& image)
{
    int longest = 0;
    for (int channel = 0; channel < 3; ++channel)
        for (int y = 0; y < image.size.y; ++y)
            for (int x = 0, run = 0, before = -1; x < image.size.x; ++x) {
                const int value = image.row<glm::u8vec4>(y)[x][channel];
                run = value == before ? run + 1 : 1;
                before = value;
                if (value > 1 && value < 254) longest = std::max(longest, run);
            }
    return longest;
}

TEST(Dither, NoBandsInTheDuskAndOffIsExact)
{
    test::TestWorld world;
    io::Environment environment = test::plainEnvironment(0, -2);
    environment.exposure = 6;
    world.scene.exchange(environment);
    test::load(world);
    renderer::FrameInput in = test::frame({480, 270}, {.eye = {0, 2, 0}, .yaw = 180, .pitch = 25, .fov = 40});
    test::shared().render(in);
    EXPECT_LE(longestRun(test::shared().readPicture()), 24);
    in.settings.dither = false;
    test::shared().render(in);
    const io::Image exact = test::shared().readPicture(), radiance = test::shared().readRadiance();
    EXPECT_GT(longestRun(exact), 24) << "the sky is no test of bands";
    const auto exposure = float(test::shared().readExposure()); // with what eyes used to the dark add
    EXPECT_GT(exposure, 6);
    for (int y = 0; y < exact.size.y; y += 7)
        for (int x = 0; x < exact.size.x; x += 7) {
            const glm::vec3 wanted = 255.0f * glsl::toneMapToSrgb(TONE_AGX, radiance.row<glm::vec3>(y)[x] * std::exp2(exposure));
            const glm::vec3 error = glm::abs(wanted - glm::vec3{exact.row<glm::u8vec4>(y)[x]});
            ASSERT_LE(std::max({error.x, error.y, error.z}), 0.6f) << x << " " << y;
        }
}

} // namespace
