#include "app/sound/voice.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <AL/efx.h>
#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double kBlockSeconds = 0.4; // four of them bridge a picture that takes a second
constexpr float kLoudest = 8;         // OpenAL limits a source's gain to 1, so the listener has the rest
constexpr float kHead = 0.3f;         // m: what is nearer comes from all around

// Filters of the EFX extension; where there is none only levels tell what stands in the way.
struct Filters {
    LPALGENFILTERS make = nullptr;
    LPALDELETEFILTERS remove = nullptr;
    LPALFILTERI setKind = nullptr;
    LPALFILTERF set = nullptr;
};
const Filters& filters()
{
    static const Filters found = [] {
        Filters f;
        if (!alcIsExtensionPresent(alcGetContextsDevice(alcGetCurrentContext()), "ALC_EXT_EFX")) return f;
        f.make = LPALGENFILTERS(alGetProcAddress("alGenFilters"));
        f.remove = LPALDELETEFILTERS(alGetProcAddress("alDeleteFilters"));
        f.setKind = LPALFILTERI(alGetProcAddress("alFilteri"));
        f.set = LPALFILTERF(alGetProcAddress("alFilterf"));
        return f.make && f.remove && f.setKind && f.set ? f : Filters{};
    }();
    return found;
}

ALenum formatOf(int channels)
{
    return channels == 1 ? AL_FORMAT_MONO16 : AL_FORMAT_STEREO16;
}

} // namespace

ClipBuffer::ClipBuffer(const SoundClip& clip) : m_seconds{clip.seconds()}, m_bytes{clip.samples.size() * 2}
{
    alGenBuffers(1, &m_id);
    alBufferData(m_id, formatOf(clip.channels), clip.samples.data(), ALsizei(m_bytes), clip.rate);
}

ClipBuffer::~ClipBuffer()
{
    alDeleteBuffers(1, &m_id);
}

Voice::Voice()
{
    alGetError();
    alGenSources(1, &m_source);
    if (alGetError() != AL_NO_ERROR) {
        m_source = 0;
        return;
    }
    alListenerf(AL_GAIN, kLoudest);
    alSourcei(m_source, AL_SOURCE_RELATIVE, AL_TRUE);
    alSourcef(m_source, AL_SOURCE_RADIUS, kHead);
    alGetError(); // a radius is an extension
    if (filters().make) {
        filters().make(1, &m_filter);
        filters().setKind(m_filter, AL_FILTER_TYPE, AL_FILTER_LOWPASS);
    }
}

Voice::~Voice()
{
    if (!m_source) return;
    stop();
    alDeleteSources(1, &m_source);
    if (m_filter) filters().remove(1, &m_filter);
    if (m_blocks[0]) alDeleteBuffers(kBlocks, m_blocks.data());
}

void Voice::goQuiet()
{
    stop();
    setGain(0);
    setPitch(1);
    setTreble(1);
    m_paused = false;
}

void Voice::play(std::shared_ptr<const ClipBuffer> clip, bool loop, double from)
{
    goQuiet();
    m_clip = std::move(clip);
    alSourcei(m_source, AL_BUFFER, ALint(m_clip->id()));
    alSourcei(m_source, AL_LOOPING, loop);
    alSourcef(m_source, AL_SEC_OFFSET, float(std::fmod(from, m_clip->seconds())));
    alSourcePlay(m_source);
}

void Voice::play(SoundFile file, int channels, bool loop, double from)
{
    goQuiet();
    if (!m_blocks[0]) alGenBuffers(kBlocks, m_blocks.data());
    const double whole = file.format().seconds();
    if (from > 0 && !file.seek(std::int64_t(std::fmod(from, whole) * file.format().rate))) file.seek(0);
    m_stream.emplace(std::move(file), channels, loop);
    alSourcei(m_source, AL_LOOPING, AL_FALSE); // blocks follow one another; the file is what repeats
    for (const unsigned block : m_blocks) {
        if (!fill(block)) break;
        alSourceQueueBuffers(m_source, 1, &block);
    }
    alSourcePlay(m_source);
}

void Voice::stop()
{
    alSourceStop(m_source);
    alSourcei(m_source, AL_BUFFER, 0);
    m_clip.reset();
    m_stream.reset();
}

void Voice::pause(bool on)
{
    if (on == m_paused) return;
    m_paused = on;
    if (on)
        alSourcePause(m_source);
    else
        alSourcePlay(m_source);
}

// The next block of the file, from its beginning again where it repeats: no sample lies between its end and its start.
bool Voice::fill(unsigned buffer)
{
    if (m_stream->ended) return false;
    const SoundFormat& format = m_stream->file.format();
    const auto channels = std::size_t(m_stream->channels);
    std::vector<std::int16_t> block(std::size_t(kBlockSeconds * format.rate) * channels);
    std::size_t done = 0;
    bool again = false; // it began anew, and nothing came since: an empty file must not hold us here
    while (done < block.size()) {
        const std::size_t came = m_stream->file.read(std::span{block}.subspan(done), m_stream->channels) * channels;
        done += came;
        if (done == block.size()) break;
        if (!m_stream->loop || (again && came == 0) || !m_stream->file.seek(0)) {
            m_stream->ended = true;
            break;
        }
        again = true;
    }
    if (done == 0) return false;
    alBufferData(buffer, formatOf(m_stream->channels), block.data(), ALsizei(done * sizeof block[0]), format.rate);
    return true;
}

bool Voice::goOn()
{
    if (m_paused) return true;
    ALint played = 0;
    if (m_stream) {
        alGetSourcei(m_source, AL_BUFFERS_PROCESSED, &played);
        for (; played > 0; --played) {
            unsigned block = 0;
            alSourceUnqueueBuffers(m_source, 1, &block);
            if (fill(block)) alSourceQueueBuffers(m_source, 1, &block);
        }
    }
    ALint state = AL_STOPPED;
    alGetSourcei(m_source, AL_SOURCE_STATE, &state);
    if (state != AL_STOPPED) return true;
    ALint waiting = 0;
    if (m_stream) alGetSourcei(m_source, AL_BUFFERS_QUEUED, &waiting);
    if (waiting == 0) return false;
    alSourcePlay(m_source); // it ran dry because nobody asked for long
    return true;
}

void Voice::setGain(float gain)
{
    alSourcef(m_source, AL_GAIN, std::clamp(gain / kLoudest, 0.0f, 1.0f));
}

void Voice::setTreble(float share)
{
    if (!m_filter || share == m_treble) return;
    m_treble = share;
    filters().set(m_filter, AL_LOWPASS_GAINHF, std::clamp(share, 0.0f, 1.0f));
    alSourcei(m_source, AL_DIRECT_FILTER, share < 1 ? ALint(m_filter) : AL_FILTER_NULL);
}

void Voice::setPitch(float factor)
{
    alSourcef(m_source, AL_PITCH, std::clamp(factor, 0.25f, 4.0f));
}

void Voice::place(const std::optional<glm::vec3>& fromEar)
{
    const glm::vec3 at = fromEar.value_or(glm::vec3{0});
    alSource3f(m_source, AL_POSITION, at.x, at.y, at.z);
    alSourcei(m_source, AL_DIRECT_CHANNELS_SOFT, !fromEar);
}

} // namespace app
