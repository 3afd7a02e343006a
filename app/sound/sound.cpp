#include "app/sound/sound.h"

#include "app/sound/mixer.h"
#include "app/sound/sound_device.h"
#include "app/sound/sound_sources.h"
#include "app/sound/wind_sound.h"
#include "io/base/random.h"

#include <algorithm>

namespace app {
namespace {

constexpr double kChooseEvery = 0.1;   // s
constexpr double kConnectedEvery = 1;  // s
constexpr double kStepRadius = 22;     // m
constexpr std::uint64_t kWindKey = 1ull << 40; // beyond those of objects

io::SoundSource everywhere(const std::string& file, io::SoundGroup group, float volume)
{
    return {.file = file, .group = group, .volume = volume, .radius = 1e6f, .falloff = {{0, 1}, {1, 1}}, .flat = true};
}

io::Result<SoundDevice> deviceFor(const SoundOptions& options)
{
    return options.loopback ? SoundDevice::loopback(Sound::kLoopbackRate) : SoundDevice::open(options.device);
}

} // namespace

struct Sound::State {
    std::optional<SoundDevice> device;
    std::optional<Mixer> mixer; // goes before the device
    io::Complaints notices;
    SoundSources sources;
    io::Footsteps feet;
    std::string windFile; // empty: the project has none
    Listener listener;    // of the last update
    io::Random random{1};
    double time = 0, nextChoice = 0, nextLook = kConnectedEvery;
    std::uint64_t played = 0;

    ~State()
    {
        if (device) device->use(); // what is given back is given back to it
    }
    void findWind();
    void choose(const SoundFrame& frame, const io::Environment& now);
    void playOnce(io::SoundSource source, const glm::dvec3& at, SoundCut cut, float pitch);
    void step(const std::string& file, const glm::dvec3& at, float volume);
};

Sound::Sound(std::filesystem::path project, SoundOptions options) : m_state{std::make_unique<State>()}
{
    io::Result<SoundDevice> device = deviceFor(options);
    if (!device) {
        m_state->notices.push_back({io::Severity::Note, device.error().where, device.error().what});
        return;
    }
    m_state->device.emplace(*std::move(device));
    m_state->device->use();
    m_state->mixer.emplace(std::move(project), options.voices);
    m_state->findWind();
}

Sound::~Sound() = default;
Sound::Sound(Sound&&) noexcept = default;
Sound& Sound::operator=(Sound&&) noexcept = default;

bool Sound::on() const
{
    return m_state->mixer.has_value();
}

io::Complaints Sound::takeNotices()
{
    io::Complaints notices = std::exchange(m_state->notices, {});
    if (on()) {
        const io::Complaints files = m_state->mixer->shelf().takeComplaints();
        notices.insert(notices.end(), files.begin(), files.end());
    }
    return notices;
}

// A project's own wind is the file of that name: it has no place, so no object carries it.
void Sound::State::findWind()
{
    windFile.clear();
    for (const char* name : {"sounds/wind.ogg", "sounds/wind.flac", "sounds/wind.wav"})
        if (windFile.empty() && mixer->shelf().exists(name)) windFile = name;
}

void Sound::State::choose(const SoundFrame& frame, const io::Environment& now)
{
    std::vector<Sounding> all;
    for (const SoundSources::Place& place : sources.places()) {
        const glm::dvec3 way = place.at - frame.listener.ear;
        if (glm::dot(way, way) >= double(place.radius) * place.radius) continue;
        const io::Template* const what = frame.scene.find(place.what);
        if (!what || !heardAt(what->sound, now)) continue;
        all.push_back({.key = number(place.object), .source = what->sound, .at = place.at, .object = place.object});
    }
    if (!windFile.empty()) {
        const WindSound wind = windAt(frame.scene, now, frame.listener.ear, time);
        all.push_back({.key = kWindKey,
                       .source = everywhere(windFile, io::SoundGroup::Ambience, wind.level),
                       .at = frame.listener.ear,
                       .pitch = wind.pitch,
                       .treble = wind.treble});
    }
    mixer->want(std::move(all), frame.listener);
}

void Sound::update(const SoundFrame& frame)
{
    State& state = *m_state;
    if (!on()) return;
    state.device->use();
    state.time += frame.seconds;
    if (state.time >= state.nextLook) {
        state.nextLook = state.time + kConnectedEvery;
        if (!state.device->connected()) {
            state.notices = takeNotices();
            state.notices.push_back({io::Severity::Note, "sound", "the sound device is gone; it is quiet"});
            state.mixer.reset();
            state.device.reset();
            return;
        }
    }
    state.sources.follow(frame.scene, frame.changes);
    const bool jumped = glm::length(frame.listener.ear - state.listener.ear) > 1;
    state.listener = frame.listener;
    if (state.time >= state.nextChoice || jumped || frame.changes.everything) {
        state.nextChoice = state.time + kChooseEvery;
        state.choose(frame, frame.now ? *frame.now : frame.scene.environment());
    }
    state.mixer->update(frame.listener, frame.seconds);
}

void Sound::State::playOnce(io::SoundSource source, const glm::dvec3& at, SoundCut cut, float pitch)
{
    if (!mixer || source.file.empty()) return;
    device->use();
    source.loop = false;
    mixer->once({.key = kWindKey + ++played, .source = std::move(source), .at = at, .pitch = pitch}, listener, cut, random.next());
}

void Sound::play(const std::string& file, io::SoundGroup group, float volume)
{
    m_state->playOnce(everywhere(file, group, volume), m_state->listener.ear, SoundCut::Whole, 1);
}

void Sound::play(const std::string& file, const glm::dvec3& at, double radius, io::SoundGroup group, float volume)
{
    m_state->playOnce({.file = file, .group = group, .volume = volume, .radius = float(radius)}, at, SoundCut::Whole, 1);
}

// No two steps are alike: another part of the file, a little higher or lower, a little louder or softer.
void Sound::State::step(const std::string& file, const glm::dvec3& at, float volume)
{
    const float pitch = random.range(0.93f, 1.07f);
    const float strength = volume * random.range(0.8f, 1.0f);
    playOnce({.file = file, .group = io::SoundGroup::Steps, .volume = strength, .radius = float(kStepRadius), .occluded = false}, at, SoundCut::Parts, pitch);
}

void Sound::walk(const io::Scene& scene, const Feet& feet)
{
    if (!on()) return;
    const std::string file = m_state->feet.walk(scene, feet);
    // Who runs treads harder.
    if (!file.empty()) m_state->step(file, feet.at, std::clamp(0.5f + 0.1f * feet.speed, 0.5f, 1.1f));
}

void Sound::step(const io::Scene& scene, const Feet& feet, float volume)
{
    if (!on()) return;
    const std::string file = m_state->feet.soundUnder(scene, feet);
    if (!file.empty()) m_state->step(file, feet.at, volume);
}

void Sound::setBlocked(SoundBlocked blocked)
{
    if (on()) m_state->mixer->setBlocked(std::move(blocked));
}

void Sound::setVolume(io::SoundGroup group, float volume)
{
    if (on()) m_state->mixer->setVolume(group, volume);
}

void Sound::setMasterVolume(float volume)
{
    if (on()) m_state->mixer->setMasterVolume(volume);
}

void Sound::pause(bool on)
{
    if (m_state->mixer) m_state->mixer->pause(on);
}

void Sound::forgetFiles()
{
    if (!on()) return;
    m_state->device->use();
    m_state->mixer->endAll();
    m_state->mixer->shelf().forget();
    m_state->findWind();
}

std::size_t Sound::voices() const
{
    return on() ? m_state->mixer->sounding() : 0;
}

std::size_t Sound::streams() const
{
    return on() ? m_state->mixer->streams() : 0;
}

void Sound::render(std::span<float> stereo)
{
    std::ranges::fill(stereo, 0.0f);
    if (!on()) return;
    m_state->device->use();
    m_state->device->render(stereo);
}

} // namespace app
