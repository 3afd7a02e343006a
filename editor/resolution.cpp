#include "editor/resolution.h"

#include <algorithm>
#include <iterator>

namespace editor {
namespace {

constexpr double kScales[] = {1, 0.7, 0.5, 0.35}; // half of the pixels with each step
constexpr double kTooSlow = 1.1, kQuick = 0.62;   // of a frame's time
constexpr double kOfScreen = 1 / 56.0;            // s; a screen of 60 Hz shows none quicker
constexpr int kSlowInARow = 2;                    // one may be a hitch
constexpr int kTooSoon = 30;                      // frames after which drawing finer has proved right
constexpr int kMostPatience = 256;

} // namespace

double Resolution::scale() const
{
    return kScales[m_step];
}

void Resolution::note(double seconds, double framesPerSecond)
{
    const double wanted = 1 / framesPerSecond;
    const bool slow = seconds > wanted * kTooSlow;
    m_slow = slow ? m_slow + 1 : 0;
    m_quick = seconds < std::max(wanted * kQuick, kOfScreen) && !slow ? m_quick + 1 : 0;
    ++m_sinceFiner;
    if (m_slow >= kSlowInARow && m_step + 1 < int(std::size(kScales))) {
        if (m_sinceFiner < kTooSoon) m_patience = std::min(4 * m_patience, kMostPatience); // no to and fro
        ++m_step;
        m_slow = 0;
    } else if (m_quick >= m_patience && m_step > 0) {
        --m_step;
        m_quick = m_sinceFiner = 0;
    }
}

} // namespace editor
