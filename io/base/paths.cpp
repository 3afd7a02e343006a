#include "io/base/paths.h"

#include <algorithm>
#include <cstdlib>

namespace io {
namespace fs = std::filesystem;
namespace {

fs::path personal(const char* variable, const char* fallback)
{
    if (const char* set = std::getenv(variable); set && *set == '/') return fs::path{set} / "wold";
    const char* home = std::getenv("HOME");
    // Without a home (a bare container) the settings of one run are better lost than the run.
    if (!home || !*home) return fs::temp_directory_path() / "wold" / fallback;
    return fs::path{home} / fallback / "wold";
}

} // namespace

fs::path configFolder()
{
    return personal("XDG_CONFIG_HOME", ".config");
}
fs::path stateFolder()
{
    return personal("XDG_STATE_HOME", ".local/state");
}
fs::path cacheFolder()
{
    return personal("XDG_CACHE_HOME", ".cache");
}

fs::path resource(std::string_view relative)
{
    std::error_code ignored;
    if (const char* set = std::getenv("WOLD_RESOURCES"); set && *set) return fs::path{set} / relative;
    const fs::path source = fs::path{WOLD_SOURCE_DIR} / relative;
    if (fs::exists(source, ignored)) return source;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    return program.parent_path().parent_path() / "share" / "wold" / relative;
}

fs::path programModule(std::string_view name)
{
    std::error_code ignored;
    const fs::path built = fs::path{WOLD_BUILD_DIR} / name;
    if (fs::exists(built, ignored)) return built;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    return program.parent_path().parent_path() / "lib" / "wold" / name;
}

Result<fs::path> insideFolder(const fs::path& root, std::string_view relative)
{
    const fs::path asked{relative};
    const auto outside = [&] {
        return Error{root.string(), "\"" + std::string{relative} + "\" leads out of the project; name a file inside it"};
    };
    if (relative.empty()) return Error{root.string(), "an empty file name; name a file inside the project"};
    if (relative.find('\0') != std::string_view::npos || asked.is_absolute()) return outside();
    if (std::any_of(asked.begin(), asked.end(), [](const fs::path& part) { return part == ".."; })) return outside();

    std::error_code error;
    const fs::path base = fs::weakly_canonical(root, error);
    const fs::path full = error ? root / asked : fs::weakly_canonical(base / asked, error);
    if (error) return Error{(root / asked).string(), "cannot be resolved: " + error.message()};
    const auto [end, rest] = std::mismatch(base.begin(), base.end(), full.begin(), full.end());
    if (end != base.end()) return outside();
    return full;
}

} // namespace io
