// wold bench: draws along a camera path and reports what it cost.
#include "app/commands/commands.h"
#include "app/drawing_settings.h"
#include "app/opened.h"
#include "app/report.h"
#include "app/studio.h"
#include "renderer/device.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <map>
#include <sys/resource.h>

namespace app {
namespace {

constexpr int kFrames = 120;

double now() // ms
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
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

struct Measured {
    std::vector<double> frames; // ms
    std::vector<std::string> passNames;
    std::map<std::string, std::vector<double>> cpu, gpu; // by pass, ms
    std::map<std::string, std::vector<double>> counts;
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
    count("gpu_mb", stats.gpuBytes >> 20);
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

double drawFrame(renderer::Renderer& renderer, const io::Camera& camera, const renderer::Settings& drawing,
                 glm::ivec2 size, double time)
{
    const double start = now();
    renderer.render({.camera = camera, .size = size, .settings = drawing, .time = time});
    renderer::waitForDevice();
    return now() - start;
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
        measured.frames.push_back(drawFrame(renderer, flight.at(i, frames), drawing, options.size, i / 60.0));
        keep(measured, renderer.stats());
        io::report(progress, float(i + 1) / float(frames), "measure");
    }
    return measured;
}

io::Value figuresOf(const Measured& measured)
{
    io::Value figures = io::Value::Object{{"median_ms", percentile(measured.frames, 0.5)},
                                          {"p95_ms", percentile(measured.frames, 0.95)},
                                          {"p99_ms", percentile(measured.frames, 0.99)}};
    for (const auto& [name, values] : measured.counts)
        figures[name] = percentile(values, 0.5);
    figures["grass_blades"] = 0; // grass comes with a later release
    io::Value::Array passes;
    for (const std::string& name : measured.passNames)
        passes.push_back(io::Value::Object{{"name", name},
                                           {"cpu_ms", percentile(measured.cpu.at(name), 0.5)},
                                           {"gpu_ms", percentile(measured.gpu.at(name), 0.5)}});
    figures["passes"] = std::move(passes);
    figures["frames_ms"] = io::Value::Array{measured.frames.begin(), measured.frames.end()};
    return figures;
}

void print(const io::Value& figures)
{
    for (const auto& [name, value] : *figures.asObject())
        if (value.asNumber())
            fmt::print("{:22}{:.6g}\n", name, *value.asNumber());
        else if (value.asString())
            fmt::print("{:22}{}\n", name, *value.asString());
    for (const io::Value& pass : *figures.find("passes")->asArray())
        fmt::print("pass {:17}cpu {:.3f} ms, gpu {:.3f} ms\n", *pass.find("name")->asString(),
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
    if (options.quality) applyQuality(*options.quality, renderer.deviceName(), drawing);
    if (const int code = applyToDrawing(options, drawing)) return code;

    const double start = now(); // the first frame takes the world onto the device
    (*studio)->follow(*document);
    drawFrame(renderer, flight->at(0, 1), drawing, options.size, 0);
    const double firstFrame = now() - start;
    io::Value figures = figuresOf(measure(renderer, *flight, drawing, options));
    figures["load_ms"] = milliseconds;
    figures["first_frame_ms"] = firstFrame;
    figures["peak_rss_mb"] = peakMegabytes();
    figures["gl_renderer"] = renderer.deviceName();
    figures["size"] = io::Value::Array{options.size.x, options.size.y};
    if (options.json != "-") print(figures);
    const io::Status written = writeFigures(options.json, figures);
    return written ? 0 : fault(written.error());
}

} // namespace app
