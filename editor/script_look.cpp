#include "editor/script_commands.h"

#include "io/base/log.h"
#include "io/files/kept_looks.h"
#include "io/scene/environment_mix.h"
#include "io/scene/environment_presets.h"

#include <utility>

namespace editor {
namespace {

io::KeptLooks keptLooks()
{
    return io::KeptLooks{io::looksFolder()};
}

Answer look(Script& script, Arguments& arguments)
{
    const std::string name = arguments.text("name");
    const double share = arguments.number("share", 1, 0, 1); // of the way there
    if (const auto fault = arguments.finish()) return *fault;
    const io::Environment& own = script.document().scene().environment();
    io::Complaints complaints;
    io::Result<io::Environment> wanted = io::lookNamed(name, own, keptLooks(), complaints);
    if (!wanted) return wanted.error();
    for (const io::Complaint& complaint : complaints)
        io::log::warning("{}: {}", complaint.where, complaint.what);
    setEnvironment(script.document(), "Look of the day", share < 1 ? io::mixed(own, *wanted, share) : *std::move(wanted));
    return io::Value::Object{{"name", name}};
}

Answer looks(Script&, Arguments& arguments)
{
    if (const auto fault = arguments.finish()) return *fault;
    io::Value::Array shipped, own;
    for (const std::string_view name : enumNames(io::Preset{}))
        shipped.emplace_back(std::string{name});
    for (std::string& name : keptLooks().names())
        own.emplace_back(std::move(name));
    return io::Value::Object{{"shipped", std::move(shipped)}, {"own", std::move(own)}};
}

Answer keepLook(Script& script, Arguments& arguments)
{
    const std::string name = arguments.text("name");
    if (const auto fault = arguments.finish()) return *fault;
    if (const io::Status done = keptLooks().save(name, script.document().scene().environment()); !done) return done.error();
    return io::Value::Object{{"name", name}};
}

Answer removeLook(Script&, Arguments& arguments)
{
    const std::string name = arguments.text("name");
    if (const auto fault = arguments.finish()) return *fault;
    if (const io::Status done = keptLooks().remove(name); !done) return done.error();
    return io::Value::Object{{"name", name}};
}

constexpr ScriptCommand kCommands[] = {{"look", look}, {"looks", looks}, {"keep_look", keepLook}, {"remove_look", removeLook}};

} // namespace

std::span<const ScriptCommand> lookCommands()
{
    return kCommands;
}

} // namespace editor
