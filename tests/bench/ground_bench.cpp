// What the ground costs: reading a map, choosing what is drawn of it, dabs of brushes until GPU, rays and undo know them, heights
// asked for. usage: ground_bench PROJECT (tests/bench/ground.py makes one). The figures go to stdout as JSON.
#include "app/headless.h"
#include "editor/document.h"
#include "editor/picker.h"
#include "editor/random.h"
#include "editor/stroke.h"
#include "io/files/json.h"
#include "renderer/device.h"
#include "renderer/eye.h"
#include "renderer/terrain.h"
#include "tests/bench/clock.h"

#include <cstdio>

namespace {

constexpr int kDabs = 60, kQueries = 2'000'000, kFrames = 400;

class Ground { // a document and the mirrors that follow its heights
public:
    explicit Ground(io::World world, io::Assets assets) : m_document{std::move(world), std::move(assets)} { follow(); }
    void follow()
    {
        const io::Changes changes = m_document.takeChanges();
        m_terrain.update(m_document.scene(), m_document.assets(), changes);
        m_picker.update(m_document.scene(), m_document.assets(), changes);
    }
    editor::Document& document() { return m_document; }
    renderer::Terrain& terrain() { return m_terrain; }
    editor::Picker& picker() { return m_picker; }
    const io::HeightMap& heights() { return *m_document.scene().heights(); }

private:
    editor::Document m_document;
    renderer::Terrain m_terrain;
    editor::Picker m_picker;
};

glm::dvec2 somewhere(editor::Random& random, const io::HeightMap& map)
{
    const glm::dvec2 reach = glm::dvec2{map.size - 1} * map.metresPerTexel;
    return map.origin + reach * glm::dvec2{random.in(0.1, 0.9), random.in(0.1, 0.9)};
}

// Median and p99 of the thread's time for one dab of a stroke, all mirrors included.
void measureDabs(Ground& ground, const char* name, editor::Brush brush, io::Value& figures)
{
    editor::Random random{3};
    std::vector<double> times;
    for (int i = 0; i < kDabs; ++i) {
        const glm::dvec2 at = somewhere(random, ground.heights());
        editor::Stroke stroke{ground.document(), brush, {}, "Dab"};
        stroke.to({at.x, 0, at.y}); // the first of a stroke also looks for objects
        ground.follow();
        const double start = bench::threadMs();
        stroke.to({at.x + double(brush.radius) * 0.21, 0, at.y}); // one more
        ground.follow();
        ground.picker().pick({.origin = {at.x, 1e4, at.y}, .direction = {0, -1, 0}});
        times.push_back(bench::threadMs() - start);
        stroke.end();
        renderer::waitForDevice();
    }
    figures[std::string{name} + "_ms"] = bench::share(times, 0.5);
    figures[std::string{name} + "_p99_ms"] = bench::share(times, 0.99);
}

void measureChoosing(Ground& ground, io::Value& figures)
{
    const io::HeightMap& map = ground.heights();
    const glm::dvec2 middle = map.origin + glm::dvec2{map.size - 1} * map.metresPerTexel * 0.5;
    io::Value::Array triangles;
    std::vector<double> times;
    renderer::GpuStream stream;
    for (const double above : {1.7, 10.0, 100.0, 300.0, 1000.0, 3000.0}) {
        std::vector<double> counts;
        for (int i = 0; i < kFrames / 6; ++i) {
            io::Camera camera{.eye = {middle.x + i * 3.0, 0, middle.y}, .yaw = float(i * 11), .pitch = above > 100 ? -35.0f : -3.0f};
            camera.eye.y = map.height(camera.eye.x, camera.eye.z).value_or(0) + above;
            const renderer::Eye eye = renderer::eyeOf(camera, {1280, 720});
            stream.beginFrame();
            const double start = bench::threadMs();
            ground.terrain().aim(eye, eye);
            const auto draws = ground.terrain().draws(stream, renderer::volumeOf(eye), renderer::GroundStages::Grid);
            times.push_back(bench::threadMs() - start);
            counts.push_back(double(draws.front().triangles));
            stream.endFrame();
        }
        triangles.push_back(io::Value::Object{{"above_m", above}, {"triangles", bench::share(counts, 0.5)}});
    }
    figures["choosing_ms"] = bench::share(times, 0.5);
    figures["choosing_p99_ms"] = bench::share(times, 0.99);
    figures["triangles"] = std::move(triangles);
}

void measureQueries(Ground& ground, io::Value& figures)
{
    editor::Random random{5};
    const io::HeightMap& map = ground.heights();
    std::vector<glm::dvec2> places;
    for (int i = 0; i < 4096; ++i)
        places.push_back(somewhere(random, map));
    double sum = 0;
    const double start = bench::threadMs();
    for (int i = 0; i < kQueries; ++i)
        sum += map.height(places[std::size_t(i) & 4095].x, places[std::size_t(i) & 4095].y).value_or(0);
    figures["heights_per_second"] = kQueries / (bench::threadMs() - start) * 1e3;
    figures["heights_mean"] = sum / kQueries; // so that it is not left out
}

int run(const char* project)
{
    io::Value figures = io::Value::Object{};
    io::Complaints complaints;
    const double start = bench::wallMs();
    auto world = io::openWorld(project, {}, complaints);
    if (!world) return std::fprintf(stderr, "ground_bench: %s\n", world.error().text().c_str()), 1;
    auto assets = io::readAssets(*world, complaints);
    if (!assets || !world->scene.heights()) return std::fprintf(stderr, "ground_bench: %s: no ground\n", project), 1;
    figures["read_ms"] = bench::wallMs() - start;
    figures["texels"] = io::Value::Array{world->scene.heights()->size.x, world->scene.heights()->size.y};
    const auto context = app::makeHeadless();
    if (!context) return std::fprintf(stderr, "ground_bench: %s\n", context.error().text().c_str()), 1;
    const double mirrors = bench::wallMs();
    Ground ground{*std::move(world), *std::move(assets)};
    ground.picker().prepare();
    renderer::waitForDevice();
    figures["mirrors_ms"] = bench::wallMs() - mirrors;

    using editor::BrushTool;
    measureChoosing(ground, figures);
    measureQueries(ground, figures);
    const auto texel = float(ground.heights().metresPerTexel);
    measureDabs(ground, "dab_64_texels", {.radius = 32 * texel}, figures);
    for (const auto& [name, tool] : {std::pair{"raise", BrushTool::Raise}, {"smooth", BrushTool::Smooth}, {"flatten", BrushTool::Flatten}, {"noise", BrushTool::Noise},
                                     {"terrace", BrushTool::Terrace}, {"slump", BrushTool::Slump}, {"erode", BrushTool::Erode}, {"paint", BrushTool::Paint}})
        measureDabs(ground, (std::string{name} + "_200_m").c_str(), {.tool = tool, .radius = 200}, figures);
    figures["undo_bytes"] = std::uint64_t(ground.document().history().bytes());
    figures["undo_steps"] = std::uint64_t(ground.document().history().position());
    const double undo = bench::wallMs();
    ground.document().undo();
    ground.follow();
    figures["undo_ms"] = bench::wallMs() - undo;
    std::puts(io::writeJson(figures, 2).c_str());
    return 0;
}

} // namespace

int main(int count, char** words)
{
    if (count != 2) return std::fprintf(stderr, "usage: ground_bench PROJECT\n"), 2;
    return run(words[1]);
}
