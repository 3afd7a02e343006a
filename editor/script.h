// Script: the editor's commands as JSON objects, one at a time: what `wold run` executes.
#pragma once

#include "editor/document.h"
#include "editor/picker.h"
#include "editor/selection.h"
#include "editor/view.h"
#include "io/base/value.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace editor {

struct RenderRequest {
    std::filesystem::path out;
    View view;
    std::string show = "final";
};

// What the floors above add. A command whose hook is missing answers that it is not available here.
struct ScriptHooks {
    std::function<void(const io::Changes&)> changed; // after every command that changed the world
    std::function<io::Status(const RenderRequest&)> render;
    std::function<io::Result<io::Value>(std::string_view key)> getSetting; // "render.shadows"
    std::function<io::Status(std::string_view key, const io::Value& value)> setSetting;
    std::function<io::Value()> stats; // members are added to those of the document
};

class Script {
public:
    // The picker is brought up to date here and before every command that needs it.
    Script(Document& document, Selection& selection, Picker& picker, View& view, ScriptHooks hooks = {});

    // {"do": NAME, …} -> {"ok": true, …} or {"ok": false, "error": "…"}. A failed command changes nothing.
    io::Value execute(const io::Value& command);

    // Hands what changed to picker, selection and the hook; execute() does so by itself.
    void follow();

    Document& document() { return m_document; }
    Selection& selection() { return m_selection; }
    const Picker& picker() const { return m_picker; }
    View& view() { return m_view; }
    const ScriptHooks& hooks() const { return m_hooks; }

private:
    Document& m_document;
    Selection& m_selection;
    Picker& m_picker;
    View& m_view;
    ScriptHooks m_hooks;
};

} // namespace editor
