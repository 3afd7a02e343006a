// The commands of `wold`: each takes the parsed options and answers the exit code of the process.
#pragma once

#include "app/options.h"

namespace app {

int execute(const Options& options);

int edit(const Options& options);
int play(const Options& options);
int playInWindow(const Options& options);
int render(const Options& options);
int pick(const Options& options);
int runScript(const Options& options);
int bench(const Options& options);
int check(const Options& options);
int makeProject(const Options& options);
int info(const Options& options);
int importFiles(const Options& options);
int exportFile(const Options& options);

} // namespace app
