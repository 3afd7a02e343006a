#include "editor/frame_history.h"

#include <algorithm>

namespace editor {

void FrameHistory::note(double seconds, std::span<const renderer::PassTime> passes)
{
    Frame& frame = m_frames[m_count++ % kFrames];
    frame.ms = seconds * 1000;
    frame.passes.assign(passes.begin(), passes.end());
}

const FrameHistory::Frame& FrameHistory::at(std::size_t i) const
{
    return m_frames[(m_count - size() + i) % kFrames];
}

double FrameHistory::meanMs() const
{
    double sum = 0;
    for (std::size_t i = 0; i < size(); ++i)
        sum += at(i).ms;
    return size() ? sum / double(size()) : 0;
}

std::vector<renderer::PassTime> FrameHistory::means() const
{
    std::vector<renderer::PassTime> sums;
    std::vector<int> counts;
    for (std::size_t i = size(); i-- > 0;) { // the newest tells the order
        for (const renderer::PassTime& pass : at(i).passes) {
            const auto known = std::ranges::find(sums, pass.name, &renderer::PassTime::name);
            const auto index = std::size_t(known - sums.begin());
            if (known == sums.end()) sums.push_back({.name = pass.name}), counts.push_back(0);
            sums[index].cpuMs += pass.cpuMs;
            sums[index].gpuMs += pass.gpuMs;
            ++counts[index];
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i].cpuMs /= counts[i];
        sums[i].gpuMs /= counts[i];
    }
    return sums;
}

} // namespace editor
