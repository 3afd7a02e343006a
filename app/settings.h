// Settings of a person: language, recent projects, quality, and what the editor remembers. Apart from every project.
#pragma once

#include "app/options.h"
#include "io/base/value.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

class Settings {
public:
    // Made with defaults when missing; a broken file is set aside as FILE.bad, and the log says so.
    static Settings load(const std::filesystem::path& file);
    static std::filesystem::path defaultFile(); // $XDG_CONFIG_HOME/wold/settings.json

    std::string language() const;
    Quality quality() const;
    std::vector<std::filesystem::path> recentProjects() const; // newest first
    float uiScale() const;    // "ui": {"scale": 1.5}, 0.5..3, on top of the screen's own
    double frameRate() const; // "ui": {"frame_rate": 30}, 5..240: what a moving picture should keep
    io::Value editor() const;                                  // null: nothing yet

    void setLanguage(const std::string& code);
    void setUiScale(float scale);
    void setFrameRate(double rate);
    void addRecentProject(const std::filesystem::path& project);
    void setEditor(const io::Value& value);

    // Writes what changed since it was read or saved; a fault is logged, for settings are never worth stopping for.
    void save();

private:
    std::optional<double> ui(std::string_view key) const; // a finite number of "ui"
    void complain() const; // of values that are not used as they are
    void setUi(std::string_view key, io::Value value);

    io::Value m_values; // the whole file, so that keys of a newer version survive
    io::Value m_saved;
    std::filesystem::path m_file;
};

} // namespace app
