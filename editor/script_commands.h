// The script's commands by name. Each reads its arguments, calls finish(), and only then acts.
#pragma once

#include "editor/arguments.h"
#include "editor/script.h"

#include <span>

namespace editor {

// The members of the answer, or why the command was refused.
struct Answer : io::Result<io::Value> {
    using io::Result<io::Value>::Result;
    Answer(io::Value::Object members) : io::Result<io::Value>{io::Value{std::move(members)}} {}
    Answer(io::Result<io::Value> result) : io::Result<io::Value>{std::move(result)} {}
};

struct ScriptCommand {
    std::string_view name;
    Answer (*run)(Script& script, Arguments& arguments);
};

std::span<const ScriptCommand> placeCommands();     // place scatter duplicate delete group … delete_template
std::span<const ScriptCommand> scatterCommands();   // scatter_layer plant erase_plants thin evaluate …
std::span<const ScriptCommand> transformCommands(); // move rotate scale rename assign
std::span<const ScriptCommand> documentCommands();  // select set get undo redo save save_as reload view render …
std::span<const ScriptCommand> groundCommands();    // sculpt paint
std::span<const ScriptCommand> landscapeCommands(); // generate resample crop offset
std::span<const ScriptCommand> heightCommands();    // import_heights export_heights
std::span<const ScriptCommand> lookCommands();      // look looks keep_look remove_look
std::span<const ScriptCommand> instanceCommands();  // instances promote demote
std::span<const ScriptCommand> queryCommands();     // objects object selection height pick stats history

io::Value describe(const PickHit& hit, const io::Scene& scene);

} // namespace editor
