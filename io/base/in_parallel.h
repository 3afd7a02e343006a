// A loop cut into parts, one for each processor.
#pragma once

#include <algorithm>
#include <cstdint>
#include <future>
#include <thread>
#include <vector>

namespace io {

// part(from, to) for parts that make up [0, count), of at least `fewest` each; the first on the calling thread. Returns when all
// are done, and throws what one of them threw.
template <class Part> void inParallel(int count, int fewest, Part&& part)
{
    const int parts = std::clamp(count / fewest, 1, std::max(1, int(std::thread::hardware_concurrency())));
    const auto start = [count, parts](int i) { return int(std::int64_t(count) * i / parts); };
    std::vector<std::future<void>> others;
    for (int i = 1; i < parts; ++i)
        others.push_back(std::async(std::launch::async, [&part, from = start(i), to = start(i + 1)] { part(from, to); }));
    part(0, start(1));
    for (std::future<void>& other : others)
        other.get();
}

} // namespace io
