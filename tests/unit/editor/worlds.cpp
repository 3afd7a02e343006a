#include "tests/unit/editor/worlds.h"

#include "io/files/scene_file.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace test {
namespace {

void finish(io::Model& model, io::Material material)
{
    for (const io::Vertex& vertex : model.vertices)
        model.bounds.add(vertex.position);
    model.parts = {{.firstIndex = 0, .indexCount = std::uint32_t(model.indices.size()), .material = 0}};
    model.materials = {std::move(material)};
}

} // namespace

io::Model pyramid(float size, bool doubleSided)
{
    io::Model model;
    const float h = size / 2;
    for (const glm::vec3 p : {glm::vec3{-h, 0, -h}, {h, 0, -h}, {h, 0, h}, {-h, 0, h}, {0, size, 0}})
        model.vertices.push_back({.position = p});
    model.indices = {0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4};
    finish(model, {.doubleSided = doubleSided});
    return model;
}

io::Model blob(float radius, int rings)
{
    io::Model model;
    const int sides = rings * 2;
    for (int ring = 0; ring <= rings; ++ring) {
        for (int side = 0; side <= sides; ++side) {
            const float polar = glm::pi<float>() * float(ring) / float(rings);
            const float around = glm::two_pi<float>() * float(side) / float(sides);
            const glm::vec3 unit{std::sin(polar) * std::cos(around), std::cos(polar),
                                 std::sin(polar) * std::sin(around)};
            model.vertices.push_back(
                {.position = unit * radius * (1 + 0.2f * std::sin(5 * around)) + glm::vec3{0, radius, 0}});
        }
    }
    for (int ring = 0; ring < rings; ++ring)
        for (int side = 0; side < sides; ++side) {
            const auto a = std::uint32_t(ring * (sides + 1) + side), b = a + 1, c = a + std::uint32_t(sides) + 1,
                       d = c + 1;
            for (const std::uint32_t i : {a, b, c, b, d, c})
                model.indices.push_back(i);
        }
    finish(model, {});
    return model;
}

io::Model leafCard(float size)
{
    io::Model model;
    for (int card = 0; card < 2; ++card) {
        const glm::vec3 side = card == 0 ? glm::vec3{1, 0, 0} : glm::vec3{0, 0, 1};
        const auto first = std::uint32_t(model.vertices.size());
        for (const glm::vec2 corner : {glm::vec2{0, 0}, {1, 0}, {1, 1}, {0, 1}})
            model.vertices.push_back(
                {.position = side * (corner.x - 0.5f) * size + glm::vec3{0, corner.y * size, 0}, .uv0 = corner});
        for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u})
            model.indices.push_back(first + i);
    }
    auto image = std::make_shared<io::Image>();
    image->size = {64, 64};
    image->bytes.resize(64 * 64 * 4, std::byte{255});
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            if (glm::distance(glm::vec2{x, y}, glm::vec2{32}) > 20) image->row<std::uint8_t>(y)[x * 4 + 3] = 0;
    finish(model, {.alphaMode = io::AlphaMode::Mask, .doubleSided = true, .baseColourTexture = {.image = 0}});
    model.images = {image};
    return model;
}

std::shared_ptr<const io::HeightMap> hills(int size, double metresPerTexel, std::uint64_t seed)
{
    io::HeightGrid grid{.size = {size, size}, .metresPerTexel = metresPerTexel, .origin = glm::dvec2{-0.5 * (size - 1) * metresPerTexel}};
    editor::Random random{seed};
    const double phase = random.in(0, 10);
    for (int z = 0; z < size; ++z)
        for (int x = 0; x < size; ++x)
            grid.metres.push_back(float(12 * std::sin(x * 0.09 + phase) * std::cos(z * 0.07) + random.in(0, 1.5)));
    return std::make_shared<const io::HeightMap>(grid);
}

std::shared_ptr<const io::HeightMap> flat(int size, float height)
{
    return std::make_shared<const io::HeightMap>(io::HeightGrid{.size = {size, size},
                                                                .metres = std::vector<float>(std::size_t(size) * size, height),
                                                                .origin = glm::dvec2{-0.5 * (size - 1)}});
}

io::Transform randomTransform(editor::Random& random, double extent)
{
    io::Transform transform;
    transform.position = {random.in(-extent, extent), random.in(0, 20), random.in(-extent, extent)};
    transform.rotation = {float(random.in(-60, 60)), float(random.in(-180, 180)), float(random.in(-60, 60))};
    transform.scale = glm::vec3{float(random.in(0.5, 2)), float(random.in(0.5, 2)), float(random.in(0.5, 2))};
    return transform;
}

std::unique_ptr<editor::Document> forest(int count, std::uint64_t seed, bool withGround)
{
    io::World world;
    world.entry = {.name = "test", .file = "scenes/test.scene.json"};
    io::Assets assets;
    const auto add = [&](const char* name, io::Model model) {
        world.scene.exchange(world.scene.templateSlot(name), io::Template{.name = name});
        assets.models.push_back(std::make_shared<const io::Model>(std::move(model)));
    };
    add("pyramid", pyramid(6));
    add("blob", blob(4, 8));
    add("leaf", leafCard(8));
    add("marker", io::boxModel(glm::vec3{2}, glm::vec4{1}));
    editor::Random random{seed};
    world.scene.reserve(std::size_t(count));
    for (int i = 0; i < count; ++i)
        world.scene.exchange(world.scene.freshId(), io::Object{.templateId = io::TemplateId(1 + random.bits() % 4),
                                                               .transform = randomTransform(random, 200)});
    world.scene.exchange(std::vector<io::Camera>{{.name = "Lookout", .eye = {0, 60, 200}, .pitch = -15}});
    if (withGround) world.scene.exchange(hills(257, 2, seed));
    return std::make_unique<editor::Document>(std::move(world), std::move(assets));
}

editor::Picker& followed(editor::Picker& picker, editor::Document& document)
{
    picker.update(document.scene(), document.assets(), document.takeChanges());
    return picker;
}

std::string text(const io::Scene& scene)
{
    return io::sceneText(scene, "environments/test.json");
}

} // namespace test
