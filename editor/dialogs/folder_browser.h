// A list of the folders on disk to choose one from, with the path as a text above it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace editor {

class FolderBrowser {
public:
    void start(const std::filesystem::path& folder);
    void draw(float height);
    std::filesystem::path chosen() const { return m_text; } // as typed or clicked
    bool confirmed();                                       // a double click on a project

private:
    struct Entry {
        std::string name;
        bool project = false; // holds a project.json
    };
    void enter(const std::filesystem::path& folder);
    void read();
    void row(const Entry& entry);

    std::filesystem::path m_folder;
    std::string m_text;
    std::vector<Entry> m_entries;
    bool m_confirmed = false;
};

bool isProject(const std::filesystem::path& folder);

} // namespace editor
