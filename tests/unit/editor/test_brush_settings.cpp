// The brush from one start of the editor to the next.
#include "editor/brush_settings.h"

#include <gtest/gtest.h>

using namespace editor;

namespace {

TEST(BrushSettings, ComeBackWhole)
{
    const Brush brush{.tool = BrushTool::Terrace, .radius = 77, .strength = 0.25f, .falloff = 0.5f, .curve = BrushCurve::Dome, .slope = {3, 60},
                      .altitude = {-4, 900}, .levelGiven = true, .level = 12, .step = 9, .scale = 400, .noise = BrushNoise::Ridged, .seed = 31,
                      .talus = 41, .rotation = 15, .stampFile = "textures/crater.png"};
    Brush read;
    restoreBrush(read, brushSettings(brush));
    EXPECT_EQ(read, brush);
    Brush plain;
    restoreBrush(plain, brushSettings(Brush{}));
    EXPECT_EQ(plain, Brush{});
}

TEST(BrushSettings, WhatIsWrongStays)
{
    Brush brush{.radius = 33};
    restoreBrush(brush, "nonsense");
    restoreBrush(brush, {});
    restoreBrush(brush, io::Value::Object{{"tool", "shovel"}, {"radius", -5}, {"seed", "x"}, {"strange", 1}, {"level_given", 3}, {"falloff", 0.25}});
    EXPECT_EQ(brush, (Brush{.radius = 33, .falloff = 0.25f}));
}

TEST(BrushSettings, LayersAreTheProjects)
{
    const io::Value saved = brushSettings({.layer = 3, .replaced = 2});
    EXPECT_EQ(saved.find("layer"), nullptr);
    EXPECT_EQ(saved.find("replaced"), nullptr);
}

} // namespace
