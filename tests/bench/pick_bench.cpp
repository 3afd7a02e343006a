// Measures the picker against Embree alone: one top-level tree over the same instances, asked with the same rays.
// usage: pick_bench [INSTANCES…] (3700 100000 1000000). Times are of the CPU, so that a busy machine counts little.
#include "editor/picker.h"
#include "editor/random.h"
#include "tests/unit/editor/worlds.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <ctime>
#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <unistd.h>
#include <vector>

namespace {

double seconds()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

double megabytes()
{
    std::size_t total = 0, resident = 0;
    std::ifstream{"/proc/self/statm"} >> total >> resident;
    return double(resident) * double(sysconf(_SC_PAGESIZE)) / 1e6;
}

template <class Work> double timed(Work&& work)
{
    const double start = seconds();
    work();
    return seconds() - start;
}

double share(std::vector<double> times, double part) // the time that this part of them does not exceed
{
    std::ranges::sort(times);
    return times[std::min(times.size() - 1, std::size_t(part * double(times.size())))];
}

constexpr double kMetresBetween = 8.2; // as dense as projects/forest-3

struct Bench {
    io::Scene scene;
    io::Assets assets;
    std::vector<io::Ray> rays;
    double extent = 0; // m from the middle

    Bench(std::size_t count, bool holes) : extent{kMetresBetween * std::sqrt(double(count)) / 2}
    {
        for (io::Model model :
             {test::blob(3, 45), test::blob(1, 22), test::pyramid(6), holes ? test::leafCard(8) : test::pyramid(3)}) {
            scene.templateSlot(fmt::format("model {}", assets.models.size()));
            assets.models.push_back(std::make_shared<const io::Model>(std::move(model)));
        }
        editor::Random random{1};
        scene.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            io::Transform transform = test::randomTransform(random, extent);
            transform.rotation.x = transform.rotation.z = 0;
            scene.exchange(scene.freshId(),
                           io::Object{.templateId = io::TemplateId(1 + random.bits() % 4), .transform = transform});
        }
        for (int i = 0; i < 100'000; ++i) {
            const glm::dvec3 from{random.in(-extent, extent), random.in(5, 80), random.in(-extent, extent)};
            const glm::dvec3 to{random.in(-extent, extent), random.in(0, 25), random.in(-extent, extent)};
            rays.push_back({.origin = from, .direction = glm::normalize(to - from)});
        }
    }
};

struct Release {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
template <class Handle> using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

// The least that looking through a hole takes: the nearest texel.
void lookThroughHoles(const RTCFilterFunctionNArguments* arguments)
{
    const auto& model = *static_cast<const io::Model*>(arguments->geometryUserPtr);
    const std::uint32_t* corner = &model.indices[3 * std::size_t(RTCHitN_primID(arguments->hit, 1, 0))];
    const float u = RTCHitN_u(arguments->hit, 1, 0), v = RTCHitN_v(arguments->hit, 1, 0);
    const glm::vec2 uv = model.vertices[corner[0]].uv0 * (1 - u - v) + model.vertices[corner[1]].uv0 * u +
                         model.vertices[corner[2]].uv0 * v;
    const io::Image& image = *model.images[0];
    const glm::ivec2 texel = glm::clamp(glm::ivec2{uv * glm::vec2{image.size}}, glm::ivec2{0}, image.size - 1);
    if (image.row<std::uint8_t>(texel.y)[texel.x * 4 + 3] < 128) arguments->valid[0] = 0;
}

// Embree alone: one tree over all instances, asked by the same rays. It does not look through back faces, and through
// the holes of leaves only where asked.
class Alone {
public:
    Alone(const Bench& bench, RTCSceneFlags flags, bool throughHoles) : m_top{rtcNewScene(m_device.get())}
    {
        for (const auto& model : bench.assets.models)
            addMesh(*model, flags, throughHoles);
        rtcSetSceneFlags(m_top.get(), flags);
        for (const io::Object& object : bench.scene.objects()) {
            const Owned<RTCGeometry> geometry{rtcNewGeometry(m_device.get(), RTC_GEOMETRY_TYPE_INSTANCE)};
            rtcSetGeometryInstancedScene(geometry.get(), m_meshes[io::number(object.templateId) - 1].get());
            const glm::mat4 matrix{io::worldFromModel(object.transform)};
            rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &matrix);
            rtcCommitGeometry(geometry.get());
            rtcAttachGeometry(m_top.get(), geometry.get());
        }
        rtcCommitScene(m_top.get());
    }

    bool hits(const io::Ray& ray) const
    {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        const glm::vec3 origin{ray.origin}, direction{ray.direction};
        RTCRayHit hit{};
        hit.ray = {origin.x, origin.y, origin.z, 0, direction.x, direction.y, direction.z, 0, 1e7f, ~0u, 0, 0};
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(m_top.get(), &context, &hit);
        return hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }

private:
    void addMesh(const io::Model& model, RTCSceneFlags flags, bool throughHoles)
    {
        const Owned<RTCGeometry> geometry{rtcNewGeometry(m_device.get(), RTC_GEOMETRY_TYPE_TRIANGLE)};
        rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, model.vertices.data(),
                                   0, sizeof(io::Vertex), model.vertices.size());
        rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, model.indices.data(), 0,
                                   12, model.indices.size() / 3);
        if (throughHoles && model.materials[0].alphaMode != io::AlphaMode::Opaque) {
            rtcSetGeometryUserData(geometry.get(), const_cast<io::Model*>(&model));
            rtcSetGeometryIntersectFilterFunction(geometry.get(), lookThroughHoles);
        }
        rtcCommitGeometry(geometry.get());
        m_meshes.emplace_back(rtcNewScene(m_device.get()));
        rtcSetSceneFlags(m_meshes.back().get(), flags);
        rtcAttachGeometry(m_meshes.back().get(), geometry.get());
        rtcCommitScene(m_meshes.back().get());
    }

    Owned<RTCDevice> m_device{rtcNewDevice(nullptr)};
    std::vector<Owned<RTCScene>> m_meshes;
    Owned<RTCScene> m_top;
};

// The picker and Embree alone, turn by turn, so that what else the machine does slows all of them; medians of turns.
void compare(const Bench& bench, const editor::Picker& picker)
{
    struct Way {
        const char* name;
        std::function<bool(const io::Ray&)> hits;
        std::vector<double> rates = {};
    };
    const Alone fast{bench, RTC_SCENE_FLAG_NONE, false}, robust{bench, RTC_SCENE_FLAG_ROBUST, false},
        through{bench, RTC_SCENE_FLAG_ROBUST, true};
    std::vector<Way> ways{
        {"picker", [&](const io::Ray& ray) { return bool(picker.pick(ray)); }},
        {"Embree alone", [&](const io::Ray& ray) { return fast.hits(ray); }},
        {"Embree alone, robust", [&](const io::Ray& ray) { return robust.hits(ray); }}, // as the picker's
        {"Embree alone, robust, through holes", [&](const io::Ray& ray) { return through.hits(ray); }}};
    constexpr std::size_t kTurn = 10'000; // rays
    for (std::size_t first = 0; first + kTurn <= bench.rays.size(); first += kTurn)
        for (Way& way : ways) {
            std::size_t hits = 0;
            const double time = timed([&] {
                for (std::size_t i = first; i < first + kTurn; ++i)
                    hits += way.hits(bench.rays[i]);
            });
            way.rates.push_back(double(kTurn) / time);
        }
    const double own = share(ways[0].rates, 0.5);
    for (std::size_t i = 1; i < ways.size(); ++i) {
        std::vector<double> ratios;
        for (std::size_t turn = 0; turn < ways[0].rates.size(); ++turn)
            ratios.push_back(ways[0].rates[turn] / ways[i].rates[turn]);
        fmt::print("  {}: {:.0f} rays/s; the picker's rate, {:.0f}, is {:.2f} of it\n", ways[i].name,
                   share(ways[i].rates, 0.5), own, share(ratios, 0.5));
    }
}

void measure(std::size_t count, bool holes)
{
    Bench bench{count, holes};
    editor::Random random{2};
    fmt::print("{} instances, {}\n", count, holes ? "a quarter of them leaves with holes" : "all of them solid");
    const double before = megabytes();
    editor::Picker picker;
    const double update = timed([&] { picker.update(bench.scene, bench.assets, {.everything = true}); });
    const double first = timed([&] { picker.pick(bench.rays[0]); });
    const double prepare = timed([&] { picker.prepare(); });
    fmt::print("  update {:.0f} ms, first pick {:.2f} ms, prepare {:.0f} ms, {:.0f} MB\n", update * 1e3, first * 1e3,
               prepare * 1e3, megabytes() - before);

    compare(bench, picker);
    std::size_t hits = 0;
    std::vector<double> each;
    for (std::size_t i = 0; i < 20'000; ++i)
        each.push_back(timed([&] { hits += bool(picker.pick(bench.rays[i])); }));
    fmt::print("  {:.0f} % hit; one pick: median {:.2f} us, p99 {:.2f} us, longest {:.0f} us\n",
               100.0 * double(hits) / double(each.size()), share(each, 0.5) * 1e6, share(each, 0.99) * 1e6,
               share(each, 1) * 1e6);

    std::vector<double> moves;
    for (int i = 0; i < 1000; ++i) {
        io::Object object = bench.scene.objects()[std::size_t(random.unit() * double(count))];
        object.transform.position.x += random.in(-20, 20);
        const io::ObjectId id = object.id;
        const io::Ray ray{.origin = object.transform.position + glm::dvec3{0.1, 90, 0.1}, .direction = {0, -1, 0}};
        bench.scene.exchange(id, std::move(object));
        moves.push_back(timed([&] {
            picker.update(bench.scene, bench.assets, {.objects = {id}});
            picker.pick(ray);
        }));
    }
    fmt::print("  move one and pick it: median {:.3f} ms, p99 {:.3f} ms, longest {:.3f} ms\n", share(moves, 0.5) * 1e3,
               share(moves, 0.99) * 1e3, share(moves, 1) * 1e3);

    std::vector<io::Object> gone;
    io::Changes changes;
    for (std::size_t i = 0; i < std::min<std::size_t>(count / 2, 100'000); ++i)
        gone.push_back(bench.scene.objects()[i]);
    for (const io::Object& object : gone) {
        changes.objects.push_back(object.id);
        bench.scene.exchange(object.id, std::nullopt);
    }
    const double removal = timed([&] { picker.update(bench.scene, bench.assets, changes); });
    const double pickWithout = timed([&] { picker.pick(bench.rays[1]); });
    for (const io::Object& object : gone)
        bench.scene.exchange(object.id, object);
    const double undo = timed([&] { picker.update(bench.scene, bench.assets, changes); });
    const double pickAgain = timed([&] { picker.pick(bench.rays[2]); });
    fmt::print("  delete {}: {:.1f} ms, then a pick {:.1f} ms; undo {:.1f} ms, then a pick {:.1f} ms\n", gone.size(),
               removal * 1e3, pickWithout * 1e3, undo * 1e3, pickAgain * 1e3);
    picker.prepare();
    compare(bench, picker);
    std::fflush(stdout);
}

} // namespace

int main(int count, char** words)
{
    std::vector<std::size_t> sizes;
    for (int i = 1; i < count; ++i)
        std::from_chars(words[i], words[i] + std::strlen(words[i]), sizes.emplace_back());
    for (const std::size_t size : sizes.empty() ? std::vector<std::size_t>{3'700, 100'000, 1'000'000} : sizes)
        for (const bool holes : {false, true})
            measure(size, holes);
}
