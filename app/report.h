// What a command says to the person who called it: progress and faults on stderr, figures as JSON.
#pragma once

#include "io/base/complaint.h"
#include "io/base/progress.h"
#include "io/base/result.h"
#include "io/base/value.h"

#include <string>
#include <string_view>

namespace app {

// The data or the machine is at fault: the last line on stderr, and the exit code.
int fault(const io::Error& error);
// The words of the call are wrong.
int misuse(std::string_view what);

// A bar on a terminal, one line per step when piped, nothing when quiet.
io::Progress progressOnStderr(bool quiet);

void logComplaints(const io::Complaints& complaints);

// To the file that --json names; nothing when it names none.
io::Status writeFigures(const std::string& json, const io::Value& figures);

} // namespace app
