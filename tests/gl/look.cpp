// Draws the test landscape to a PNG, for a person who works on the renderer and wants to see what changed.
// look OUT [X Y Z YAW PITCH] [hour=H] [show=NAME] [size=WxH] [frames=N]
#include "renderer/renderer.h"
#include "tests/gl/support/gl_context.h"
#include "tests/gl/support/test_world.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>

namespace {

std::string option(int argc, char** argv, const std::string& key, const std::string& fallback)
{
    for (int i = 1; i < argc; ++i)
        if (std::string_view{argv[i]}.starts_with(key + "=")) return argv[i] + key.size() + 1;
    return fallback;
}

} // namespace

int main(int argc, char** argv)
{
    const test::GlContext context;
    if (!context.valid()) return std::fprintf(stderr, "%s\n", context.fault().c_str()), 1;
    auto made = renderer::Renderer::create({.shaders = WOLD_SOURCE_DIR "/renderer/shaders", .debug = true});
    if (!made) return std::fprintf(stderr, "%s\n", made.error().text().c_str()), 1;
    renderer::Renderer& renderer = **made;

    test::TestWorld world = test::makeWorld({.trees = std::stoi(option(argc, argv, "trees", "2500"))});
    io::Environment environment;
    environment.time = std::stof(option(argc, argv, "hour", "10.5"));
    environment.clouds.coverage = std::stof(option(argc, argv, "clouds", "0.35"));
    environment.exposure = std::stof(option(argc, argv, "ev", "2"));
    environment.fog.density = std::stof(option(argc, argv, "fog", "0.00012"));
    world.scene.exchange(environment);
    renderer.update(world.scene, world.assets, {.everything = true});

    renderer::FrameInput in;
    in.camera = {.eye = {20, 60, 200}, .yaw = 10, .pitch = -6};
    if (argc > 6 && !std::strchr(argv[2], '='))
        in.camera = {.eye = {std::stod(argv[2]), std::stod(argv[3]), std::stod(argv[4])}, .yaw = std::stof(argv[5]), .pitch = std::stof(argv[6])};
    std::sscanf(option(argc, argv, "size", "1280x720").c_str(), "%dx%d", &in.size.x, &in.size.y);
    const auto names = enumNames(renderer::Show{});
    in.show = renderer::Show(std::find(names.begin(), names.end(), option(argc, argv, "show", "final")) - names.begin());
    if (option(argc, argv, "culling", "on") == "off") in.settings.culling = false;
    in.settings.largestShadowMap = std::stoi(option(argc, argv, "shadowmap", "8192"));
    in.settings.shadows = option(argc, argv, "shadows", "on") == "on";
    in.settings.antiAliasing = option(argc, argv, "aa", "fxaa") == "fxaa" ? renderer::AntiAliasing::Fxaa : renderer::AntiAliasing::Off;
    std::vector<io::ObjectId> selection;
    if (option(argc, argv, "select", "off") == "on")
        for (const io::Object& o : world.scene.objects())
            if (io::number(o.id) % 7 == 0) selection.push_back(o.id);
    in.selection = selection;
    std::vector<renderer::Ghost> ghosts;
    std::vector<renderer::Line> lines;
    if (option(argc, argv, "ghost", "off") == "on") {
        const glm::dvec3 at = in.camera.eye + io::forward(in.camera) * 22.0 - glm::dvec3{0, 5, 0};
        ghosts.push_back({io::TemplateId(1), {.position = at}});
        ghosts.push_back({io::TemplateId(2), {.position = at + glm::dvec3{6, 0, 0}}});
        for (int i = 0; i < 10; ++i)
            lines.push_back({at + glm::dvec3{i - 5, 0, -5}, at + glm::dvec3{i - 5, 3, 5}, {1, i * 0.1f, 0, 1}, i % 2 == 0});
    }
    in.ghosts = ghosts;
    in.lines = lines;

    const int frames = std::stoi(option(argc, argv, "frames", "3"));
    double best = 1e9;
    for (int frame = 0; frame < frames; ++frame) {
        in.camera.eye.x += frame ? 0.7 : 0; // so that nothing is kept from the frame before
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t clock = std::clock();
        renderer.render(in);
        const io::Image image = renderer.readPicture();
        const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        best = std::min(best, ms);
        std::printf("frame %d: %.1f ms, %.1f ms of processor time\n", frame, ms, 1e3 * double(std::clock() - clock) / CLOCKS_PER_SEC);
        if (frame + 1 == frames) test::writePng(argc > 1 ? argv[1] : "look.png", image);
    }
    const renderer::FrameStats& stats = renderer.stats();
    for (const renderer::PassTime& pass : stats.passes)
        std::printf("%-14s cpu %7.2f ms  gpu %7.2f ms\n", pass.name.c_str(), pass.cpuMs, pass.gpuMs);
    std::printf("draws %llu, triangles %llu (%llu in view), instances %llu of %llu, %llu MB, GL errors %llu\n",
                (unsigned long long)stats.drawCalls, (unsigned long long)stats.trianglesSubmitted,
                (unsigned long long)stats.trianglesDrawn, (unsigned long long)stats.instancesDrawn,
                (unsigned long long)stats.instances, (unsigned long long)(stats.gpuBytes >> 20),
                (unsigned long long)renderer.glErrors());
    return 0;
}
