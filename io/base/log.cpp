#include "io/base/log.h"

#include "io/base/contract.h"

#include <chrono>
#include <cstdlib>
#include <deque>
#include <mutex>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace io {

void contractBroken(const char* condition, const char* file, int line)
{
    log::error("{}:{}: broken contract: {} (a bug in Wold; please report it)", file, line, condition);
    std::abort();
}

namespace log {
namespace {

constexpr std::size_t kKept = 4000;

struct State {
    std::mutex mutex;
    std::deque<Line> lines;
    std::uint64_t count = 0;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    std::shared_ptr<spdlog::logger> stderrLog = spdlog::stderr_color_mt("wold");

    State()
    {
        stderrLog->set_pattern("wold: %^%l%$: %v");
        stderrLog->set_level(spdlog::level::warn);
    }
};

State& state()
{
    static State s;
    return s;
}

spdlog::level::level_enum toSpdlog(Level level)
{
    switch (level) {
    case Level::Debug: return spdlog::level::debug;
    case Level::Info: return spdlog::level::info;
    case Level::Warning: return spdlog::level::warn;
    case Level::Error: return spdlog::level::err;
    case Level::Off: break;
    }
    return spdlog::level::off;
}

} // namespace

void setLevel(Level level)
{
    state().stderrLog->set_level(toSpdlog(level));
}

bool setLevel(std::string_view name)
{
    constexpr std::string_view kNames[] = {"debug", "info", "warning", "error", "off"};
    for (int i = 0; i < int(std::size(kNames)); ++i)
        if (name == kNames[i]) return setLevel(Level(i)), true;
    return false;
}

void write(Level level, std::string text)
{
    State& s = state();
    s.stderrLog->log(toSpdlog(level), "{}", text);
    const std::lock_guard lock{s.mutex};
    const std::chrono::duration<double> age = std::chrono::steady_clock::now() - s.start;
    s.lines.push_back({.number = ++s.count, .level = level, .seconds = age.count(), .text = std::move(text)});
    if (s.lines.size() > kKept) s.lines.pop_front();
}

std::vector<Line> linesAfter(std::uint64_t number)
{
    State& s = state();
    const std::lock_guard lock{s.mutex};
    std::vector<Line> result;
    for (const Line& line : s.lines)
        if (line.number > number) result.push_back(line);
    return result;
}

void clear()
{
    State& s = state();
    const std::lock_guard lock{s.mutex};
    s.lines.clear();
}

} // namespace log
} // namespace io
