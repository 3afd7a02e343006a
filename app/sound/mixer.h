// Mixer: a bounded number of voices and what they play. The loudest get one, and each begins and ends without a click.
#pragma once

#include "app/sound/sound.h"
#include "app/sound/sound_shelf.h"

#include <array>
#include <map>
#include <memory>
#include <vector>

namespace app {

// One thing that is to be heard.
struct Sounding {
    std::uint64_t key = 0; // the same for the same thing
    io::SoundSource source;
    glm::dvec3 at{0};
    io::ObjectId object = io::ObjectId::None;
    float pitch = 1, treble = 1;
};

class Mixer {
public:
    Mixer(std::filesystem::path project, int voices);

    void setVolume(io::SoundGroup group, float volume) { m_volumes[std::size_t(group)] = volume; }
    float volume(io::SoundGroup group) const { return m_volumes[std::size_t(group)]; }
    void setMasterVolume(float volume) { m_master = volume; }
    float masterVolume() const { return m_master; }
    void setBlocked(SoundBlocked blocked) { m_blocked = std::move(blocked); }

    // What goes on sounding, as much of it as there are voices for; what is not in the list any more fades out. A sound that does not
    // repeat is played once for as long as it stays in the list.
    void want(std::vector<Sounding> all, const Listener& listener);
    // Sounds once. A part of its file, where steps are cut out of it.
    void once(Sounding what, const Listener& listener, SoundCut cut, std::uint32_t part);

    void update(const Listener& listener, double seconds); // levels, directions and blocks of what sounds
    void pause(bool on) { m_pausing = on; }
    void endAll(); // fading

    std::size_t sounding() const; // voices that are not ending
    std::size_t streams() const;
    SoundShelf& shelf() { return m_shelf; }

private:
    struct Slot {
        std::unique_ptr<Voice> voice;
        bool free = true;
        bool once = false, ending = false, streamed = false;
        Sounding what;
        float fade = 0;            // 0..1, of its beginning and end
        double quiet = 0;          // s for which it has been faded out
        float gain = -1;           // shown; below 0: not yet
        float open = 1, shown = 1; // of what stands between: what the last ray said, and what is heard
        double nextRay = 0;
    };
    float levelFor(const Sounding& what, const Listener& listener) const; // before what stands between
    Slot* freeSlot();
    bool begin(Slot& slot, Sounding what, const Listener& listener, SoundCut cut, std::uint32_t part);
    void look(Slot& slot, const Listener& listener);
    void update(Slot& slot, const Listener& listener, double seconds);

    SoundShelf m_shelf;
    std::size_t m_most;
    std::vector<Slot> m_slots;
    std::map<std::uint64_t, bool> m_done; // sounds of the list that were played once
    std::array<float, 4> m_volumes{1, 1, 1, 1};
    float m_master = 1;
    SoundBlocked m_blocked;
    double m_time = 0;
    bool m_pausing = false, m_paused = false;
    float m_hearing = 1; // 0 while paused
    double m_quiet = 0;  // s for which it has been 0
};

} // namespace app
