#include "editor/actions.h"

#include "editor/text.h"
#include "editor/widgets.h"
#include "io/base/contract.h"

#include <algorithm>

namespace editor {
namespace {

bool isEnabled(const Action& action)
{
    return !action.enabled || action.enabled();
}

bool isChecked(const Action& action)
{
    return action.checked && action.checked();
}

bool keysPressed(const Action& action)
{
    return pressed(action.keys, action.repeats) || pressed(action.otherKeys, action.repeats);
}

} // namespace

void Actions::add(Action action)
{
    for (const Action& other : m_actions) {
        EXPECTS(other.id != action.id);
        EXPECTS(action.keys == Chord{} || (other.keys != action.keys && other.otherKeys != action.keys));
    }
    m_actions.push_back(std::move(action));
}

const Action& Actions::at(std::string_view id) const
{
    const auto found = std::find_if(m_actions.begin(), m_actions.end(), [id](const Action& a) { return a.id == id; });
    EXPECTS(found != m_actions.end());
    return *found;
}

bool Actions::enabled(std::string_view id) const
{
    return isEnabled(at(id));
}

void Actions::run(std::string_view id) const
{
    const Action& action = at(id);
    if (isEnabled(action)) action.run();
}

std::string Actions::text(const Action& action) const
{
    std::string text = tr("action." + std::string{action.id});
    if (action.detail)
        if (const std::string detail = action.detail(); !detail.empty()) text += ": " + detail;
    return text;
}

void Actions::menuItem(std::string_view id) const
{
    const Action& action = at(id);
    const std::string keys = name(action.keys);
    if (ui::menuItem(text(action).c_str(), keys.empty() ? nullptr : keys.c_str(), isChecked(action), isEnabled(action),
                     action.icon))
        action.run();
}

void Actions::toolButton(std::string_view id) const
{
    const Action& action = at(id);
    std::string tip = text(action);
    if (const std::string keys = name(action.keys); !keys.empty()) tip += "   " + keys;
    const std::string widget{id};
    if (ui::iconButton({.id = widget.c_str(),
                        .icon = action.icon,
                        .label = tr("action." + widget),
                        .tooltip = tip,
                        .on = isChecked(action),
                        .enabled = isEnabled(action)}))
        action.run();
}

void Actions::shortcuts() const
{
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput || ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        return;
    for (const Action& action : m_actions)
        if (keysPressed(action) && isEnabled(action)) return action.run();
}

} // namespace editor
