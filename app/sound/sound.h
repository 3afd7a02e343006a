// Sound: lets a world be heard from where somebody stands. The entrance to app/sound; nothing of OpenAL is seen through it.
//
// Without a device it is silent, says so once and does no work. One at a time should live; it belongs to the main thread.
#pragma once

#include "io/base/complaint.h"
#include "io/scene/footsteps.h"
#include "io/scene/scene.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace app {

struct Listener {
    glm::dvec3 ear{0};        // m
    float yaw = 0, pitch = 0; // degrees, as io::Camera's
};

using io::Feet;

// Whether something stands between an ear and a sound. `object` is what the sound belongs to, and does not count.
using SoundBlocked = std::function<bool(const glm::dvec3& ear, const glm::dvec3& sound, io::ObjectId object)>;

struct SoundOptions {
    std::string device;    // as OpenAL lists it; empty: the machine's own choice
    int voices = 32;       // that sound at once
    bool loopback = false; // into memory, for tests: render()
};

struct SoundFrame {
    const io::Scene& scene;
    const io::Changes& changes; // of the scene since the last update
    Listener listener;
    double seconds = 0;                    // since the last update
    const io::Environment* now = nullptr;  // of this moment, where the day or a look is on its way; null: the scene's
};

class Sound {
public:
    explicit Sound(std::filesystem::path project, SoundOptions options = {});
    ~Sound();
    Sound(Sound&&) noexcept;
    Sound& operator=(Sound&&) noexcept;

    bool on() const; // false: no device, or it failed
    io::Complaints takeNotices(); // of the device and of files, each once

    void update(const SoundFrame& frame); // once for each picture
    // Sounds once: without direction, or from a place, where it is heard as far as `radius`, m.
    void play(const std::string& file, io::SoundGroup group = io::SoundGroup::Effects, float volume = 1);
    void play(const std::string& file, const glm::dvec3& at, double radius, io::SoundGroup group = io::SoundGroup::Effects, float volume = 1);
    // Feet that go: a step sounds after each stride. And one that comes down at once, as after a jump.
    void walk(const io::Scene& scene, const Feet& feet);
    void step(const io::Scene& scene, const Feet& feet, float volume = 1);

    void setBlocked(SoundBlocked blocked); // empty: nothing is in the way
    void setVolume(io::SoundGroup group, float volume); // factor of the amplitude
    void setMasterVolume(float volume);
    void pause(bool on);        // fades out and holds; on again where it was
    void forgetFiles();         // sounds changed on disk: they are read again
    std::size_t voices() const; // that sound now
    std::size_t streams() const; // of them, those that are read as they play

    void render(std::span<float> stereo); // of loopback: the next frames, at kLoopbackRate
    static constexpr int kLoopbackRate = 44100;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace app
