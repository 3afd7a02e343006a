// A list of the folders on disk, and of files where some are wanted, to choose one from, with the path as a text above it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace editor {

class FolderBrowser {
public:
    using Wanted = std::function<bool(const std::filesystem::path& file)>; // by its name
    void start(const std::filesystem::path& folder, Wanted files = {});    // without `files` only folders are shown
    void draw(float height);
    std::filesystem::path chosen() const { return m_text; } // as typed or clicked
    bool confirmed();                                       // a double click on a project

private:
    struct Entry {
        std::string name;
        bool project = false; // holds a project.json
        bool file = false;
    };
    void enter(const std::filesystem::path& folder);
    void read();
    void row(const Entry& entry);

    std::filesystem::path m_folder;
    std::string m_text;
    std::vector<Entry> m_entries; // folders first
    Wanted m_files;
    bool m_confirmed = false;
};

bool isProject(const std::filesystem::path& folder);

} // namespace editor
