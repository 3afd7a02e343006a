// The few POSIX calls behind safe writing, with errors in words.
#pragma once

#include "io/base/result.h"

#include <filesystem>
#include <string_view>

namespace io::disk {

// "FILE: what was tried: the system's reason", from errno.
Error fault(const std::filesystem::path& file, std::string_view doing);

// A new file with these bytes, flushed to the disk. `like`, when it exists, lends its permissions.
Status writeAndSync(const std::filesystem::path& file, std::string_view bytes, const std::filesystem::path& like);
Status rename(const std::filesystem::path& from, const std::filesystem::path& to);
Status syncFolder(const std::filesystem::path& folder);
Status makeFolders(const std::filesystem::path& folder);

} // namespace io::disk
