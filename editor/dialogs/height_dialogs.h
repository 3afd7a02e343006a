// The forms of bringing a height map in and taking the ground out: what a person chose so far, and what would come of it.
#pragma once

#include "editor/dialogs/folder_browser.h"
#include "editor/ground_import.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace editor {

class Editor;

class HeightImportForm {
public:
    void start(const std::filesystem::path& folder);
    void draw(const Document& document);
    bool ready() const { return m_plan.has_value(); }
    bool replaces() const { return !m_differences.empty(); } // a ground of other measures
    const std::string& fault() const { return m_fault; }     // of the file, or of what was typed
    io::Status import(Editor& editor);                       // one step

private:
    void read(const std::filesystem::path& file); // where it is not the one that was read
    void plan(const Document& document);
    void layoutFields();
    void measureFields();
    void findings();

    FolderBrowser m_browser;
    std::filesystem::path m_file; // that was read, or could not be
    io::RawLayout m_layout;       // as a person says
    io::HeightMeasures m_measures;
    std::optional<io::HeightSource> m_source;
    std::optional<io::ImportedGround> m_plan; // without heights
    std::vector<GroundDifference> m_differences;
    io::Complaints m_ofFile, m_ofPlan;
    std::string m_fault;
    bool m_stale = false; // the file is to be read again, with another layout
};

class HeightExportForm {
public:
    void start(const std::filesystem::path& folder, const Document& document);
    void draw(const Document& document);
    std::filesystem::path file() const;
    bool ready() const { return !m_name.empty(); }
    int step() const { return m_step; }

private:
    FolderBrowser m_browser;
    std::string m_name; // without its extension
    int m_format = 0;
    int m_step = 1;     // texels from vertex to vertex of a mesh
};

} // namespace editor
