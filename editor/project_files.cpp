#include "editor/project_files.h"

#include <algorithm>

namespace editor {
namespace fs = std::filesystem;

std::vector<std::string> filesIn(const fs::path& project, const char* folder)
{
    std::vector<std::string> files;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator{project / folder, none})
        if (entry.is_regular_file(none) && !entry.path().filename().string().starts_with('.'))
            files.push_back(std::string{folder} + "/" + entry.path().filename().string());
    std::ranges::sort(files);
    return files;
}

} // namespace editor
