// wold bench: draws along a camera path and reports what it cost.
#include "app/commands/commands.h"
#include "app/drawing_settings.h"
#include "app/opened.h"
#include "app/report.h"
#include "app/studio.h"
#include "editor/memory.h"
#include "renderer/device.h"

#include <algorithm>
#include <ctime>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace app {
namespace {

constexpr int kFrames = 120;

double clockMs(clockid_t clock)
{
    timespec time{};
    clock_gettime(clock, &time);
    return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
}

double now() // ms
{
    return clockMs(CLOCK_MONOTONIC);
}

// Since the system started this process, which is before main(); to a hundredth of a second.
double sinceProcessStart() // ms
{
    std::string stat;
    std::getline(std::ifstream{"/proc/self/stat"}, stat);
    std::size_t at = stat.rfind(')'); // the name before it may hold spaces; the start is the 20th field after it
    for (int field = 0; field < 20 && at != stat.npos; ++field)
        at = stat.find(' ', at + 1);
    if (at == stat.npos) return 0;
    return clockMs(CLOCK_BOOTTIME) - std::strtod(stat.c_str() + at, nullptr) * 1e3 / double(sysconf(_SC_CLK_TCK));
}

double percentile(std::vector<double> values, double share)
{
    if (values.empty()) return 0;
    std::ranges::sort(values);
    return values[std::min(values.size() - 1, std::size_t(share * double(values.size())))];
}

double peakMegabytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) / 1024;
}

struct FrameCost { // ms
    double wall = 0;
    double processor = 0; // of all threads: counts little of what else the machine does
    double submit = 0;    // of the processor, in the calling thread, before it waits for the device
};

struct Measured {
    std::vector<double> frames, processor, submit; // ms
    std::vector<std::string> passNames;
    std::map<std::string, std::vector<double>> cpu, gpu; // by pass, ms
    std::map<std::string, std::vector<double>> counts;
    std::vector<std::vector<double>> levels; // triangles of the camera's view, by level of detail
};

void keep(Measured& measured, const renderer::FrameStats& stats)
{
    for (const renderer::PassTime& pass : stats.passes) {
        if (!measured.cpu.contains(pass.name)) measured.passNames.push_back(pass.name);
        measured.cpu[pass.name].push_back(pass.cpuMs);
        measured.gpu[pass.name].push_back(pass.gpuMs);
    }
    const auto count = [&](const char* name, std::uint64_t value) { measured.counts[name].push_back(double(value)); };
    count("draw_calls", stats.drawCalls);
    count("triangles_submitted", stats.trianglesSubmitted);
    count("triangles_drawn", stats.trianglesDrawn);
    count("instances", stats.instances);
    count("instances_drawn", stats.instancesDrawn);
    count("instances_inside", stats.instancesInside);
    count("instances_large", stats.instancesLarge);
    count("instances_hidden", stats.instancesHidden);
    count("grass_blades", stats.grassDrawn);
    count("grass_left_out", stats.grassLeftOut);
    count("uploaded_bytes", stats.uploadedBytes);
    count("gpu_mb", stats.gpuBytes >> 20);
    measured.levels.resize(stats.trianglesOfLevel.size());
    for (std::size_t level = 0; level < measured.levels.size(); ++level)
        measured.levels[level].push_back(double(stats.trianglesOfLevel[level]));
}

void keep(Measured& measured, const FrameCost& cost)
{
    measured.frames.push_back(cost.wall);
    measured.processor.push_back(cost.processor);
    measured.submit.push_back(cost.submit);
}

// The places of the path that frames are drawn from: spread evenly over all of it.
struct Flight {
    io::CameraPath path; // without keys: stands still
    io::Camera still;

    io::Camera at(int frame, int frames) const
    {
        if (path.keys.empty()) return still;
        return io::sample(path, io::duration(path) * frame / std::max(frames - 1, 1));
    }
};

io::Result<Flight> flightOf(const Options& options, const editor::Document& document)
{
    Flight flight;
    if (options.path.empty() && (options.view || !options.camera.empty() || document.scene().paths().empty())) {
        auto camera = cameraFor(options, document);
        if (!camera) return camera.error();
        flight.still = *camera;
        return flight;
    }
    auto path = pathFor(options, document);
    if (!path) return path.error();
    flight.path = *std::move(path);
    return flight;
}

FrameCost drawFrame(renderer::Renderer& renderer, const io::Camera& camera, const renderer::Settings& drawing,
                    glm::ivec2 size, double time)
{
    const FrameCost start{now(), clockMs(CLOCK_PROCESS_CPUTIME_ID), clockMs(CLOCK_THREAD_CPUTIME_ID)};
    renderer.render({.camera = camera, .size = size, .settings = drawing, .time = time, .ids = false});
    const double submitted = clockMs(CLOCK_THREAD_CPUTIME_ID);
    renderer::waitForDevice();
    return {now() - start.wall, clockMs(CLOCK_PROCESS_CPUTIME_ID) - start.processor, submitted - start.submit};
}

Measured measure(renderer::Renderer& renderer, const Flight& flight, const renderer::Settings& drawing,
                 const Options& options)
{
    const int frames = options.frames > 0 ? options.frames : kFrames;
    const io::Progress progress = progressOnStderr(options.quiet);
    Measured measured;
    for (int i = 0; i < options.warmup; ++i)
        drawFrame(renderer, flight.at(i % frames, frames), drawing, options.size, i / 60.0);
    for (int i = 0; i < frames; ++i) {
        keep(measured, drawFrame(renderer, flight.at(i, frames), drawing, options.size, i / 60.0));
        keep(measured, renderer.stats());
        io::report(progress, float(i + 1) / float(frames), "measure");
    }
    return measured;
}

io::Value figuresOf(const Measured& measured)
{
    io::Value figures = io::Value::Object{{"median_ms", percentile(measured.frames, 0.5)},
                                          {"p95_ms", percentile(measured.frames, 0.95)},
                                          {"p99_ms", percentile(measured.frames, 0.99)},
                                          {"processor_ms", percentile(measured.processor, 0.5)},
                                          {"submit_ms", percentile(measured.submit, 0.5)}};
    for (const auto& [name, values] : measured.counts)
        figures[name] = percentile(values, 0.5);
    io::Value::Array levels, passes;
    for (const std::vector<double>& level : measured.levels)
        levels.emplace_back(percentile(level, 0.5));
    figures["triangles_of_level"] = std::move(levels);
    for (const std::string& name : measured.passNames)
        passes.push_back(io::Value::Object{{"name", name},
                                           {"cpu_ms", percentile(measured.cpu.at(name), 0.5)},
                                           {"gpu_ms", percentile(measured.gpu.at(name), 0.5)}});
    figures["passes"] = std::move(passes);
    figures["frames_ms"] = io::Value::Array{measured.frames.begin(), measured.frames.end()};
    return figures;
}

io::Value memoryOf(const editor::Document& document, const renderer::FrameStats& stats)
{
    const editor::WorldMemory world = editor::memoryOf(document);
    const auto megabytes = [](std::uint64_t bytes) { return double(bytes) / 1e6; };
    return io::Value::Object{{"objects", megabytes(world.objects)},
                             {"geometry", megabytes(world.geometry)},
                             {"pictures", megabytes(world.pictures)},
                             {"heights", megabytes(world.heights)},
                             {"gpu", megabytes(stats.gpuBytes)},
                             {"gpu_textures", megabytes(stats.gpuMemory.textures)},
                             {"gpu_buffers", megabytes(stats.gpuMemory.buffers)},
                             {"gpu_shadow_maps", megabytes(stats.gpuMemory.shadowMaps)},
                             {"gpu_targets", megabytes(stats.gpuMemory.targets)}};
}

void print(const io::Value& figures)
{
    for (const auto& [name, value] : *figures.asObject())
        if (value.asNumber())
            fmt::print("{:26}{:.6g}\n", name, *value.asNumber());
        else if (value.asString())
            fmt::print("{:26}{}\n", name, *value.asString());
    for (const auto& [kind, megabytes] : *figures.find("memory_mb")->asObject())
        fmt::print("memory {:19}{:.1f} MB\n", kind, *megabytes.asNumber());
    for (const io::Value& pass : *figures.find("passes")->asArray())
        fmt::print("pass {:21}cpu {:.3f} ms, gpu {:.3f} ms\n", *pass.find("name")->asString(),
                   *pass.find("cpu_ms")->asNumber(), *pass.find("gpu_ms")->asNumber());
}

} // namespace

int bench(const Options& options)
{
    auto opened = openAsAsked(options);
    if (const int* code = std::get_if<int>(&opened)) return *code;
    auto& [document, drawing, milliseconds] = std::get<Opened>(opened);
    const auto flight = flightOf(options, *document);
    if (!flight) return fault(flight.error());
    auto studio = Studio::create(options.headless);
    if (!studio) return fault(studio.error());
    renderer::Renderer& renderer = (*studio)->renderer();
    const Quality asked = options.quality.value_or(Quality::Auto); // as a window here would draw
    const Quality quality = applyQuality(asked, renderer.deviceName(), drawing);
    if (const int code = applyToDrawing(options, drawing)) return code;

    const double start = now(); // the first frame takes the world onto the device
    (*studio)->follow(*document);
    drawFrame(renderer, flight->at(0, 1), drawing, options.size, 0);
    const double firstFrame = now() - start, firstFrameAt = sinceProcessStart();
    const double firstFrameProcessor = clockMs(CLOCK_PROCESS_CPUTIME_ID);
    io::Value figures = figuresOf(measure(renderer, *flight, drawing, options));
    figures["load_ms"] = milliseconds;
    figures["first_frame_ms"] = firstFrame;
    figures["first_frame_at_ms"] = firstFrameAt;
    figures["first_frame_processor_ms"] = firstFrameProcessor;
    figures["peak_rss_mb"] = peakMegabytes();
    figures["memory_mb"] = memoryOf(*document, renderer.stats());
    figures["quality"] = std::string{nameOf(quality)};
    figures["gl_renderer"] = renderer.deviceName();
    figures["size"] = io::Value::Array{options.size.x, options.size.y};
    if (options.json != "-") print(figures);
    const io::Status written = writeFigures(options.json, figures);
    return written ? 0 : fault(written.error());
}

} // namespace app
