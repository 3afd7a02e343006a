// The look of the window: one palette, one set of distances, the fonts. Neutral greys and a single violet accent.
#pragma once

#include <filesystem>
#include <imgui.h>

namespace editor {

namespace palette {                                  // sRGB
constexpr ImU32 kBack = IM_COL32(22, 22, 25, 255);   // between the panels
constexpr ImU32 kStrip = IM_COL32(29, 29, 33, 255);  // menu bar, tab strips, status bar
constexpr ImU32 kPanel = IM_COL32(37, 37, 41, 255);  // what panels lie on
constexpr ImU32 kRaised = IM_COL32(50, 50, 56, 255); // buttons, section headers
constexpr ImU32 kHover = IM_COL32(63, 63, 71, 255);
constexpr ImU32 kPressed = IM_COL32(74, 74, 84, 255);
constexpr ImU32 kField = IM_COL32(25, 25, 28, 255); // what a value is typed into
constexpr ImU32 kFieldHover = IM_COL32(31, 31, 36, 255);
constexpr ImU32 kEdge = IM_COL32(15, 15, 17, 255);
constexpr ImU32 kSoftEdge = IM_COL32(54, 54, 60, 255);
constexpr ImU32 kText = IM_COL32(216, 216, 222, 255);
constexpr ImU32 kSoftText = IM_COL32(150, 150, 160, 255);
constexpr ImU32 kFaintText = IM_COL32(118, 118, 128, 255);
constexpr ImU32 kAccent = IM_COL32(141, 104, 245, 255);
constexpr ImU32 kAccentDeep = IM_COL32(98, 68, 184, 255); // behind white text
constexpr ImU32 kAccentFaint = IM_COL32(141, 104, 245, 52);
constexpr ImU32 kRed = IM_COL32(232, 86, 92, 255);
constexpr ImU32 kGreen = IM_COL32(120, 196, 88, 255);
constexpr ImU32 kBlue = IM_COL32(78, 142, 240, 255);
constexpr ImU32 kAmber = IM_COL32(240, 178, 74, 255);
} // namespace palette

ImU32 withAlpha(ImU32 colour, float alpha); // alpha 0..1 times the colour's own
ImVec4 asVec(ImU32 colour);

void applyTheme();

// Where the font files lie; the host finds them (Inter, else DejaVu Sans). An empty or unreadable path falls back to
// the one before it, and at last to ImGui's own font.
struct FontFiles {
    std::filesystem::path regular, bold, mono;
};
// Sizes are in points everywhere; a screen shows `scale` pixels for each. The fonts are made for those pixels.
void addFonts(ImFontAtlas& atlas, const FontFiles& files, float scale = 1);
float pixelsPerPoint(); // of the window

ImFont* boldFont(); // those of the current context, or its default font
ImFont* monoFont();
ImFont* largeFont();
ImFont* smallFont();
ImFont* figureFont(); // bold, a little larger
float sizeOf(const ImFont* font); // points

} // namespace editor
