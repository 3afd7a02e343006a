// Languages of the window: app/lang/CODE.json, handed to the editor's text table, English beneath what is missing. Those that ship
// are compiled in too: where a file is missing it is written, and where English is broken that is said and the texts are those.
#pragma once

#include "editor/host.h"
#include "io/base/result.h"

#include <string>
#include <vector>

namespace app {

std::vector<editor::Language> languages();       // sorted by code; what app/lang holds
io::Status useLanguage(const std::string& code); // an error leaves the texts as they were

extern const char *const kEnglish, *const kCzech; // JSON

} // namespace app
