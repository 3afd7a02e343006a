#include "app/report.h"

#include "io/base/log.h"
#include "io/files/atomic_file.h"
#include "io/files/json.h"

#include <cstdio>
#include <unistd.h>

namespace app {
namespace {

void toStderr(std::string_view text)
{
    std::fflush(stdout); // so that a fault stands last where both go to one place
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

std::string oneLine(std::string text)
{
    for (char& c : text)
        if (c == '\n' || c == '\r') c = ' ';
    return text;
}

struct Bar {
    std::string step;
    int percent = -1;

    void show(float fraction, std::string_view name)
    {
        const int now = int(fraction * 100);
        if (now == percent && name == step) return;
        percent = now;
        step = name;
        const int filled = now * 30 / 100;
        toStderr(fmt::format("\r\033[K[{:<30}] {:3}% {}{}", std::string(std::size_t(filled), '#'), now, name,
                             fraction >= 1 ? "\r\033[K" : ""));
    }
};

} // namespace

int fault(const io::Error& error)
{
    toStderr(oneLine("wold: " + error.text()) + "\n");
    return 1;
}

int misuse(std::string_view what)
{
    toStderr(fmt::format("Usage: wold --help lists the commands, wold COMMAND --help their options\nwold: {}\n",
                         oneLine(std::string{what})));
    return 2;
}

io::Progress progressOnStderr(bool quiet)
{
    if (quiet) return {};
    if (isatty(STDERR_FILENO))
        return [bar = Bar{}](float fraction, std::string_view step) mutable {
            bar.show(fraction, step);
            return true;
        };
    return [last = std::string{}](float, std::string_view step) mutable {
        if (step != last) toStderr(fmt::format("wold: {}\n", step));
        last = step;
        return true;
    };
}

void logComplaints(const io::Complaints& complaints)
{
    for (const io::Complaint& complaint : complaints) {
        const io::log::Level level = complaint.severity == io::Severity::Note      ? io::log::Level::Info
                                     : complaint.severity == io::Severity::Warning ? io::log::Level::Warning
                                                                                   : io::log::Level::Error;
        io::log::write(level, fmt::format("{}: {}", complaint.where, complaint.what));
    }
}

io::Status writeFigures(const std::string& json, const io::Value& figures)
{
    if (json.empty()) return {};
    const std::string text = io::writeJson(figures, 2) + "\n";
    if (json != "-") return io::writeFile(json, text);
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        return io::Error{"stdout", "cannot be written"};
    return {};
}

} // namespace app
