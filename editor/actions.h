// Actions: a menu entry, a key and a toolbar button are one value; everything that a person can tell the window to do
// stands in one table.
#pragma once

#include "editor/icons.h"
#include "editor/keys.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace editor {

struct Action {
    std::string_view id; // "save"; its text is tr("action.save")
    Icon icon = Icon::None;
    Chord keys = {};
    Chord otherKeys = {};
    std::function<void()> run;
    std::function<bool()> enabled = {};       // none: always
    std::function<bool()> checked = {};       // none: never
    std::function<std::string()> detail = {}; // added to the text: "Undo Move"
    bool repeats = false;                     // while the key is held
};

class Actions {
public:
    void add(Action action); // an id and a chord appear once
    const Action& at(std::string_view id) const;
    const std::vector<Action>& all() const { return m_actions; }

    bool enabled(std::string_view id) const;
    void run(std::string_view id) const; // nothing when it is not enabled
    std::string text(const Action& action) const;

    void menuItem(std::string_view id) const;
    void toolButton(std::string_view id) const;
    void shortcuts() const; // runs what the keys of this frame say, unless a text is being typed

private:
    std::vector<Action> m_actions;
};

class Editor;
Actions makeActions(Editor& editor); // the table

} // namespace editor
