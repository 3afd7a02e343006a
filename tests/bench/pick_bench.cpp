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
#include <string>
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

// Rays a second, of Embree alone, which looks through neither back faces nor holes in leaves.
double raw(const Bench& bench, RTCSceneFlags flags, double& commit)
{
    const RTCDevice device = rtcNewDevice(nullptr);
    std::vector<RTCScene> meshes;
    for (const auto& model : bench.assets.models) {
        const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, model->vertices.data(), 0,
                                   sizeof(io::Vertex), model->vertices.size());
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, model->indices.data(), 0, 12,
                                   model->indices.size() / 3);
        rtcCommitGeometry(geometry);
        meshes.push_back(rtcNewScene(device));
        rtcSetSceneFlags(meshes.back(), flags);
        rtcAttachGeometry(meshes.back(), geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(meshes.back());
    }
    const RTCScene top = rtcNewScene(device);
    rtcSetSceneFlags(top, flags);
    for (const io::Object& object : bench.scene.objects()) {
        const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(geometry, meshes[io::number(object.templateId) - 1]);
        const glm::mat4 matrix{io::worldFromModel(object.transform)};
        rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &matrix);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(top, geometry);
        rtcReleaseGeometry(geometry);
    }
    commit = timed([&] { rtcCommitScene(top); });
    const double time = timed([&] {
        for (const io::Ray& ray : bench.rays) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            RTCRayHit hit{};
            hit.ray = {float(ray.origin.x),
                       float(ray.origin.y),
                       float(ray.origin.z),
                       0,
                       float(ray.direction.x),
                       float(ray.direction.y),
                       float(ray.direction.z),
                       0,
                       1e7f,
                       ~0u,
                       0,
                       0};
            hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(top, &context, &hit);
        }
    });
    for (const RTCScene mesh : meshes)
        rtcReleaseScene(mesh);
    rtcReleaseScene(top);
    rtcReleaseDevice(device);
    return double(bench.rays.size()) / time;
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

    std::size_t hits = 0;
    const auto pickAll = [&] {
        for (const io::Ray& ray : bench.rays)
            hits += bool(picker.pick(ray));
    };
    const double rate = double(bench.rays.size()) / timed(pickAll);
    std::vector<double> each;
    for (std::size_t i = 0; i < 20'000; ++i)
        each.push_back(timed([&] { picker.pick(bench.rays[i]); }));
    fmt::print("  {:.0f} rays/s, {:.0f} % hit; one pick: median {:.2f} us, p99 {:.2f} us, longest {:.0f} us\n", rate,
               100.0 * double(hits) / double(bench.rays.size()), share(each, 0.5) * 1e6, share(each, 0.99) * 1e6,
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
    const double restored = timed([&] { picker.prepare(); });
    const double rateAgain = double(bench.rays.size()) / timed(pickAll);
    fmt::print("  prepare {:.0f} ms, {:.0f} rays/s\n", restored * 1e3, rateAgain);

    for (const RTCSceneFlags flags : {RTC_SCENE_FLAG_NONE, RTC_SCENE_FLAG_ROBUST}) { // the picker's is robust
        double commit = 0;
        const double rawRate = raw(bench, flags, commit);
        fmt::print("  Embree alone{}: commit {:.0f} ms, {:.0f} rays/s; the picker's rate is {:.2f} of it\n",
                   flags == RTC_SCENE_FLAG_ROBUST ? ", robust" : "", commit * 1e3, rawRate, rate / rawRate);
    }
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
