// What the driver says through KHR_debug: errors are counted, and all of it reaches the log.
#pragma once

#include <cstdint>

namespace renderer::gl {

class DebugOutput {
public:
    explicit DebugOutput(bool synchronous); // synchronous: the message comes inside the call that caused it
    ~DebugOutput();
    DebugOutput(const DebugOutput&) = delete;
    DebugOutput& operator=(const DebugOutput&) = delete;

    std::uint64_t errors() const { return m_errors; }

private:
    std::uint64_t m_errors = 0;
};

} // namespace renderer::gl
