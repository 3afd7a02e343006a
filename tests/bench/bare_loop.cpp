// The loop that `wold bench` is compared with: the same world, path, frames and size, drawn as hand-written OpenGL
// would do it. usage: bare_loop PROJECT [--frames N] [--warmup N] [--size WxH] [--path NAME] [--png FILE]
// The figures go to stdout as JSON; --png keeps the picture of the frame in the middle of the path.
#include "app/headless.h"
#include "io/files/image_file.h"
#include "io/files/json.h"
#include "io/files/levels.h"
#include "io/files/model_file.h"
#include "io/files/project.h"
#include "renderer/device.h"
#include "tests/bench/bare_forest.h"
#include "tests/bench/clock.h"

#include <CLI/CLI.hpp>
#include <cstdio>

namespace {

struct Words {
    std::string project, size = "1280x720", path, png;
    int frames = 120, warmup = 3;
};

int fault(const io::Error& error)
{
    std::fprintf(stderr, "bare_loop: %s\n", error.text().c_str());
    return 1;
}

// As their files have them: what Wold makes of models (levels, trimmed cards) is what is compared with.
void useWholeModels(const io::World& world, io::Assets& assets, io::Complaints& complaints)
{
    const auto slots = world.scene.templates();
    for (std::size_t i = 0; i < slots.size(); ++i) {
        if (!slots[i].value || slots[i].value->model.empty()) continue;
        auto model = io::readModel(world.project.folder / slots[i].value->model, world.project.folder, complaints);
        if (!model) continue;
        io::makeLevels(*model); // for the order of its triangles
        assets.models[i] = std::make_shared<const io::Model>(std::move(*model));
    }
}

int run(const Words& words)
{
    glm::ivec2 size{1280, 720};
    if (std::sscanf(words.size.c_str(), "%dx%d", &size.x, &size.y) != 2) return fault({"--size", "write 1280x720"});
    io::Complaints complaints;
    auto world = io::openWorld(words.project, {}, complaints);
    if (!world) return fault(world.error());
    auto assets = io::readAssets(*world, complaints);
    if (!assets) return fault(assets.error());
    useWholeModels(*world, *assets, complaints);
    const auto paths = world->scene.paths();
    const io::CameraPath* path = words.path.empty() && !paths.empty() ? &paths[0] : world->scene.findPath(words.path);
    if (!path) return fault({words.project, "has no path of that name"});
    const auto context = app::makeHeadless();
    if (!context) return fault(context.error());

    bench::BareForest forest{world->scene, *assets, size};
    const auto at = [&](int frame) {
        return io::sample(*path, io::duration(*path) * frame / std::max(words.frames - 1, 1));
    };
    for (int i = 0; i < words.warmup; ++i) {
        forest.draw(at(i % words.frames));
        renderer::waitForDevice();
    }
    std::vector<double> wall, processor, drawCalls, triangles;
    for (int i = 0; i < words.frames; ++i) {
        const double wallStart = bench::wallMs(), processorStart = bench::processMs();
        const bench::BareCounts counts = forest.draw(at(i));
        renderer::waitForDevice();
        wall.push_back(bench::wallMs() - wallStart);
        processor.push_back(bench::processMs() - processorStart);
        drawCalls.push_back(double(counts.drawCalls));
        triangles.push_back(double(counts.triangles));
        if (words.png.empty() || i != words.frames / 2) continue;
        if (const auto written = io::writeImage(words.png, forest.readPicture()); !written) return fault(written.error());
    }
    const io::Value figures = io::Value::Object{{"median_ms", bench::share(wall, 0.5)},
                                                {"p95_ms", bench::share(wall, 0.95)},
                                                {"processor_ms", bench::share(processor, 0.5)},
                                                {"frames", words.frames},
                                                {"draw_calls", bench::share(drawCalls, 0.5)},
                                                {"triangles_drawn", bench::share(triangles, 0.5)},
                                                {"gl_renderer", renderer::describeDevice().name}};
    std::puts(io::writeJson(figures).c_str());
    return 0;
}

} // namespace

int main(int count, char** arguments)
{
    Words words;
    CLI::App line{"the bare loop that wold bench is compared with"};
    line.add_option("project", words.project)->required();
    line.add_option("--frames", words.frames)->check(CLI::PositiveNumber);
    line.add_option("--warmup", words.warmup);
    line.add_option("--size", words.size);
    line.add_option("--path", words.path);
    line.add_option("--png", words.png);
    CLI11_PARSE(line, count, arguments);
    return run(words);
}
