#include "editor/script.h"

#include "editor/script_commands.h"

#include <algorithm>

namespace editor {
namespace {

const ScriptCommand* findCommand(std::string_view name)
{
    for (const auto commands : {placeCommands(), scatterCommands(), transformCommands(), documentCommands(), groundCommands(), landscapeCommands(), heightCommands(), lookCommands(), instanceCommands(), queryCommands()})
        for (const ScriptCommand& command : commands)
            if (command.name == name) return &command;
    return nullptr;
}

io::Value refusal(std::string why)
{
    return io::Value::Object{{"ok", false}, {"error", std::move(why)}};
}

} // namespace

Script::Script(Document& document, Selection& selection, Picker& picker, View& view, ScriptHooks hooks)
    : m_document{document}, m_selection{selection}, m_picker{picker}, m_view{view}, m_hooks{std::move(hooks)}
{
    follow();
}

void Script::follow()
{
    const io::Changes changes = m_document.takeChanges();
    if (changes.none()) return;
    m_picker.update(m_document.scene(), m_document.assets(), changes);
    m_selection.follow(m_document.scene(), changes);
    if (m_hooks.changed) m_hooks.changed(changes);
}

io::Value Script::execute(const io::Value& command)
{
    const io::Value* name = command.find("do");
    if (!name || !name->asString()) return refusal("a command is an object with \"do\": its name");
    const std::string& words = *name->asString();
    const ScriptCommand* known = findCommand(words);
    if (!known) return refusal("there is no command \"" + words + "\"");

    follow(); // someone else may have changed the document since
    Arguments arguments{*this, command};
    const Answer answer = known->run(*this, arguments);
    follow();
    if (!answer) return refusal(words + ": " + answer.error().text());
    io::Value::Object result{{"ok", true}};
    if (const io::Value::Object* members = answer.value().asObject())
        result.insert(result.end(), members->begin(), members->end());
    return result;
}

} // namespace editor
