#include "app/sound/sound_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sndfile.h>

namespace app {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kBlockFrames = 4096;
constexpr double kSilenceSeconds = 1.0 / 7;
constexpr int kSilence = 100; // of 32767: what Vorbis leaves of nothing is below it

bool isOurs(int format)
{
    switch (format & SF_FORMAT_TYPEMASK) {
    case SF_FORMAT_WAV:
    case SF_FORMAT_WAVEX:
    case SF_FORMAT_RF64:
    case SF_FORMAT_OGG:
    case SF_FORMAT_FLAC: return true;
    default: return false;
    }
}

std::int16_t sampleOf(float value)
{
    if (!(std::abs(value) < 1)) value = value >= 1 ? 1.0f : value <= -1 ? -1.0f : 0.0f; // not a number: silence
    return std::int16_t(std::lround(value * 32767));
}

// Frames of `from` channels become frames of one or two.
void mix(const float* in, int from, std::int16_t* out, int to, std::size_t frames)
{
    for (std::size_t i = 0; i < frames; ++i, in += from, out += to) {
        if (from == 2 && to == 2) {
            out[0] = sampleOf(in[0]);
            out[1] = sampleOf(in[1]);
            continue;
        }
        float sum = 0;
        for (int c = 0; c < from; ++c)
            sum += in[c];
        const float mean = sum / float(from);
        if (to == 1)
            out[0] = sampleOf(mean);
        else
            out[0] = out[1] = sampleOf(mean * 0.70710678f); // two that are half as strong each
    }
}

} // namespace

void SoundFile::Close::operator()(sf_private_tag* file) const
{
    sf_close(file);
}

io::Result<SoundFile> SoundFile::open(const fs::path& file)
{
    const std::string name = file.string();
    std::error_code fault;
    if (!fs::exists(file, fault)) return io::Error{name, "does not exist"};
    if (!fs::is_regular_file(file, fault)) return io::Error{name, "is no file"}; // a pipe would hold us up
    SF_INFO info{};
    SNDFILE* const opened = sf_open(name.c_str(), SFM_READ, &info);
    if (!opened) {
        std::string why = sf_strerror(nullptr);
        while (!why.empty() && (why.back() == '.' || why.back() == '\n'))
            why.pop_back();
        return io::Error{name, "is no WAV, OGG or FLAC sound (" + why + "); convert it"};
    }
    SoundFile result{opened, {.channels = info.channels, .rate = info.samplerate, .frames = info.frames}};
    if (!isOurs(info.format)) return io::Error{name, "is a sound, but no WAV, OGG or FLAC; convert it"};
    if (info.channels < 1 || info.channels > kMostSoundChannels)
        return io::Error{name, "has " + std::to_string(info.channels) + " channels; mix it down to two, or to one for a place in the world"};
    if (info.samplerate < 1000 || info.samplerate > 192000)
        return io::Error{name, "has " + std::to_string(info.samplerate) + " samples a second, which is not between 1000 and 192000; resample it"};
    if (info.frames <= 0) return io::Error{name, "holds no sound"};
    return result;
}

std::size_t SoundFile::read(std::span<std::int16_t> samples, int channels)
{
    const std::size_t wanted = samples.size() / std::size_t(channels);
    m_block.resize(kBlockFrames * std::size_t(m_format.channels));
    std::size_t done = 0;
    while (done < wanted) {
        const std::size_t asked = std::min(kBlockFrames, wanted - done);
        const sf_count_t came = sf_readf_float(m_file.get(), m_block.data(), sf_count_t(asked));
        if (came <= 0) break;
        const auto frames = std::min(std::size_t(came), asked);
        mix(m_block.data(), m_format.channels, samples.data() + done * std::size_t(channels), channels, frames);
        done += frames;
    }
    return done;
}

bool SoundFile::seek(std::int64_t frame)
{
    return sf_seek(m_file.get(), frame, SEEK_SET) == frame;
}

io::Result<SoundClip> readClip(SoundFile& file, const fs::path& name, int channels)
{
    SoundClip clip{.channels = channels, .rate = file.format().rate};
    const auto most = std::size_t(double(clip.rate) * kWholeSoundSeconds);
    // It grows as it is read, since a header may promise more than the file has.
    while (clip.frames() < most) {
        const std::size_t before = clip.samples.size();
        const std::size_t block = std::min<std::size_t>(std::size_t(clip.rate), most - clip.frames());
        clip.samples.resize(before + block * std::size_t(channels));
        const std::size_t came = file.read(std::span{clip.samples}.subspan(before), channels);
        clip.samples.resize(before + came * std::size_t(channels));
        if (came < block) break;
    }
    if (clip.samples.empty()) return io::Error{name.string(), "holds no sound; it may be cut off"};
    clip.samples.shrink_to_fit();
    return clip;
}

std::vector<SoundClip> splitAtSilence(const SoundClip& clip)
{
    const auto channels = std::size_t(clip.channels);
    const auto gap = std::size_t(kSilenceSeconds * clip.rate);
    std::vector<SoundClip> parts;
    std::size_t first = 0, last = 0; // of the part at hand: [first, last)
    const auto cut = [&] {
        const auto at = [&](std::size_t frame) { return clip.samples.begin() + std::ptrdiff_t(frame * channels); };
        if (last > first) parts.push_back({clip.channels, clip.rate, {at(first), at(last)}});
        first = last = 0;
    };
    for (std::size_t i = 0; i < clip.frames(); ++i) {
        bool loud = false;
        for (std::size_t c = 0; c < channels; ++c)
            loud |= std::abs(int(clip.samples[i * channels + c])) > kSilence;
        if (!loud) continue;
        if (last > first && i - last >= gap) cut();
        if (last == first) first = i;
        last = i + 1;
    }
    cut();
    return parts;
}

} // namespace app
