// The window's content in points, and pixels of the picture for each.
#include "tests/ui/support/rig.h"

#include "editor/theme.h"
#include "editor/ui_map.h"

#include <gtest/gtest.h>

using namespace test;

namespace {

io::Value rectOf(const char* label)
{
    const io::Value map = editor::uiMap();
    for (const io::Value& item : *map.asArray())
        if (*item.find("label")->asString() == label) return *item.find("rect");
    return {};
}

TEST(Scale, TheMapIsInPixelsOfThePicture)
{
    Rig rig;
    const io::Value once = rectOf("Hierarchy");
    ImGui::GetIO().DisplayFramebufferScale = {2, 2};
    const io::Value twice = rectOf("Hierarchy");
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(*(*twice.asArray())[i].asNumber(), 2 * *(*once.asArray())[i].asNumber());
}

TEST(Scale, FontsHaveMorePixelsAndTheSamePoints)
{
    Rig rig;
    const float points = ImGui::GetFontSize(), large = editor::sizeOf(editor::largeFont());
    ImFontAtlas atlas;
    editor::addFonts(atlas, {}, 2);
    EXPECT_EQ(atlas.ConfigData[0].SizePixels, 2 * points);
    EXPECT_EQ(ImGui::GetIO().FontGlobalScale, 0.5f);
    ImGui::GetIO().FontGlobalScale = 1;
    EXPECT_EQ(large, 26);
}

TEST(Scale, EveryTabOfANarrowRegionCanBeReached)
{
    Rig rig;
    for (const char* code : {"en", "cs"}) {
        rig.host.setLanguage(code);
        for (const char* panel : {"inspector", "environment", "rendering", "terrain"}) {
            rig.editor->workspace().bringToFront(panel);
            rig.frame(2);
            const io::Value map = editor::uiMap();
            int seen = 0;
            for (const io::Value& item : *map.asArray()) {
                const io::Value::Array& rect = *item.find("rect")->asArray();
                if (*item.find("kind")->asString() == "tab" && *rect[0].asNumber() > 900) {
                    ++seen;
                    EXPECT_GE(*rect[2].asNumber(), 34) << code << " " << *item.find("label")->asString();
                }
            }
            EXPECT_GE(seen, 4) << code << " " << panel;
        }
    }
}

} // namespace
