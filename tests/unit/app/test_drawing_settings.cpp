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

TEST(DrawingSettings, whatComesLaterMayBeSetToWhatIsTrueNow)
{
    renderer::Settings s;
    for (const auto& [key, now, later] : std::vector<std::array<const char*, 3>>{{"ao", "off", "on"},
                                                                                 {"grass", "off", "on"},
                                                                                 {"bloom", "off", "on"},
                                                                                 {"wind", "off", "on"},
                                                                                 {"terrain", "grid", "tessellation"}}) {
        EXPECT_TRUE(setDrawing(s, key, now)) << key;
        const io::Status refused = setDrawing(s, key, later);
        ASSERT_FALSE(refused) << key;
        EXPECT_NE(refused.error().what.find("later release"), std::string::npos);
        EXPECT_EQ(*getDrawing(s, key), io::Value{now});
    }
    EXPECT_FALSE(setDrawing(s, "aa", "taa"));
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
    EXPECT_EQ(hardware, high);
    EXPECT_EQ(capped(io::Shadows{}, high), io::Shadows{}); // the world as its environment says
}

} // namespace
} // namespace app
