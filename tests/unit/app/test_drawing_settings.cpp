#include "app/drawing_settings.h"

#include <gtest/gtest.h>

namespace app {
namespace {

TEST(DrawingSettings, takeWordsAndBooleans)
{
    renderer::Settings s;
    EXPECT_TRUE(setDrawing(s, "shadows", "off"));
    EXPECT_FALSE(s.shadows);
    EXPECT_TRUE(setDrawing(s, "shadows", true));
    EXPECT_TRUE(s.shadows);
    EXPECT_TRUE(setDrawing(s, "tonemap", "reinhard"));
    EXPECT_EQ(s.toneMap, renderer::ToneMap::Reinhard);
    EXPECT_TRUE(setDrawing(s, "shading", "blinn-phong"));
    EXPECT_EQ(s.shading, renderer::Shading::BlinnPhong);
}

TEST(DrawingSettings, TakeAllMethods)
{
    renderer::Settings s;
    EXPECT_TRUE(setDrawing(s, "grass_method", "seeds"));
    EXPECT_EQ(s.grassMethod, renderer::GrassFrom::Seeds);
    EXPECT_TRUE(setDrawing(s, "grass_method", "blades"));
    EXPECT_TRUE(setDrawing(s, "grass", "off"));
    EXPECT_FALSE(s.grass);
    EXPECT_TRUE(setDrawing(s, "grass", "on"));
    EXPECT_TRUE(setDrawing(s, "terrain", "tessellation"));
    EXPECT_EQ(s.terrain, renderer::GroundStages::Tessellation);
    EXPECT_TRUE(setDrawing(s, "terrain", "grid"));
    EXPECT_TRUE(setDrawing(s, "aa", "taa"));
    EXPECT_EQ(s.antiAliasing, renderer::AntiAliasing::Taa);
    EXPECT_TRUE(setDrawing(s, "aa", "off"));
    EXPECT_EQ(s, (renderer::Settings{.antiAliasing = renderer::AntiAliasing::Off}));
}

TEST(DrawingSettings, unknownKeysAndValuesAreNamed)
{
    renderer::Settings s;
    const io::Status key = setDrawing(s, "shadow", "on"), value = setDrawing(s, "tonemap", "film");
    ASSERT_FALSE(key);
    EXPECT_EQ(key.error().where, "render.shadow");
    ASSERT_FALSE(value);
    EXPECT_EQ(value.error().where, "render.tonemap");
    EXPECT_EQ(s, renderer::Settings{});
}

TEST(DrawingSettings, qualityCapsShadowsAndAutoSparesSoftware)
{
    renderer::Settings low, software, hardware, high;
    applyQuality(Quality::Low, "anything", low);
    applyQuality(Quality::Auto, "llvmpipe (LLVM 15)", software);
    applyQuality(Quality::Auto, "NVIDIA H100", hardware);
    applyQuality(Quality::High, "llvmpipe", high);
    EXPECT_LT(capped(io::Shadows{}, low).resolution, capped(io::Shadows{}, software).resolution);
    EXPECT_EQ(hardware.terrain, renderer::GroundStages::Tessellation);
    EXPECT_EQ(high.terrain, renderer::GroundStages::Grid);
    EXPECT_TRUE(hardware.froxels && hardware.cloudKind == renderer::CloudKind::Volume);
    EXPECT_TRUE(software.halfOcclusion && !hardware.halfOcclusion);
    hardware.terrain = high.terrain; // all that tells the two apart
    hardware.froxels = high.froxels;
    hardware.cloudKind = high.cloudKind;
    EXPECT_EQ(hardware, high);
    EXPECT_FALSE(low.wind || software.wind); // vertices that sway cost more
    EXPECT_TRUE(high.wind);
    EXPECT_EQ(capped(io::Shadows{}, high), io::Shadows{}); // the world as its environment says
}

TEST(DrawingSettings, qualityFollowsTheSlowestOfWhatWasMeasured)
{
    EXPECT_EQ(qualityFor({}), Quality::Low);
    EXPECT_EQ(qualityFor({.triangles = 12e6, .arithmetic = 8e9, .taps = 9e7}), Quality::Medium);   // two cores
    EXPECT_EQ(qualityFor({.triangles = 4e8, .arithmetic = 4e11, .taps = 6e9}), Quality::High);     // in a processor
    EXPECT_EQ(qualityFor({.triangles = 3e9, .arithmetic = 2e13, .taps = 2e11}), Quality::Ultra);   // a large card
    EXPECT_EQ(qualityFor({.triangles = 3e9, .arithmetic = 2e13, .taps = 2e8}), Quality::Medium);   // taps are its limit
    EXPECT_EQ(qualityFor({.triangles = 5e5, .arithmetic = 2e13, .taps = 2e11}), Quality::Low);
}

} // namespace
} // namespace app
