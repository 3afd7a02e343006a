// A voice: one source of OpenAL, which plays a short sound from memory or a long one from its file.
#pragma once

#include "app/sound/sound_file.h"

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <optional>

namespace app {

// A short sound as OpenAL has it; voices share it.
class ClipBuffer {
public:
    explicit ClipBuffer(const SoundClip& clip);
    ~ClipBuffer();
    ClipBuffer(const ClipBuffer&) = delete;
    ClipBuffer& operator=(const ClipBuffer&) = delete;

    unsigned id() const { return m_id; }
    double seconds() const { return m_seconds; }
    std::size_t bytes() const { return m_bytes; }

private:
    unsigned m_id = 0;
    double m_seconds = 0;
    std::size_t m_bytes = 0;
};

class Voice {
public:
    Voice();
    ~Voice();
    Voice(const Voice&) = delete;
    Voice& operator=(const Voice&) = delete;

    bool works() const { return m_source != 0; } // a device may have no more of them

    // Each begins silent: setGain() and place() are to follow.
    void play(std::shared_ptr<const ClipBuffer> clip, bool loop, double from);
    void play(SoundFile file, int channels, bool loop, double from); // seconds into the sound
    void stop();
    void pause(bool on);

    bool goOn(); // hands on what a stream needs next; false at the end of the sound
    void setGain(float gain);
    void setTreble(float share); // of what is above 5 kHz, 0..1
    void setPitch(float factor);
    void place(const std::optional<glm::vec3>& fromEar); // m: right, up, backwards; none: without direction

private:
    static constexpr int kBlocks = 4;
    struct Stream {
        SoundFile file;
        int channels;
        bool loop;
        bool ended = false;
    };
    bool fill(unsigned buffer);
    void goQuiet();

    unsigned m_source = 0;
    unsigned m_filter = 0;
    float m_treble = 1;
    bool m_paused = false;
    std::shared_ptr<const ClipBuffer> m_clip;
    std::optional<Stream> m_stream;
    std::array<unsigned, kBlocks> m_blocks{}; // of the stream; made with the first
};

} // namespace app
