// WorldSound: what the open world sounds like from the editor's camera, while a person asks for it.
#pragma once

#include "app/sound/sound.h"
#include "editor/editor.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>

namespace app {

void setLevels(Sound& sound, const editor::SoundSettings& settings);

// By what a ray from the ear meets; the picker must outlive it. `gone`: what does not stand any more where the picker has it.
SoundBlocked blockedBy(const editor::Picker& picker, std::function<bool(io::ObjectId)> gone = {});

class WorldSound {
public:
    void note(const io::Changes& changes) { m_changes.add(changes); }
    // Begins, goes on or ends as the editor's settings say; says in the window, once, why it is silent.
    void update(editor::Editor& editor);
    void end(); // silence, until the next update
    bool on() const { return m_sound && m_sound->on(); }

private:
    void begin(editor::Editor& editor);

    using Clock = std::chrono::steady_clock;
    std::optional<Sound> m_sound;
    std::filesystem::path m_project; // that it is of
    io::Changes m_changes;           // that it has not been told
    editor::SoundSettings m_settings;
    std::set<std::string> m_said; // notices, since it was switched on
    Clock::time_point m_last;
};

} // namespace app
