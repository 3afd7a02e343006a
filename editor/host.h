// Host: what the window asks of the program around it. The clipboard and the keyboard go through ImGui.
#pragma once

#include "editor/held_controls.h"
#include "io/base/value.h"
#include "io/scene/changes.h"

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

    virtual float uiScale() const { return 1; } // the person's own factor on the size of everything
    virtual void setUiScale(float scale) { (void)scale; }

    // Frames a second that a moving picture should keep, drawn coarser where it must be.
    virtual double frameRate() const { return 30; }
    virtual void setFrameRate(double rate) { (void)rate; }

    virtual std::vector<std::filesystem::path> recentProjects() const = 0; // newest first
    virtual void addRecentProject(const std::filesystem::path& project) = 0;

    // True where the same input must give the same pictures however fast the machine is, as in a replay: then projects
    // are read while the window waits, and a moving picture is never drawn coarser to be quicker.
    virtual bool repeatable() const { return true; }

    // Walks through the open world from the view's camera, or from its start marker, until the person comes back.
    virtual void play(bool fromMarker) { (void)fromMarker; }

    virtual Held padsHeld() const { return {}; } // buttons and sticks of game pads

    // The open world has changed, or is another one: for what else follows it.
    virtual void worldChanged(const io::Changes& changes) { (void)changes; }

    virtual std::vector<std::filesystem::path> shippedWorlds() const { return {}; } // for the start page

    // What the editor remembers for a person between two runs: one JSON object, null when there is none yet.
    virtual io::Value settings() const = 0;
    virtual void saveSettings(const io::Value& settings) = 0;
};

} // namespace editor
