// Host: what the window asks of the program around it. The clipboard and the keyboard go through ImGui.
#pragma once

#include "io/base/value.h"

#include <filesystem>
#include <string>
#include <vector>

namespace editor {

struct Language {
    std::string code; // "cs"
    std::string name; // in the language itself: "Čeština"
};

class Host {
public:
    virtual ~Host() = default;

    virtual std::vector<Language> languages() const = 0;
    virtual std::string language() const = 0;              // code of the one in use
    virtual void setLanguage(const std::string& code) = 0; // hands its texts to editor::setTexts() and remembers it

    virtual std::vector<std::filesystem::path> recentProjects() const = 0; // newest first
    virtual void addRecentProject(const std::filesystem::path& project) = 0;

    // Whether a project that a person opens is read beside the window. False: while the window waits, so that a replay
    // does the same each time.
    virtual bool loadsInBackground() const { return false; }

    virtual std::vector<std::filesystem::path> shippedWorlds() const { return {}; } // for the start page

    // What the editor remembers for a person between two runs: one JSON object, null when there is none yet.
    virtual io::Value settings() const = 0;
    virtual void saveSettings(const io::Value& settings) = 0;
};

} // namespace editor
