// The log: one line a message to stderr, and the last few thousand kept for the console panel.
#pragma once

#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <vector>

namespace io::log {

enum class Level { Debug, Info, Warning, Error, Off };

struct Line {
    std::uint64_t number = 0; // counts up from 1 over the life of the process
    Level level = Level::Info;
    double seconds = 0; // since the start of the process
    std::string text;
};

void setLevel(Level level); // of stderr; the kept lines hold everything from Debug up
bool setLevel(std::string_view name); // debug info warning error off; false when unknown
void write(Level level, std::string text);
std::vector<Line> linesAfter(std::uint64_t number); // oldest first
void clear();

template <class... Args>
void debug(fmt::format_string<Args...> format, Args&&... args)
{
    write(Level::Debug, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void info(fmt::format_string<Args...> format, Args&&... args)
{
    write(Level::Info, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void warning(fmt::format_string<Args...> format, Args&&... args)
{
    write(Level::Warning, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void error(fmt::format_string<Args...> format, Args&&... args)
{
    write(Level::Error, fmt::format(format, std::forward<Args>(args)...));
}

} // namespace io::log
