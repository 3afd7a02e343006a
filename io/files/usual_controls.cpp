#include "io/files/usual_controls.h"

#include <algorithm>
#include <array>

namespace io {
namespace {

struct Usual {
    std::string_view action;
    std::array<std::string_view, 3> by;
};
constexpr Usual kUsual[]{{"forward", {"W", "Up", "pad left -y"}}, {"back", {"S", "Down", "pad left +y"}},
                         {"left", {"A", "Left", "pad left -x"}},  {"right", {"D", "Right", "pad left +x"}},
                         {"look_left", {"pad right -x"}},         {"look_right", {"pad right +x"}},
                         {"look_up", {"pad right -y"}},           {"look_down", {"pad right +y"}},
                         {"run", {"Shift", "pad left stick"}},    {"crouch", {"Ctrl", "C", "pad B"}},
                         {"jump", {"Space", "pad A"}},            {"fly", {"F", "pad back"}},
                         {"eye", {"V", "pad Y"}}};

constexpr auto kActions = [] {
    std::array<std::string_view, std::size(kUsual)> names;
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = kUsual[i].action;
    return names;
}();

} // namespace

std::span<const std::string_view> playActions()
{
    return kActions;
}

std::vector<std::string> usualControls(std::string_view action)
{
    std::vector<std::string> all;
    for (const Usual& usual : kUsual)
        for (const std::string_view by : usual.by)
            if (usual.action == action && !by.empty()) all.emplace_back(by);
    return all;
}

std::vector<std::string> controlsOf(std::span<const Control> controls, std::string_view action)
{
    std::vector<std::string> all;
    bool said = false;
    for (const Control& control : controls) {
        if (control.action != action) continue;
        said = true;
        if (!control.by.empty()) all.push_back(control.by);
    }
    return said ? all : usualControls(action);
}

std::vector<Control> withControls(std::span<const Control> controls, std::string_view action, const std::vector<std::string>& by)
{
    std::vector<Control> result{controls.begin(), controls.end()};
    const auto at = std::ranges::find(result, action, &Control::action) - result.begin(); // its lines stay where they were
    std::erase_if(result, [&](const Control& control) { return control.action == action; });
    if (by == usualControls(action)) return result;
    std::vector<Control> lines;
    for (const std::string& one : by)
        lines.push_back({std::string{action}, one});
    if (lines.empty()) lines.push_back({std::string{action}, ""});
    result.insert(result.begin() + at, lines.begin(), lines.end());
    return result;
}

} // namespace io
