// What changes cost in a large world: reading it, moving one object, deleting 100,000 and undoing that, saving.
// usage: edit_bench PROJECT (as tests/bench/scatter.py makes it; it is saved into). The figures go to stdout as JSON.
#include "app/headless.h"
#include "editor/document.h"
#include "editor/picker.h"
#include "editor/random.h"
#include "io/files/json.h"
#include "renderer/device.h"
#include "renderer/world.h"
#include "tests/bench/clock.h"

#include <cstdio>
#include <fstream>
#include <malloc.h>
#include <optional>
#include <unistd.h>

namespace {

constexpr int kMoves = 500;
constexpr std::size_t kDeleted = 100'000;

double megabytes() // that this process holds, without what only the allocator keeps
{
    malloc_trim(0);
    std::size_t total = 0, resident = 0;
    std::ifstream{"/proc/self/statm"} >> total >> resident;
    return double(resident) * double(sysconf(_SC_PAGESIZE)) / 1e6;
}

struct Cost {
    double wall = 0, thread = 0; // ms
};

template <class Work> Cost costOf(Work&& work)
{
    const double wall = bench::wallMs(), thread = bench::threadMs();
    work();
    return {bench::wallMs() - wall, bench::threadMs() - thread};
}

// A document and its two mirrors, as the editor holds them.
class Edited {
public:
    explicit Edited(io::World world, io::Assets assets) : m_document{std::move(world), std::move(assets)} { follow(); }

    editor::Document& document() { return m_document; }
    std::uint64_t uploadedBytes() const { return m_world.uploadedBytes(); }
    void prepare() { m_picker.prepare(); }

    void follow() // until GPU and picker know it
    {
        const io::Changes changes = m_document.takeChanges();
        m_world.update(m_document.scene(), m_document.assets(), changes);
        m_world.upload(true); // all that the device needs to cull by itself
        m_picker.update(m_document.scene(), m_document.assets(), changes);
    }
    bool pickDownAt(const glm::dvec3& place)
    {
        return bool(m_picker.pick({.origin = place + glm::dvec3{0.1, 90, 0.1}, .direction = {0, -1, 0}}));
    }

private:
    editor::Document m_document;
    renderer::World m_world;
    editor::Picker m_picker;
};

void measureMoves(Edited& edited, io::Value& figures)
{
    editor::Random random{1};
    std::vector<double> wall, thread, bytes;
    for (int i = 0; i < kMoves; ++i) {
        const auto objects = edited.document().scene().objects();
        const io::ObjectId id = objects[std::size_t(random.unit() * double(objects.size()))].id;
        const glm::dvec3 by{random.in(-20, 20), 0, random.in(-20, 20)};
        const std::uint64_t before = edited.uploadedBytes();
        const Cost cost = costOf([&] {
            editor::edit(edited.document(), "Move", {{id}}, [&](io::Object& o) { o.transform.position += by; });
            edited.follow();
            edited.pickDownAt(edited.document().scene().at(id).transform.position);
        });
        renderer::waitForDevice();
        wall.push_back(cost.wall);
        thread.push_back(cost.thread);
        bytes.push_back(double(edited.uploadedBytes() - before));
    }
    figures["move_ms"] = bench::share(thread, 0.5);
    figures["move_p99_ms"] = bench::share(thread, 0.99);
    figures["move_wall_ms"] = bench::share(wall, 0.5);
    figures["move_bytes"] = bench::share(bytes, 1);
}

void measureDelete(Edited& edited, io::Value& figures)
{
    std::vector<io::ObjectId> ids = edited.document().scene().sortedIds();
    ids.resize(std::min(ids.size(), kDeleted));
    const auto count = [&](const char* name, const Cost& cost) {
        figures[std::string{name} + "_ms"] = cost.wall;
        figures[std::string{name} + "_thread_ms"] = cost.thread;
    };
    figures["deleted"] = std::uint64_t(ids.size());
    count("delete_command", costOf([&] { editor::removeObjects(edited.document(), "Delete", ids); }));
    count("delete_follow", costOf([&] { edited.follow(); }));
    edited.pickDownAt({0, 0, 0});
    count("undo_command", costOf([&] { edited.document().undo(); }));
    count("undo_follow", costOf([&] { edited.follow(); }));
    figures["undo_ms"] = *figures.find("undo_command_ms")->asNumber() + *figures.find("undo_follow_ms")->asNumber();
    figures["undo_thread_ms"] =
        *figures.find("undo_command_thread_ms")->asNumber() + *figures.find("undo_follow_thread_ms")->asNumber();
    count("undo_first_pick", costOf([&] { edited.pickDownAt({0, 0, 0}); }));
}

int run(const char* project)
{
    io::Value figures = io::Value::Object{};
    io::Complaints complaints;
    const double before = megabytes();
    io::Result<io::World> world = io::Error{};
    const Cost read = costOf([&] { world = io::openWorld(project, {}, complaints); });
    if (!world) return std::fprintf(stderr, "edit_bench: %s\n", world.error().text().c_str()), 1;
    figures["objects"] = std::uint64_t(world->scene.objects().size());
    figures["read_ms"] = read.wall;
    figures["read_thread_ms"] = read.thread;
    figures["scene_mb"] = megabytes() - before;
    auto assets = io::readAssets(*world, complaints);
    if (!assets) return std::fprintf(stderr, "edit_bench: %s\n", assets.error().text().c_str()), 1;

    const auto context = app::makeHeadless();
    if (!context) return std::fprintf(stderr, "edit_bench: %s\n", context.error().text().c_str()), 1;
    const double withAssets = megabytes();
    std::optional<Edited> edited;
    figures["mirrors_ms"] = costOf([&] { edited.emplace(*std::move(world), *std::move(assets)); }).wall;
    figures["pick_index_ms"] = costOf([&] { edited->prepare(); }).wall;
    figures["mirrors_mb"] = megabytes() - withAssets;
    measureMoves(*edited, figures);
    measureDelete(*edited, figures);

    io::Status saved;
    const Cost save = costOf([&] {
        if (auto report = edited->document().save(); !report) saved = report.error();
    });
    if (!saved) return std::fprintf(stderr, "edit_bench: %s\n", saved.error().text().c_str()), 1;
    figures["save_ms"] = save.wall;
    figures["save_thread_ms"] = save.thread;
    std::puts(io::writeJson(figures, 2).c_str());
    return 0;
}

} // namespace

int main(int count, char** words)
{
    if (count != 2) return std::fputs("usage: edit_bench PROJECT\n", stderr), 2;
    return run(words[1]);
}
