// A file of sound (WAV, OGG, FLAC), read by libsndfile: whole where it is short, else block by block.
#pragma once

#include "io/base/result.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

struct sf_private_tag; // libsndfile's SNDFILE

namespace app {

constexpr int kMostSoundChannels = 8;
constexpr double kWholeSoundSeconds = 8; // what is longer is streamed: decoding this takes 30 ms of CD quality in stereo

struct SoundFormat {
    int channels = 1;
    int rate = 44100;        // Hz
    std::int64_t frames = 0; // as the file says; it may hold less
    double seconds() const { return double(frames) / rate; }
};

class SoundFile {
public:
    // Nothing but its header is read. An error names the file and what is wrong with it.
    static io::Result<SoundFile> open(const std::filesystem::path& file);

    const SoundFormat& format() const { return m_format; }
    // The next frames, of one or two samples each: channels are mixed, or one is played by both sides as loud as it was by one.
    // Fewer than asked for at the end, and where the file is damaged.
    std::size_t read(std::span<std::int16_t> samples, int channels);
    bool seek(std::int64_t frame);

private:
    struct Close {
        void operator()(sf_private_tag* file) const;
    };
    SoundFile(sf_private_tag* file, SoundFormat format) : m_file{file}, m_format{format} {}

    std::unique_ptr<sf_private_tag, Close> m_file;
    SoundFormat m_format;
    std::vector<float> m_block;
};

// A short sound, whole.
struct SoundClip {
    int channels = 1;
    int rate = 44100;
    std::vector<std::int16_t> samples;
    std::size_t frames() const { return samples.size() / std::size_t(channels); }
    double seconds() const { return double(frames()) / rate; }
};
// At most kWholeSoundSeconds of it; the error is a file without any sound.
io::Result<SoundClip> readClip(SoundFile& file, const std::filesystem::path& name, int channels);

// The sounds that follow one another in a clip with a seventh of a second of silence between them, as steps do.
std::vector<SoundClip> splitAtSilence(const SoundClip& clip);

} // namespace app
