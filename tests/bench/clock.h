// Clocks and shares for the programs that measure. Times of the processor count little of what else the machine does.
#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace bench {

inline double milliseconds(clockid_t clock)
{
    timespec now{};
    clock_gettime(clock, &now);
    return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

inline double wallMs() { return milliseconds(CLOCK_MONOTONIC); }
inline double processMs() { return milliseconds(CLOCK_PROCESS_CPUTIME_ID); } // of all threads
inline double threadMs() { return milliseconds(CLOCK_THREAD_CPUTIME_ID); }

// The value that this part of them does not exceed; 0 of none.
inline double share(std::vector<double> values, double part)
{
    if (values.empty()) return 0;
    std::ranges::sort(values);
    return values[std::min(values.size() - 1, std::size_t(part * double(values.size())))];
}

} // namespace bench
