#include "tests/gl/support/culling_oracle.h"

#include <unordered_map>

namespace test {
namespace {

using Pixels = std::unordered_map<std::uint32_t, std::uint32_t>; // how many each id owns

std::shared_ptr<const io::Model> besideItsOrigin(const glm::vec3& size, const glm::vec3& by)
{
    io::Model model = io::boxModel(size, glm::vec4{0.6f});
    model.bounds = {};
    for (io::Vertex& vertex : model.vertices) {
        vertex.position += by;
        model.bounds.add(vertex.position);
    }
    return std::make_shared<io::Model>(std::move(model));
}

Pixels pixelsOf(const renderer::FrameInput& in)
{
    shared().render(in);
    Pixels pixels;
    std::uint32_t last = 0, run = 0; // neighbours are mostly of one object
    const auto note = [&] {
        if (last != 0 && last != renderer::kTerrainId) pixels[last] += run;
    };
    for (const std::uint32_t id : shared().readIds({0, 0}, in.size)) {
        if (id != last) note(), run = 0;
        last = id;
        ++run;
    }
    note();
    return pixels;
}

} // namespace

TestWorld oracleWorld(int objects)
{
    TestWorld world;
    io::Terrain terrain;
    terrain.heightMap = "terrain/hills.png";
    world.scene.exchange(heightMap({257, 257}, 2, hills));
    world.scene.exchange(std::move(terrain));
    const auto add = [&](const char* name, std::shared_ptr<const io::Model> model) { return addTemplate(world, name, std::move(model)); };
    const io::TemplateId crate = add("crate", box({1, 1, 1}, glm::vec4{0.5f})), post = add("post", box({0.2f, 6, 0.2f}, glm::vec4{0.4f})),
                         slab = add("slab", box({4, 0.3f, 3}, glm::vec4{0.7f})), tower = add("tower", box({6, 25, 6}, glm::vec4{0.3f})),
                         wall = add("wall", box({40, 12, 0.5f}, glm::vec4{0.8f})),
                         beside = add("beside", besideItsOrigin({2, 2, 2}, {5, 3, 0}));
    const auto kindOf = [&](int i) {
        const int share = i % 100;
        return share < 60 ? crate : share < 75 ? post : share < 90 ? slab : share < 97 ? beside : share < 99 ? tower : wall;
    };
    std::mt19937 random{42};
    std::uniform_real_distribution<double> place{-240, 240}, turn{0, 360}, size{0.6, 1.8}, chance{0, 1};
    for (int i = 0; i < objects; ++i) {
        io::Transform t;
        t.position = {place(random), 0, place(random)};
        t.position.y = world.scene.heights()->height(t.position.x, t.position.z).value_or(0);
        t.rotation.y = float(turn(random));
        if (i % 100 < 97 && chance(random) < 0.5) t.rotation = {float(turn(random)), t.rotation.y, float(turn(random))};
        t.scale = {float(size(random)), float(size(random)), float(size(random))};
        if (chance(random) < 0.1) t.scale.x = -t.scale.x;
        addObject(world, kindOf(i), t);
    }
    return world;
}

io::Camera cameraIn(const TestWorld& world, std::mt19937& random)
{
    std::uniform_real_distribution<double> place{-220, 220}, turn{-180, 180}, tilt{-40, 15}, above{1.5, 25}, fov{25, 100};
    io::Camera camera{.eye = {place(random), 0, place(random)}, .yaw = float(turn(random)), .pitch = float(tilt(random))};
    camera.eye.y = world.scene.heights()->height(camera.eye.x, camera.eye.z).value_or(0) + above(random);
    camera.fov = float(fov(random));
    return camera;
}

void askOracle(const io::Camera& camera, glm::ivec2 size, OracleCounts& counts,
               const std::function<void(const Missing&)>& tell)
{
    renderer::FrameInput in = frame(size, camera);
    in.show = renderer::Show::Id;
    in.settings.shadows = in.settings.clouds = in.settings.fog = false;
    in.settings.culler = renderer::Culler::Cpu;
    in.settings.culling = false;
    const Pixels all = pixelsOf(in);
    const auto missingIn = [&](const char* how, const Pixels& culled) {
        std::uint64_t missing = 0;
        for (const auto& [id, pixels] : all)
            if (!culled.contains(id)) {
                ++missing;
                if (tell) tell({how, camera, id, pixels});
            }
        return missing;
    };
    ++counts.cameras;
    counts.ids += all.size();
    in.settings.culling = true;
    counts.cpuMissing += missingIn("cpu", pixelsOf(in));
    counts.drawn += shared().stats().instancesDrawn;
    counts.tooSmall += shared().stats().instancesInside - shared().stats().instancesLarge;
    in.settings.culler = renderer::Culler::Gpu;
    counts.gpuCutMissing += missingIn("gpu after a cut", pixelsOf(in));
    counts.gpuMissing += missingIn("gpu", pixelsOf(in));
    counts.gpuDrawn += shared().stats().instancesDrawn;
}

} // namespace test
