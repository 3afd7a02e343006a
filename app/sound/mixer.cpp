#include "app/sound/mixer.h"

#include "app/sound/sound_sources.h"
#include "io/base/random.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace app {
namespace {

constexpr std::size_t kSpareVoices = 6; // for what is fading out
constexpr int kLoadsAtOnce = 2;         // files read in one choice, so that no picture waits for many
constexpr float kStays = 1.5f;          // how much louder another must be to take the voice of one that sounds
constexpr float kInaudible = 1e-4f;
constexpr double kRayEvery = 0.12;      // s
constexpr float kBehind = 0.4f, kTrebleBehind = 0.15f; // of what is heard round a corner
constexpr double kLastBlock = 0.06; // s, in which a device plays what it mixed before a level came to 0
constexpr double kGainSeconds = 0.03, kOpenSeconds = 0.15;

double fadeSeconds(io::SoundGroup group)
{
    switch (group) {
    case io::SoundGroup::Ambience: return 1;
    case io::SoundGroup::Music: return 1.5;
    default: return 0.06;
    }
}

glm::vec3 fromEar(const Listener& listener, const glm::dvec3& at)
{
    const glm::dquat turn = io::orientation({listener.pitch, listener.yaw, 0});
    return glm::vec3{glm::conjugate(turn) * (at - listener.ear)};
}

float share(double seconds, double of)
{
    return float(1 - std::exp(-seconds / of));
}

bool sameSound(const io::SoundSource& a, const io::SoundSource& b)
{
    return a.file == b.file && a.flat == b.flat && a.loop == b.loop;
}

} // namespace

Mixer::Mixer(std::filesystem::path project, int voices) : m_shelf{std::move(project)}, m_most{std::size_t(std::max(1, voices))}
{
    for (std::size_t i = 0; i < m_most + kSpareVoices; ++i) {
        auto voice = std::make_unique<Voice>();
        if (!voice->works()) break; // the device has no more
        m_slots.push_back({.voice = std::move(voice)});
    }
    m_most = std::min(m_most, m_slots.size());
}

float Mixer::levelFor(const Sounding& what, const Listener& listener) const
{
    const float curve = levelAt(what.source, glm::length(what.at - listener.ear));
    return curve * what.source.volume * volume(what.source.group) * m_master;
}

std::size_t Mixer::sounding() const
{
    return std::size_t(std::ranges::count_if(m_slots, [](const Slot& slot) { return !slot.free && !slot.ending; }));
}

std::size_t Mixer::streams() const
{
    return std::size_t(std::ranges::count_if(m_slots, [](const Slot& slot) { return !slot.free && slot.streamed; }));
}

void Mixer::want(std::vector<Sounding> all, const Listener& listener)
{
    std::unordered_map<std::uint64_t, Slot*> held;
    std::size_t single = 0;
    for (Slot& slot : m_slots) {
        if (slot.free || slot.ending) continue;
        if (slot.once)
            ++single;
        else
            held[slot.what.key] = &slot;
    }
    // The loudest, those that sound already before those that would be as loud.
    std::vector<std::pair<float, std::size_t>> ranked;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const float level = levelFor(all[i], listener);
        if (level > kInaudible) ranked.emplace_back(held.contains(all[i].key) ? level * kStays : level, i);
    }
    const std::size_t most = std::min(ranked.size(), m_most - std::min(single, m_most));
    std::ranges::partial_sort(ranked, ranked.begin() + std::ptrdiff_t(most), std::greater{});
    ranked.resize(most);

    std::map<std::uint64_t, bool> done; // whoever is out of hearing is played again when it comes back
    int loads = 0;
    std::vector<Sounding*> fresh;
    for (const auto& [level, i] : ranked) {
        Sounding& what = all[i];
        if (const auto played = m_done.find(what.key); played != m_done.end()) {
            done.insert(*played);
            continue;
        }
        if (const auto known = held.find(what.key); known != held.end() && sameSound(known->second->what.source, what.source)) {
            known->second->what = std::move(what);
            held.erase(known);
        } else
            fresh.push_back(&what);
    }
    m_done = std::move(done);
    for (const auto& [key, slot] : held)
        slot->ending = true;
    for (Sounding* what : fresh) {
        Slot* const slot = freeSlot();
        if (!slot) return;
        const int channels = what->source.flat ? 2 : 1;
        if (!m_shelf.has(what->source.file, channels, SoundCut::Whole) && ++loads > kLoadsAtOnce) continue; // at the next choice
        begin(*slot, std::move(*what), listener, SoundCut::Whole, 0);
    }
}

Mixer::Slot* Mixer::freeSlot()
{
    const auto found = std::ranges::find_if(m_slots, &Slot::free);
    return found == m_slots.end() ? nullptr : &*found;
}

void Mixer::once(Sounding what, const Listener& listener, SoundCut cut, std::uint32_t part)
{
    if (levelFor(what, listener) <= kInaudible) return;
    if (sounding() >= m_most) { // the faintest makes room
        Slot* faintest = nullptr;
        for (Slot& slot : m_slots)
            if (!slot.free && !slot.ending && (!faintest || slot.gain < faintest->gain)) faintest = &slot;
        if (faintest) faintest->ending = true;
    }
    if (Slot* const slot = freeSlot()) {
        slot->once = true;
        if (!begin(*slot, std::move(what), listener, cut, part)) slot->once = false;
    }
}

bool Mixer::begin(Slot& slot, Sounding what, const Listener& listener, SoundCut cut, std::uint32_t part)
{
    const io::SoundSource& source = what.source;
    const int channels = source.flat ? 2 : 1;
    const SoundShelf::Sound* const sound = m_shelf.find(source.file, channels, cut, m_time);
    if (!sound) return false;
    // Copies of a template are not in step, and one that had no voice for a while is where it would have been.
    const bool repeats = source.loop && !slot.once;
    const double from = repeats ? m_time + io::unitOf(io::hash(std::uint32_t(what.key))) * sound->seconds : 0;
    if (sound->streamed) {
        std::optional<SoundFile> file = m_shelf.openStream(source.file);
        if (!file) return false;
        slot.voice->play(*std::move(file), channels, repeats, from);
    } else
        slot.voice->play(sound->clips[part % sound->clips.size()], repeats, from);
    slot.streamed = sound->streamed;
    slot.free = slot.ending = false;
    slot.what = std::move(what);
    slot.fade = slot.once ? 1 : 0; // what sounds once has a beginning of its own
    slot.gain = -1;
    look(slot, listener);
    slot.shown = slot.open;
    update(slot, listener, 0);
    return true;
}

void Mixer::look(Slot& slot, const Listener& listener)
{
    slot.nextRay = m_time + kRayEvery;
    slot.open = 1;
    if (!m_blocked || !slot.what.source.occluded || slot.what.source.flat) return;
    // Not quite to the place itself: it may lie on the ground.
    const glm::dvec3 way = slot.what.at - listener.ear;
    const double length = glm::length(way);
    if (length < 0.5) return;
    const glm::dvec3 end = slot.what.at - way * (std::min(0.3, length * 0.1) / length);
    if (m_blocked(listener.ear, end, slot.what.object)) slot.open = 0;
}

void Mixer::update(Slot& slot, const Listener& listener, double seconds)
{
    const double fade = slot.once && slot.ending ? 0.02 : fadeSeconds(slot.what.source.group);
    slot.fade = std::clamp(slot.fade + float(seconds / fade) * (slot.ending ? -1 : 1), 0.0f, 1.0f);
    if (m_time >= slot.nextRay) look(slot, listener);
    slot.shown += (slot.open - slot.shown) * share(seconds, kOpenSeconds);
    const float target = levelFor(slot.what, listener) * glm::mix(kBehind, 1.0f, slot.shown);
    slot.gain = slot.gain < 0 ? target : slot.gain + (target - slot.gain) * share(seconds, kGainSeconds);
    slot.voice->setGain(slot.gain * slot.fade * m_hearing);
    slot.voice->setTreble(slot.what.treble * glm::mix(kTrebleBehind, 1.0f, slot.shown));
    slot.voice->setPitch(slot.what.pitch);
    slot.voice->place(slot.what.source.flat ? std::nullopt : std::optional{fromEar(listener, slot.what.at)});
}

void Mixer::update(const Listener& listener, double seconds)
{
    m_hearing = std::clamp(m_hearing + float(seconds / 0.08) * (m_pausing ? -1 : 1), 0.0f, 1.0f);
    m_quiet = m_hearing == 0 ? m_quiet + seconds : 0;
    const bool pause = m_pausing && m_quiet > kLastBlock;
    const bool still = pause && m_paused;
    if (pause != m_paused) {
        m_paused = pause;
        for (Slot& slot : m_slots)
            if (!slot.free) slot.voice->pause(pause);
    }
    if (still) return;
    m_time += seconds;
    for (Slot& slot : m_slots) {
        if (slot.free) continue;
        update(slot, listener, seconds);
        slot.quiet = slot.ending && slot.fade == 0 ? slot.quiet + seconds : 0;
        const bool goesOn = slot.voice->goOn();
        if (!goesOn && !slot.once && !slot.what.source.loop) m_done[slot.what.key] = true;
        if (!goesOn || slot.quiet > kLastBlock) {
            slot.voice->stop();
            slot.free = true;
            slot.once = slot.ending = slot.streamed = false;
        }
    }
}

void Mixer::endAll()
{
    for (Slot& slot : m_slots)
        slot.ending = !slot.free;
}

} // namespace app
