// FrameHistory: the times of the last frames, and of each pass in them.
#pragma once

#include "renderer/renderer.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace editor {

class FrameHistory {
public:
    struct Frame {
        double ms = 0; // from frame to frame
        std::vector<renderer::PassTime> passes;
    };
    static constexpr std::size_t kFrames = 120;

    void note(double seconds, std::span<const renderer::PassTime> passes);
    std::size_t size() const { return m_count < kFrames ? m_count : kFrames; }
    const Frame& at(std::size_t i) const; // the oldest is 0
    double meanMs() const;                // 0 without any
    std::vector<renderer::PassTime> means() const; // of each pass over the frames that had it, in the order of drawing

private:
    std::array<Frame, kFrames> m_frames;
    std::size_t m_count = 0; // so far
};

} // namespace editor
