// wold new: a project from a starter.
#include "app/commands/commands.h"
#include "app/report.h"
#include "io/files/project.h"

#include <fmt/format.h>

namespace app {

int makeProject(const Options& options)
{
    if (options.starter != "empty" && options.starter != "valley")
        return misuse(fmt::format("--from {}: choose empty or valley", options.starter));
    const io::Status made = io::newProject(options.folder, options.starter);
    if (!made) return fault(made.error());
    const io::Status written = writeFigures(options.json, io::Value::Object{{"project", options.folder.string()}});
    return written ? 0 : fault(written.error());
}

} // namespace app
