#include "tests/support/small_world.h"

#include "io/files/image_file.h"
#include "io/files/png_file.h"
#include "io/files/model_file.h"
#include "io/files/project.h"

namespace test {
namespace fs = std::filesystem;
namespace {

constexpr int kSide = 65; // texels, 1 m apart

template <class T> T must(io::Result<T> result)
{
    EXPECTS(result);
    return *std::move(result);
}

void write(const fs::path& file, std::string_view bytes)
{
    fs::create_directories(file.parent_path());
    EXPECTS(io::writeFile(file, bytes));
}

io::Image heights()
{
    io::Image image{.size = {kSide, kSide}, .channels = 1, .type = io::PixelType::U16};
    image.bytes.resize(image.rowBytes() * kSide);
    for (int z = 0; z < kSide; ++z)
        for (int x = 0; x < kSide; ++x) {
            const float up = 1 - glm::distance(glm::vec2{x, z}, glm::vec2{12, 12}) / 12;
            image.row<std::uint16_t>(z)[x] = std::uint16_t(glm::max(up, 0.0f) * 65535);
        }
    return image;
}

void addTemplate(io::World& world, io::Template value)
{
    const io::TemplateId id = world.scene.templateSlot(value.name);
    world.project.templates.push_back(value.name);
    world.scene.exchange(id, std::move(value));
}

void addObject(io::World& world, const char* of, glm::dvec3 position)
{
    const io::ObjectId id = world.scene.freshId();
    io::Object object{.id = id, .templateId = world.scene.findTemplate(of)};
    object.transform.position = position;
    world.scene.exchange(id, object);
}

} // namespace

void makeSmallWorld(const fs::path& folder)
{
    io::World world{
        .project = {.folder = folder, .name = "Small", .scenes = {{"main", "scenes/main.scene.json"}}, .start = "main"},
        .entry = {"main", "scenes/main.scene.json"},
        .environmentFile = "environments/day.json"};
    addTemplate(world, {.name = "crate", .category = "Things", .model = "models/crate.glb", .yaw = {0, 0}});
    addTemplate(world, {.name = "post", .category = "Markers", .markerSize = {0.5f, 2, 0.5f}, .yaw = {0, 0}});
    for (int i = 0; i < 5; ++i)
        addObject(world, "crate", {4 * (i - 2), 0, 0});
    addObject(world, "post", {0, 0, -8});
    io::Terrain terrain{.heightMap = "terrain/ground.png", .origin = {-32, -32}, .maxHeight = 12};
    terrain.layers.push_back({.name = "grass", .colour = {0.10f, 0.18f, 0.05f}});
    world.scene.exchange(terrain);
    world.scene.exchange(std::vector<io::Camera>{{.name = "front", .eye = {0, 4, 16}, .pitch = -8}});
    world.scene.exchange(
        std::vector<io::CameraPath>{{.name = "flight", .keys = {{0, {0, 4, 16}, 0, -8}, {1, {6, 5, 16}, 20, -10}}}});
    write(folder / "models/crate.glb", must(io::encodeGlb(io::boxModel(glm::vec3{2}, {0.6f, 0.35f, 0.15f, 1}))));
    write(folder / "terrain/ground.png", must(io::encodePng(heights())));
    EXPECTS(io::saveWorld(world));
}

} // namespace test
