// The row of looks of the day: one to choose and the seconds over which it comes, this one to keep, and the day to run.
#pragma once

#include "io/scene/environment.h"

#include <optional>
#include <string>
#include <vector>

namespace editor {

class Editor;

class LookRow {
public:
    void draw(Editor& editor); // of an open document

private:
    void keepLook(Editor& editor); // the popup that asks for its name
    void choose(Editor& editor, const std::string& name);
    bool stillChosen(Editor& editor) const;
    bool isOwn(const std::string& name) const;

    // The person's own, which lie on disk: read when the row is first drawn, when it is opened, and when one is kept or removed.
    std::optional<std::vector<std::string>> m_own;
    double m_seconds = 0; // over which a chosen look comes
    std::string m_chosen; // look, as the row shows it
    io::Environment m_look; // that it is
    std::string m_name;   // to keep one under
};

} // namespace editor
