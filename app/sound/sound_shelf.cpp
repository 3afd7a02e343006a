#include "app/sound/sound_shelf.h"

#include "io/base/paths.h"

#include <algorithm>

namespace app {
namespace {

constexpr std::size_t kMostBytes = 64u << 20; // of short sounds; beyond, those go that were not used for longest

std::size_t bytesOf(const SoundShelf::Sound& sound)
{
    std::size_t bytes = 0;
    for (const auto& clip : sound.clips)
        bytes += clip->bytes();
    return bytes;
}

} // namespace

io::Result<SoundFile> SoundShelf::open(const std::string& file) const
{
    const io::Result<std::filesystem::path> path = io::insideFolder(m_project, file);
    if (!path) return path.error();
    io::Result<SoundFile> opened = SoundFile::open(*path);
    if (!opened) return io::Error{file, opened.error().what}; // as the project names it
    return opened;
}

bool SoundShelf::exists(const std::string& file) const
{
    const io::Result<std::filesystem::path> path = io::insideFolder(m_project, file);
    std::error_code fault;
    return path && std::filesystem::is_regular_file(*path, fault);
}

io::Result<SoundShelf::Sound> SoundShelf::read(const std::string& file, int channels, SoundCut cut) const
{
    io::Result<SoundFile> opened = open(file);
    if (!opened) return opened.error();
    Sound sound{.seconds = opened->format().seconds()};
    if (sound.seconds > kWholeSoundSeconds && cut == SoundCut::Whole) {
        sound.streamed = true;
        return sound;
    }
    const io::Result<SoundClip> clip = readClip(*opened, file, channels);
    if (!clip) return clip.error();
    sound.seconds = clip->seconds();
    if (cut == SoundCut::Parts)
        for (const SoundClip& part : splitAtSilence(*clip))
            sound.clips.push_back(std::make_shared<const ClipBuffer>(part));
    if (sound.clips.empty()) sound.clips.push_back(std::make_shared<const ClipBuffer>(*clip));
    return sound;
}

const SoundShelf::Sound* SoundShelf::find(const std::string& file, int channels, SoundCut cut, double now)
{
    const Key key{file, channels, cut};
    auto known = m_sounds.find(key);
    if (known == m_sounds.end()) {
        io::Result<Sound> sound = read(file, channels, cut);
        if (!sound) {
            const io::Error& fault = sound.error();
            const bool said = std::ranges::any_of(m_sounds, [&](const auto& other) { return std::get<0>(other.first) == file && !other.second; });
            if (!said) m_complaints.push_back({io::Severity::Error, fault.where, fault.what});
        }
        known = m_sounds.emplace(key, sound ? std::optional{*std::move(sound)} : std::nullopt).first;
        makeRoom(key);
    }
    if (!known->second) return nullptr;
    known->second->used = now;
    return &*known->second;
}

// Voices hold what they play, so it may go from here.
void SoundShelf::makeRoom(const Key& except)
{
    std::size_t bytes = 0;
    for (const auto& [key, sound] : m_sounds)
        bytes += sound ? bytesOf(*sound) : 0;
    while (bytes > kMostBytes) {
        auto oldest = m_sounds.end();
        for (auto it = m_sounds.begin(); it != m_sounds.end(); ++it)
            if (it->second && !it->second->clips.empty() && it->first != except && (oldest == m_sounds.end() || it->second->used < oldest->second->used)) oldest = it;
        if (oldest == m_sounds.end()) return;
        bytes -= bytesOf(*oldest->second);
        m_sounds.erase(oldest);
    }
}

std::optional<SoundFile> SoundShelf::openStream(const std::string& file)
{
    io::Result<SoundFile> opened = open(file);
    if (opened) return *std::move(opened);
    m_complaints.push_back({io::Severity::Error, opened.error().where, opened.error().what});
    for (auto& [key, sound] : m_sounds)
        if (std::get<0>(key) == file) sound.reset(); // it went since: not asked for again
    return std::nullopt;
}

} // namespace app
