#include "editor/toasts.h"

#include "editor/widgets.h"

#include <algorithm>
#include <limits>

namespace editor {
namespace {

constexpr double kSeconds = 5, kFade = 0.4;
constexpr float kWidth = 380;

Icon iconOf(io::log::Level level)
{
    return level == io::log::Level::Error     ? Icon::Error
           : level == io::log::Level::Warning ? Icon::Warning
                                              : Icon::Check;
}

ImU32 colourOf(io::log::Level level)
{
    return level == io::log::Level::Error     ? palette::kRed
           : level == io::log::Level::Warning ? palette::kAmber
                                              : palette::kGreen;
}

} // namespace

void Toasts::add(io::log::Level level, std::string text)
{
    io::log::write(level, text);
    m_toasts.push_back({level, std::move(text), level == io::log::Level::Info ? kSeconds : 2 * kSeconds});
}

double Toasts::nextChange() const
{
    double next = std::numeric_limits<double>::infinity();
    for (const Toast& toast : m_toasts)
        next = std::min(next, std::max(0.0, toast.left - kFade));
    return next;
}

void Toasts::pass(double seconds)
{
    for (Toast& toast : m_toasts)
        toast.left -= seconds;
    std::erase_if(m_toasts, [](const Toast& toast) { return toast.left <= 0; });
}

void Toasts::draw()
{
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    float bottom = display.y - 40;
    for (auto toast = m_toasts.rbegin(); toast != m_toasts.rend(); ++toast) {
        const auto alpha = float(std::min(1.0, toast->left / kFade));
        const ImVec2 text = ImGui::CalcTextSize(toast->text.c_str(), nullptr, false, kWidth - 56);
        const ImVec2 max{display.x - 16, bottom}, min{max.x - text.x - 56, max.y - text.y - 20};
        draw.AddRectFilled(min, max, withAlpha(IM_COL32(48, 48, 54, 250), alpha), 5);
        draw.AddRect(min, max, withAlpha(palette::kEdge, alpha), 5);
        draw.AddRectFilled(min, {min.x + 4, max.y}, withAlpha(colourOf(toast->level), alpha), 5,
                           ImDrawFlags_RoundCornersLeft);
        drawIcon(draw, iconOf(toast->level), {min.x + 15, min.y + 10}, 16, withAlpha(colourOf(toast->level), alpha));
        draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {min.x + 42, min.y + 10}, withAlpha(palette::kText, alpha),
                     toast->text.c_str(), nullptr, kWidth - 56);
        mapRect("toast", toast->text, min, max);
        bottom = min.y - 8;
    }
}

} // namespace editor
