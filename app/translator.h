// Languages of the window: app/lang/CODE.json, handed to the editor's text table, English beneath what is missing. English itself is
// compiled in: where its file is missing it is written, and where it is broken that is said and the texts are those.
#pragma once

#include "editor/host.h"
#include "io/base/result.h"

#include <string>
#include <vector>

namespace app {

std::vector<editor::Language> languages();       // sorted by code; what app/lang holds
io::Status useLanguage(const std::string& code); // an error leaves the texts as they were

extern const char* const kEnglish; // JSON

} // namespace app
