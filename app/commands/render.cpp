// wold render: one picture, or a numbered sequence along a camera path.
#include "app/commands/commands.h"
#include "app/drawing_settings.h"
#include "app/opened.h"
#include "app/report.h"
#include "app/studio.h"
#include "io/files/image_file.h"

#include <chrono>
#include <fmt/format.h>

namespace app {
namespace {

constexpr double kFramesPerSecond = 60; // of a camera path

struct Shot {
    io::Camera camera;
    double time = 0; // s
    std::filesystem::path file;
};

bool isRadiance(const std::filesystem::path& file)
{
    return file.extension() == ".exr";
}

bool isKnown(const std::filesystem::path& file)
{
    const std::filesystem::path extension = file.extension();
    return extension == ".png" || extension == ".jpg" || extension == ".jpeg" || extension == ".exr";
}

std::filesystem::path numbered(const std::filesystem::path& file, int number)
{
    return file.parent_path() / fmt::format("{}{:04}{}", file.stem().string(), number, file.extension().string());
}

io::Result<std::vector<Shot>> shotsOf(const Options& options, const editor::Document& document)
{
    std::vector<Shot> shots;
    if (!options.range && options.count == 0) {
        auto camera = cameraFor(options, document);
        if (!camera) return camera.error();
        shots.push_back({*camera, 0, options.out});
        return shots;
    }
    const auto path = pathFor(options, document);
    if (!path) return path.error();
    const FrameRange range = options.range.value_or(FrameRange{0, options.count - 1});
    const double step = options.range ? 1 / kFramesPerSecond : io::duration(*path) / std::max(options.count - 1, 1);
    for (int frame = range.first; frame <= range.last; ++frame)
        shots.push_back({io::sample(*path, frame * step), frame * step, numbered(options.out, frame)});
    return shots;
}

renderer::FrameInput frameOf(const Options& options, const renderer::Settings& drawing, const io::Camera& camera, double time)
{
    return {.camera = camera,
            .size = options.size,
            .settings = drawing,
            .show = options.show,
            .time = time,
            .markers = options.show != renderer::Show::Final, // aids to editing, no part of the world
            .ids = false,
            .alone = true, // of a sequence too: others may draw the pictures before it
            .freezeCulling = options.cullFrom.has_value()};
}

io::Status draw(renderer::Renderer& renderer, const Shot& shot, const renderer::Settings& drawing,
                const Options& options)
{
    renderer.render(frameOf(options, drawing, shot.camera, shot.time));
    return io::writeImage(shot.file, isRadiance(shot.file) ? renderer.readRadiance() : renderer.readPicture());
}

io::Value figuresOf(const renderer::Renderer& renderer, const Options& options, std::size_t pictures, double seconds)
{
    const renderer::FrameStats& stats = renderer.stats();
    return io::Value::Object{{"pictures", std::uint64_t(pictures)},
                             {"width", options.size.x},
                             {"height", options.size.y},
                             {"seconds", seconds},
                             {"draw_calls", stats.drawCalls},
                             {"triangles_drawn", stats.trianglesDrawn},
                             {"instances_drawn", stats.instancesDrawn},
                             {"gl_renderer", renderer.deviceName()}};
}

} // namespace

int render(const Options& options)
{
    if (!isKnown(options.out))
        return misuse(fmt::format("--out {}: end it in .png, .jpg or .exr", options.out.string()));
    if (isRadiance(options.out) && options.show != renderer::Show::Final)
        return misuse("--show goes into .png or .jpg; .exr holds the radiance of the final picture");
    auto opened = openAsAsked(options);
    if (const int* code = std::get_if<int>(&opened)) return *code;
    auto& [document, drawing, milliseconds] = std::get<Opened>(opened);
    const auto shots = shotsOf(options, *document);
    if (!shots) return fault(shots.error());
    auto studio = Studio::create(options.headless);
    if (!studio) return fault(studio.error());
    renderer::Renderer& renderer = (*studio)->renderer();
    if (options.quality) applyQuality(*options.quality, renderer.deviceName(), drawing);
    if (const int code = applyToDrawing(options, drawing)) return code;
    (*studio)->follow(*document);

    if (options.cullFrom) renderer.render(frameOf(options, drawing, *options.cullFrom, 0)); // and stays culled so
    const auto start = std::chrono::steady_clock::now();
    const io::Progress progress = progressOnStderr(options.quiet);
    for (std::size_t i = 0; i < shots->size(); ++i) {
        const io::Status drawn = draw(renderer, (*shots)[i], drawing, options);
        if (!drawn) return fault(drawn.error());
        io::report(progress, float(i + 1) / float(shots->size()), "draw");
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const io::Status written = writeFigures(options.json, figuresOf(renderer, options, shots->size(), seconds.count()));
    return written ? 0 : fault(written.error());
}

} // namespace app
