#include "app/folder_watch.h"

#include <utility>

namespace app {
namespace fs = std::filesystem;

bool FolderWatch::changed()
{
    const std::uint64_t now = state();
    return std::exchange(m_state, now) != now;
}

// The order of files does not count, for a folder may tell them in any.
std::uint64_t FolderWatch::state() const
{
    std::uint64_t sum = 0;
    std::error_code ignored;
    for (fs::recursive_directory_iterator it{m_folder, ignored}, end; it != end; it.increment(ignored)) {
        const auto time = fs::last_write_time(it->path(), ignored).time_since_epoch().count();
        sum += (fs::hash_value(it->path()) ^ std::uint64_t(time)) * 0x9e3779b97f4a7c15u;
    }
    return sum;
}

} // namespace app
