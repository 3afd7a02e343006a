// wold check: reads all that a project names and lists every fault.
#include "app/commands/commands.h"
#include "app/play_check.h"
#include "app/report.h"
#include "app/sound/sound_check.h"
#include "io/files/project.h"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>

namespace app {
namespace {

constexpr const char* kSeverities[] = {"note", "warning", "error"};

// What opening a world mends (ids, ranges, cycles) is written back; files that cannot be read stay as they are.
io::Status mend(const std::filesystem::path& project)
{
    io::Complaints complaints;
    const auto start = io::openWorld(project, {}, complaints);
    if (!start) return start.error();
    for (const io::SceneEntry& entry : start->project.scenes) {
        auto world = io::openWorld(project, entry.name, complaints);
        if (!world) return world.error();
        const auto saved = io::saveWorld(*world);
        if (!saved) return saved.error();
        for (const std::filesystem::path& file : saved->written)
            fmt::print("{}: mended\n", file.string());
    }
    return {};
}

// What all files of the project hold is said by their readers; what sounds in them, by who can hear; what is played, by who plays.
io::Complaints faultsOf(const std::filesystem::path& project)
{
    io::Complaints complaints = io::checkProject(project);
    io::Complaints said; // by then already
    const auto start = io::openWorld(project, {}, said);
    if (!start) return complaints;
    io::Complaints more;
    for (const io::SceneEntry& entry : start->project.scenes)
        if (auto world = io::openWorld(project, entry.name, said)) {
            checkSounds(world->scene, world->project.folder, world->entry.file, more);
            std::ranges::move(checkPlay(*world, io::KeptLooks{io::looksFolder()}), std::back_inserter(more));
        }
    for (io::Complaint& complaint : more) { // scenes share their templates
        const auto same = [&](const io::Complaint& other) { return other.where == complaint.where && other.what == complaint.what; };
        if (std::ranges::none_of(complaints, same)) complaints.push_back(std::move(complaint));
    }
    return complaints;
}

io::Value figuresOf(const io::Complaints& complaints)
{
    io::Value::Array list;
    std::uint64_t counts[3] = {};
    for (const io::Complaint& complaint : complaints) {
        ++counts[std::size_t(complaint.severity)];
        list.push_back(io::Value::Object{{"where", complaint.where},
                                         {"severity", kSeverities[std::size_t(complaint.severity)]},
                                         {"what", complaint.what}});
    }
    return io::Value::Object{
        {"errors", counts[2]}, {"warnings", counts[1]}, {"notes", counts[0]}, {"faults", std::move(list)}};
}

} // namespace

int check(const Options& options)
{
    if (options.fix)
        if (const io::Status mended = mend(options.project); !mended) return fault(mended.error());
    const io::Complaints complaints = faultsOf(options.project);
    for (const io::Complaint& complaint : complaints)
        if (options.json != "-")
            fmt::print("{}: {}: {}\n", complaint.where, kSeverities[std::size_t(complaint.severity)], complaint.what);
    const io::Status written = writeFigures(options.json, figuresOf(complaints));
    if (!written) return fault(written.error());

    const auto isError = [](const io::Complaint& c) { return c.severity == io::Severity::Error; };
    const auto errors = std::ranges::count_if(complaints, isError);
    if (errors == 0) return 0;
    const io::Complaint& first = *std::ranges::find_if(complaints, isError);
    return fault(
        {first.where, errors == 1 ? first.what : fmt::format("{} (the first of {} errors)", first.what, errors)});
}

} // namespace app
