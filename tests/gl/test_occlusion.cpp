// Ambient occlusion against rays: the share of a cosine-weighted hemisphere that nothing near hides.
#include "renderer/shaders/shared/occlusion.h"
#include "tests/gl/support/shared_renderer.h"

#include <algorithm>
#include <cmath>
#include <embree3/rtcore.h>
#include <gtest/gtest.h>
#include <memory>
#include <random>

namespace {

constexpr glm::ivec2 kSize{240, 136};

// All triangles of a world in one Embree scene.
class Rays {
public:
    explicit Rays(const test::TestWorld& world) : m_device{rtcNewDevice(nullptr)}, m_scene{rtcNewScene(m_device)}
    {
        for (const io::Object& object : world.scene.objects()) {
            const auto& model = world.assets.models[io::number(object.templateId) - 1];
            const glm::dmat4 matrix = io::worldFromModel(object.transform);
            std::vector<glm::vec3> corners;
            for (const std::uint32_t index : model->indices)
                corners.emplace_back(matrix * glm::dvec4{model->vertices[index].position, 1});
            add(corners);
        }
        if (world.scene.heights()) addGround(*world.scene.heights());
        rtcCommitScene(m_scene);
    }
    ~Rays()
    {
        rtcReleaseScene(m_scene);
        rtcReleaseDevice(m_device);
    }
    Rays(const Rays&) = delete;
    Rays& operator=(const Rays&) = delete;

    struct Hit {
        float distance = -1; // m; below 0: none
        glm::vec3 normal{0};
    };
    Hit hit(const glm::vec3& from, const glm::vec3& direction, float reach) const
    {
        RTCRayHit ray{};
        ray.ray = {.org_x = from.x, .org_y = from.y, .org_z = from.z, .tnear = 0, .dir_x = direction.x, .dir_y = direction.y, .dir_z = direction.z, .tfar = reach, .mask = ~0u};
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(m_scene, &context, &ray);
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        glm::vec3 normal = glm::normalize(glm::vec3{ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z});
        if (glm::dot(normal, direction) > 0) normal = -normal;
        return {ray.ray.tfar, normal};
    }

    // Share of the sky that is seen, by 256 rays; what they meet counts as in the shader.
    double seen(const glm::vec3& place, const glm::vec3& normal, float radius, std::mt19937& random) const
    {
        constexpr int kSide = 16;
        std::uniform_real_distribution<float> unit{0, 1};
        const glm::vec3 tangent = glm::normalize(glm::cross(normal, std::abs(normal.y) > 0.9f ? glm::vec3{1, 0, 0} : glm::vec3{0, 1, 0}));
        const glm::vec3 bitangent = glm::cross(normal, tangent);
        double hidden = 0;
        for (int i = 0; i < kSide * kSide; ++i) {
            const float u = (float(i % kSide) + unit(random)) / kSide, phi = 6.2831853f * (float(i / kSide) + unit(random)) / kSide;
            const float r = std::sqrt(u);
            const glm::vec3 d = tangent * (r * std::cos(phi)) + bitangent * (r * std::sin(phi)) + normal * std::sqrt(1 - u);
            const Hit found = hit(place + normal * 1e-3f, d, radius);
            if (found.distance >= 0) hidden += glsl::occlusionWeight(found.distance, radius);
        }
        return 1 - hidden / (kSide * kSide);
    }

private:
    void add(const std::vector<glm::vec3>& corners)
    {
        const RTCGeometry geometry = rtcNewGeometry(m_device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), corners.size()));
        std::ranges::copy(corners, vertices);
        auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), corners.size() / 3));
        for (std::uint32_t i = 0; i < corners.size(); ++i)
            indices[i] = i;
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(m_scene, geometry);
        rtcReleaseGeometry(geometry);
    }
    void addGround(const io::HeightMap& map)
    {
        std::vector<glm::vec3> corners;
        const auto corner = [&](int x, int z) {
            const glm::dvec2 at = map.origin + glm::dvec2{x, z} * map.metresPerTexel;
            return glm::vec3{at.x, map.height(at.x, at.y).value_or(0), at.y};
        };
        for (int z = 0; z + 1 < map.size.y; ++z)
            for (int x = 0; x + 1 < map.size.x; ++x)
                for (const glm::ivec2 o : {glm::ivec2{0, 0}, {0, 1}, {1, 0}, {1, 0}, {0, 1}, {1, 1}})
                    corners.push_back(corner(x + o.x, z + o.y));
        add(corners);
    }

    RTCDevice m_device;
    RTCScene m_scene;
};

void addBox(test::TestWorld& world, const std::string& name, const glm::vec3& size, const io::Transform& transform)
{
    io::TemplateId id = world.scene.findTemplate(name);
    if (id == io::TemplateId::None) id = test::addTemplate(world, name, test::box(size, {0.6f, 0.6f, 0.6f, 1}));
    test::addObject(world, id, transform);
}

test::TestWorld emptyWorld(float radius)
{
    test::TestWorld world;
    io::Environment e = test::plainEnvironment(150, 45);
    e.occlusion.radius = radius;
    world.scene.exchange(e);
    return world;
}

test::TestWorld floorOnly(float radius = 2)
{
    test::TestWorld world = emptyWorld(radius);
    addBox(world, "floor", {400, 1, 400}, {.position = {0, -1, 0}});
    return world;
}

struct View {
    test::TestWorld world;
    io::Camera camera;
};

View crates() // boxes of all sizes at all turns on a floor
{
    View view{floorOnly(), {.eye = {0, 5, 13}, .pitch = -22, .fov = 60}};
    std::mt19937 random{5};
    std::uniform_real_distribution<double> place{-8, 8}, turn{0, 90}, size{0.5, 1.6};
    for (int i = 0; i < 45; ++i)
        addBox(view.world, "crate", {1.3f, 1.3f, 1.3f}, {.position = {place(random), -0.02, place(random)}, .rotation = {0, float(turn(random)), 0}, .scale = glm::vec3{float(size(random))}});
    return view;
}

View yard() // walls, a stair, a slab on posts
{
    View view{floorOnly(1.5f), {.eye = {5, 4, 8}, .yaw = 28, .pitch = -20, .fov = 65}};
    addBox(view.world, "wall", {14, 5, 0.5f}, {.position = {0, 0, -5}});
    addBox(view.world, "wall", {14, 5, 0.5f}, {.position = {-6, 0, 1}, .rotation = {0, 90, 0}});
    for (int i = 0; i < 7; ++i)
        addBox(view.world, "stair", {3, 0.4f, 0.6f}, {.position = {-2, 0.4 * i, -1.2 - 0.6 * i}});
    for (int i = 0; i < 4; ++i)
        addBox(view.world, "post", {0.4f, 2.4f, 0.4f}, {.position = {2.0 + 2 * (i & 1), 0, -3.0 + 2 * (i >> 1)}});
    addBox(view.world, "slab", {3.5f, 0.3f, 3.5f}, {.position = {3, 2.4, -2}});
    return view;
}

View rocks() // hilly ground with blocks that lean in it
{
    View view{emptyWorld(3), {.eye = {0, 14, 26}, .pitch = -24, .fov = 60}};
    view.world.scene.exchange(io::Terrain{.heightMap = "terrain/rough.png"});
    const auto ground = [](double x, double z) { return 2.4 * std::sin(x * 0.45) * std::cos(z * 0.38) + 0.8 * std::sin(x * 1.1 + z * 0.7); };
    view.world.scene.exchange(test::heightMap({129, 129}, 0.5, ground));
    std::mt19937 random{2};
    std::uniform_real_distribution<double> place{-16, 16}, turn{-40, 40};
    for (int i = 0; i < 40; ++i) {
        const double x = place(random), z = place(random);
        addBox(view.world, "block", {2, 2.4f, 1.6f}, {.position = {x, ground(x, z) - 0.4, z}, .rotation = {float(turn(random)), float(turn(random) * 4), float(turn(random))}});
    }
    return view;
}

std::vector<double> occlusion(test::TestWorld& world, const io::Camera& camera, bool half, glm::ivec2 size = kSize)
{
    test::load(world);
    renderer::FrameInput in = test::frame(size, camera);
    in.settings.halfOcclusion = half;
    in.show = renderer::Show::Ao;
    test::shared().render(in);
    const io::Image image = test::shared().readPicture();
    std::vector<double> values;
    for (int i = 0; i < size.x * size.y; ++i)
        values.push_back(image.row<glm::u8vec4>(0)[i].x / 255.0);
    return values;
}

struct Difference {
    double rms = 0, mean = 0;
};

Difference againstRays(View& view, bool half)
{
    const std::vector<double> shown = occlusion(view.world, view.camera, half);
    const Rays rays{view.world};
    const float radius = view.world.scene.environment().occlusion.radius;
    std::mt19937 random{1};
    double squares = 0, sum = 0;
    int count = 0;
    for (int y = 0; y < kSize.y; y += 2)
        for (int x = y / 2 % 2; x < kSize.x; x += 2) {
            const io::Ray ray = renderer::rayThrough(view.camera, kSize, {x + 0.5, y + 0.5});
            const Rays::Hit first = rays.hit(glm::vec3{ray.origin}, glm::vec3{ray.direction}, 60);
            if (first.distance < 0) continue;
            const double wanted = rays.seen(glm::vec3{ray.origin + ray.direction * double(first.distance)}, first.normal, radius, random);
            const double error = shown[std::size_t(y * kSize.x + x)] - wanted;
            squares += error * error;
            sum += error;
            ++count;
        }
    return {std::sqrt(squares / count), sum / count};
}

TEST(Occlusion, IsThatOfRays)
{
    ASSERT_TRUE(test::haveContext());
    for (const bool half : {false, true}) {
        int number = 0;
        for (View (*make)() : {crates, yard, rocks}) {
            View view = make();
            const Difference found = againstRays(view, half);
            RecordProperty((half ? "half " : "full ") + std::to_string(number), std::to_string(found.rms) + ", mean " + std::to_string(found.mean));
            EXPECT_LE(found.rms, half ? 0.11 : 0.08) << number << " mean " << found.mean;
            ++number;
        }
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Occlusion, AnOpenPlaneHasNone)
{
    test::TestWorld world = floorOnly();
    for (const bool half : {false, true})
        for (const float pitch : {-90.0f, -60.0f, -30.0f, -10.0f}) {
            const std::vector<double> shown = occlusion(world, {.eye = {0, 3, 0}, .pitch = pitch}, half);
            EXPECT_GE(*std::ranges::min_element(shown), 0.99) << pitch << " " << half;
        }
}

TEST(Occlusion, ACornerHidesHalf)
{
    test::TestWorld world = floorOnly(1.5f);
    addBox(world, "wall", {40, 20, 1}, {.position = {0, 0, -5.5}}); // its face at z = -5
    const io::Camera camera{.eye = {0, 2.2, -2.2}, .pitch = -35, .fov = 70};
    for (const bool half : {false, true}) {
        const std::vector<double> shown = occlusion(world, camera, half);
        const auto at = [&](const glm::dvec3& place) {
            const auto pixel = renderer::project(camera, kSize, place);
            return shown[std::size_t(pixel->y) * std::size_t(kSize.x) + std::size_t(pixel->x)];
        };
        EXPECT_NEAR(at({0, 0, -4.97}), 0.5, 0.08) << half;
        EXPECT_NEAR(at({0, 0.03, -5}), 0.5, 0.08) << half;
        EXPECT_GE(at({0, 0, -3.1}), 0.97) << half; // beyond the radius
        EXPECT_GE(at({0, 1.9, -5}), 0.97) << half;
    }
}

TEST(Occlusion, NothingDarkensWhatIsFarBehind)
{
    test::TestWorld world = floorOnly();
    addBox(world, "post", {4, 4, 4}, {.position = {0, 26, 0}});
    const io::Camera camera{.eye = {0, 45, 0}, .pitch = -90};
    for (const bool half : {false, true}) {
        const std::vector<double> shown = occlusion(world, camera, half);
        const std::vector<std::uint32_t> ids = test::shared().readIds({0, 0}, kSize);
        const std::uint32_t post = ids[std::size_t(kSize.y / 2 * kSize.x + kSize.x / 2)];
        int count = 0;
        for (int y = 4; y < kSize.y - 4; ++y)
            for (int x = 4; x < kSize.x - 4; ++x) {
                const auto at = [&](int dx, int dy) { return ids[std::size_t((y + dy) * kSize.x + x + dx)] == post; };
                const bool near = at(3, 0) || at(-3, 0) || at(0, 3) || at(0, -3);
                if (!near || at(0, 0) || at(2, 0) || at(-2, 0) || at(0, 2) || at(0, -2)) continue;
                ++count;
                EXPECT_GE(shown[std::size_t(y * kSize.x + x)], 0.95) << x << " " << y << " " << half;
            }
        EXPECT_GT(count, 50);
    }
}

TEST(Occlusion, TheSkyHasNone)
{
    View view = crates();
    view.camera.pitch = 5;
    const std::vector<double> shown = occlusion(view.world, view.camera, true);
    const std::vector<std::uint32_t> ids = test::shared().readIds({0, 0}, kSize);
    int sky = 0;
    for (std::size_t i = 0; i < shown.size(); ++i)
        if (ids[i] == 0) {
            ++sky;
            EXPECT_EQ(shown[i], 1);
        }
    EXPECT_GT(sky, 3000);
}

// A wall with a shallow relief, looked at straight: a step aside by what one pixel shows moves the picture by a pixel. At half
// the resolution other places are looked at after each odd step, so there two pixels are taken.
TEST(Occlusion, HardlyChangesWhenThePictureShifts)
{
    for (const bool half : {false, true}) {
        test::TestWorld world = emptyWorld(1);
        addBox(world, "wall", {60, 60, 1}, {.position = {0, -30, -20.5}});
        std::mt19937 random{6};
        std::uniform_real_distribution<double> place{-9, 9};
        for (int i = 0; i < 120; ++i)
            addBox(world, "tile", {1, 1, 0.3f}, {.position = {place(random), place(random) * 0.6, -19.9}});
        io::Camera camera{.eye = {0, 0, 0}, .fov = 40};
        const std::vector<double> before = occlusion(world, camera, half);
        const int pixels = half ? 2 : 1;
        camera.eye.x = pixels * 20 * 2 * std::tan(glm::radians(20.0)) / kSize.y;
        const std::vector<double> after = occlusion(world, camera, half);
        std::vector<double> changes;
        for (int y = 4; y < kSize.y - 4; ++y)
            for (int x = 8; x < kSize.x - 8; ++x)
                changes.push_back(std::abs(before[std::size_t(y * kSize.x + x + pixels)] - after[std::size_t(y * kSize.x + x)]));
        std::ranges::sort(changes);
        const double p99 = changes[changes.size() * 99 / 100];
        RecordProperty(half ? "half" : "full", std::to_string(p99 * 255));
        EXPECT_LE(p99 * 255, half ? 16 : 4);
    }
}

TEST(Occlusion, RadiusAndStrengthTakeEffectAtOnce)
{
    View view = crates();
    const auto mean = [&](float radius, float strength, bool on) {
        io::Environment e = view.world.scene.environment();
        e.occlusion = {.radius = radius, .strength = strength};
        view.world.scene.exchange(e);
        test::shared().update(view.world.scene, view.world.assets, {.environment = true});
        renderer::FrameInput in = test::frame(kSize, view.camera);
        in.show = renderer::Show::Ao;
        in.settings.ao = on;
        test::shared().render(in);
        const io::Image image = test::shared().readPicture();
        double sum = 0;
        for (int i = 0; i < kSize.x * kSize.y; ++i)
            sum += image.row<glm::u8vec4>(0)[i].x;
        return sum / (255.0 * kSize.x * kSize.y);
    };
    test::load(view.world);
    const double usual = mean(2, 1, true);
    EXPECT_LT(usual, 0.97);
    EXPECT_GT(mean(0.5f, 1, true), usual + 0.02);
    EXPECT_LT(mean(2, 2, true), usual - 0.02);
    EXPECT_EQ(mean(2, 0, true), 1);
    EXPECT_EQ(mean(2, 1, false), 1);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// It takes from the sky's light and from nothing else.
TEST(Occlusion, TheSunShinesInWhole)
{
    View view = yard();
    io::Environment e = view.world.scene.environment();
    e.sky.ambient = 0;
    view.world.scene.exchange(e);
    test::load(view.world);
    renderer::FrameInput in = test::frame(kSize, view.camera);
    const auto radiance = [&](bool on) {
        in.settings.ao = on;
        test::shared().render(in);
        return test::shared().readRadiance();
    };
    EXPECT_EQ(radiance(true).bytes, radiance(false).bytes);
}

} // namespace
