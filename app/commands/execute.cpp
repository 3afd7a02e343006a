#include "app/commands/commands.h"

namespace app {

int execute(const Options& options)
{
    switch (options.command) {
    case Command::Edit:
        return edit(options);
    case Command::Play:
        return play(options);
    case Command::Render:
        return render(options);
    case Command::Pick:
        return pick(options);
    case Command::Run:
        return runScript(options);
    case Command::Bench:
        return bench(options);
    case Command::Check:
        return check(options);
    case Command::New:
        return makeProject(options);
    case Command::Info:
        return info(options);
    case Command::Import:
        return importFiles(options);
    case Command::Export:
        return exportFile(options);
    }
    return 2;
}

} // namespace app
