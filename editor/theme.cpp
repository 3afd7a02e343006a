#include "editor/theme.h"

#include <cmath>
#include <imgui_freetype.h>

namespace editor {
namespace {

// Latin with all Czech letters, punctuation, arrows, and the few signs that units and hints use.
constexpr ImWchar kRanges[] = {0x20,   0x17f,  0x2010, 0x2026, 0x2030, 0x203a, 0x2070, 0x209c, 0x20ac, 0x20ac, 0x2122,
                               0x2122, 0x2190, 0x2193, 0x2212, 0x2212, 0x221e, 0x221e, 0x2248, 0x2265, 0};

enum FontPlace { kRegular, kBold, kMono, kLarge, kSmall, kFigure };

ImFont* fontAt(int place)
{
    const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
    return place < fonts.Size ? fonts[place] : ImGui::GetIO().FontDefault ? ImGui::GetIO().FontDefault : fonts[0];
}

void addFont(ImFontAtlas& atlas, const std::filesystem::path& file, float pixels)
{
    std::error_code none;
    ImFontConfig config;
    config.OversampleH = 1;
    if (std::filesystem::is_regular_file(file, none) &&
        atlas.AddFontFromFileTTF(file.c_str(), pixels, &config, kRanges))
        return;
    config.SizePixels = pixels;
    atlas.AddFontDefault(&config);
}

void colours(ImVec4* c)
{
    using namespace palette;
    const auto set = [c](ImGuiCol slot, ImU32 colour) { c[slot] = asVec(colour); };
    set(ImGuiCol_Text, kText);
    set(ImGuiCol_TextDisabled, kFaintText);
    set(ImGuiCol_WindowBg, kPanel);
    set(ImGuiCol_ChildBg, 0);
    set(ImGuiCol_PopupBg, IM_COL32(43, 43, 48, 252));
    set(ImGuiCol_Border, kSoftEdge);
    set(ImGuiCol_BorderShadow, 0);
    set(ImGuiCol_FrameBg, kField);
    set(ImGuiCol_FrameBgHovered, kFieldHover);
    set(ImGuiCol_FrameBgActive, kFieldHover);
    set(ImGuiCol_TitleBg, kStrip);
    set(ImGuiCol_TitleBgActive, kStrip);
    set(ImGuiCol_TitleBgCollapsed, kStrip);
    set(ImGuiCol_MenuBarBg, kStrip);
    set(ImGuiCol_ScrollbarBg, 0);
    set(ImGuiCol_ScrollbarGrab, IM_COL32(78, 78, 87, 255));
    set(ImGuiCol_ScrollbarGrabHovered, IM_COL32(98, 98, 108, 255));
    set(ImGuiCol_ScrollbarGrabActive, kAccent);
    set(ImGuiCol_CheckMark, IM_COL32(255, 255, 255, 255));
    set(ImGuiCol_SliderGrab, kAccent);
    set(ImGuiCol_SliderGrabActive, IM_COL32(165, 134, 255, 255));
    set(ImGuiCol_Button, kRaised);
    set(ImGuiCol_ButtonHovered, kHover);
    set(ImGuiCol_ButtonActive, kPressed);
    set(ImGuiCol_Header, kAccentFaint);
    set(ImGuiCol_HeaderHovered, IM_COL32(255, 255, 255, 16));
    set(ImGuiCol_HeaderActive, kAccentFaint);
    set(ImGuiCol_Separator, kSoftEdge);
    set(ImGuiCol_SeparatorHovered, kAccent);
    set(ImGuiCol_SeparatorActive, kAccent);
    set(ImGuiCol_ResizeGrip, 0);
    set(ImGuiCol_ResizeGripHovered, kHover);
    set(ImGuiCol_ResizeGripActive, kAccent);
    set(ImGuiCol_PlotLines, kAccent);
    set(ImGuiCol_PlotHistogram, kAccent);
    set(ImGuiCol_TableHeaderBg, kRaised);
    set(ImGuiCol_TableBorderStrong, kSoftEdge);
    set(ImGuiCol_TableBorderLight, kSoftEdge);
    set(ImGuiCol_TableRowBg, 0);
    set(ImGuiCol_TableRowBgAlt, IM_COL32(255, 255, 255, 6));
    set(ImGuiCol_TextSelectedBg, withAlpha(kAccent, 0.45f));
    set(ImGuiCol_DragDropTarget, kAccent);
    set(ImGuiCol_NavHighlight, kAccent);
    set(ImGuiCol_ModalWindowDimBg, IM_COL32(0, 0, 0, 140));
}

} // namespace

ImU32 withAlpha(ImU32 colour, float alpha)
{
    const auto own = float(colour >> IM_COL32_A_SHIFT & 0xff);
    return (colour & ~IM_COL32_A_MASK) | ImU32(own * alpha + 0.5f) << IM_COL32_A_SHIFT;
}

ImVec4 asVec(ImU32 colour)
{
    return ImGui::ColorConvertU32ToFloat4(colour);
}

void applyTheme()
{
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle{};
    style.WindowPadding = {8, 8};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {6, 4};
    style.CellPadding = {6, 3};
    style.IndentSpacing = 16;
    style.ScrollbarSize = 11;
    style.GrabMinSize = 10;
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = 0;
    style.WindowRounding = 0;
    style.ChildRounding = 3;
    style.FrameRounding = 3;
    style.PopupRounding = 5;
    style.ScrollbarRounding = 6;
    style.GrabRounding = 3;
    style.WindowTitleAlign = {0.5f, 0.5f};
    style.DisabledAlpha = 0.42f;
    style.CircleTessellationMaxError = 0.2f;
    colours(style.Colors);
    ImGui::GetIO().IniFilename = nullptr; // the workspace remembers the layout
    ImGui::GetIO().ConfigWindowsMoveFromTitleBarOnly = true;
}

void addFonts(ImFontAtlas& atlas, const FontFiles& files, float scale)
{
    constexpr float kPoints = 15;
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    const auto& bold = files.bold.empty() ? files.regular : files.bold;
    const auto add = [&](const std::filesystem::path& file, float points) {
        addFont(atlas, file, std::round(points * scale));
    };
    add(files.regular, kPoints);
    add(bold, kPoints);
    add(files.mono.empty() ? files.regular : files.mono, kPoints - 1);
    add(bold, std::round(kPoints * 1.75f));
    add(files.regular, kPoints - 2);
    add(bold, kPoints + 2);
    ImGui::GetIO().FontGlobalScale = 1 / scale;
    ImGui::GetStyle().CircleTessellationMaxError = 0.2f / scale; // points
}

float pixelsPerPoint()
{
    return ImGui::GetIO().DisplayFramebufferScale.x;
}

float sizeOf(const ImFont* font)
{
    return font->FontSize * ImGui::GetIO().FontGlobalScale;
}

ImFont* boldFont()
{
    return fontAt(kBold);
}

ImFont* monoFont()
{
    return fontAt(kMono);
}

ImFont* largeFont()
{
    return fontAt(kLarge);
}

ImFont* smallFont()
{
    return fontAt(kSmall);
}

ImFont* figureFont()
{
    return fontAt(kFigure);
}

} // namespace editor
