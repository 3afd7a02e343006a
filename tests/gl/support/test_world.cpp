#include "tests/gl/support/test_world.h"

#include <cmath>
#include <functional>
#include <random>

namespace test {
namespace {

double noiseAt(int x, int z)
{
    unsigned h = unsigned(x) * 0x8da6b343u ^ unsigned(z) * 0xd8163841u;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return double(h ^ (h >> 15)) / 4294967295.0;
}

double smoothNoise(double x, double z)
{
    const double cx = std::floor(x), cz = std::floor(z);
    const double u = x - cx, v = z - cz;
    const double su = u * u * (3 - 2 * u), sv = v * v * (3 - 2 * v);
    const int ix = int(cx), iz = int(cz);
    return glm::mix(glm::mix(noiseAt(ix, iz), noiseAt(ix + 1, iz), su), glm::mix(noiseAt(ix, iz + 1), noiseAt(ix + 1, iz + 1), su), sv);
}

std::shared_ptr<const io::Image> picture(int side, const std::function<glm::vec4(double u, double v)>& colour)
{
    auto image = std::make_shared<io::Image>();
    image->size = glm::ivec2{side};
    image->bytes.resize(std::size_t(side) * side * 4);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            image->row<glm::u8vec4>(y)[x] = glm::u8vec4{glm::clamp(colour((x + 0.5) / side, (y + 0.5) / side), 0.0f, 1.0f) * 255.0f};
    return image;
}

// Grain that tiles, around a mean colour.
std::shared_ptr<const io::Image> ground(const glm::vec3& mean, double strength, int cells)
{
    return picture(256, [=](double u, double v) {
        double sum = 0, weight = 0.5;
        for (int octave = 1; octave <= 4; ++octave) {
            const int n = cells << octave;
            const auto at = [&](int x, int z) { return noiseAt((x % n + n) % n + octave * 977, (z % n + n) % n); };
            const double x = u * n, z = v * n;
            const int ix = int(x), iz = int(z);
            const double fu = x - ix, fv = z - iz;
            sum += weight * (glm::mix(glm::mix(at(ix, iz), at(ix + 1, iz), fu), glm::mix(at(ix, iz + 1), at(ix + 1, iz + 1), fu), fv) - 0.5);
            weight *= 0.7;
        }
        return glm::vec4{mean * float(1 + strength * sum), 1};
    });
}

void addQuad(io::Model& model, const glm::vec3 (&corners)[4], const glm::vec3& normal, float repeatV)
{
    const auto first = std::uint32_t(model.vertices.size());
    const glm::vec2 uvs[4] = {{0, repeatV}, {1, repeatV}, {1, 0}, {0, 0}};
    for (int i = 0; i < 4; ++i)
        model.vertices.push_back({.position = corners[i],
                                  .normal = normal,
                                  .tangent = {glm::normalize(corners[1] - corners[0]), 1},
                                  .uv0 = uvs[i]});
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u})
        model.indices.push_back(first + i);
}

void addLayers(io::Terrain& terrain, io::Assets& assets)
{
    terrain.layers = {{.name = "grass", .texture = "grass", .colour = glm::vec3{1}, .metres = 5},
                      {.name = "meadow", .texture = "meadow", .metres = 7, .altitude = {-1e5f, 38}, .blend = 0.6f},
                      {.name = "earth", .texture = "earth", .metres = 4, .slope = {20, 90}, .blend = 0.5f},
                      {.name = "rock", .texture = "rock", .roughness = 0.85f, .metres = 9, .slope = {31, 90}, .blend = 0.4f}};
    const std::shared_ptr<const io::Image> images[] = {ground({0.27f, 0.37f, 0.14f}, 0.9, 8), ground({0.42f, 0.45f, 0.2f}, 0.8, 6),
                                                       ground({0.38f, 0.3f, 0.2f}, 0.9, 8), ground({0.45f, 0.43f, 0.4f}, 0.9, 5)};
    for (const auto& image : images)
        assets.layers.push_back({.colour = image});
}

} // namespace

double hills(double x, double z)
{
    double sum = 0, size = 190, height = 95;
    for (int octave = 0; octave < 6; ++octave) {
        const double n = smoothNoise(x / size + octave * 17.3, z / size - octave * 9.1);
        sum += height * (octave == 0 ? n * n * 1.6 : n - 0.5);
        size *= 0.47;
        height *= 0.4;
    }
    return sum;
}

std::shared_ptr<const io::HeightMap> heightMap(glm::ivec2 size, double metresPerTexel, double (*height)(double, double))
{
    io::HeightGrid grid{.size = size, .metresPerTexel = metresPerTexel, .origin = -glm::dvec2{size - 1} * metresPerTexel * 0.5};
    for (int z = 0; z < size.y; ++z)
        for (int x = 0; x < size.x; ++x)
            grid.metres.push_back(float(height(grid.origin.x + x * metresPerTexel, grid.origin.y + z * metresPerTexel)));
    return std::make_shared<const io::HeightMap>(grid);
}

std::shared_ptr<const io::Model> box(const glm::vec3& size, const glm::vec4& colour)
{
    return std::make_shared<io::Model>(io::boxModel(size, colour));
}

std::shared_ptr<const io::Model> treeModel()
{
    auto model = std::make_shared<io::Model>();
    model->name = "tree";
    for (int side = 0; side < 6; ++side) {
        const auto at = [&](int i, float y, float r) {
            const double a = i * 6.2831853 / 6;
            return glm::vec3{float(std::cos(a)) * r, y, float(std::sin(a)) * r};
        };
        const glm::vec3 normal = glm::normalize(at(side, 0, 1) + at(side + 1, 0, 1));
        addQuad(*model, {at(side + 1, 0, 0.28f), at(side, 0, 0.28f), at(side, 4.5f, 0.14f), at(side + 1, 4.5f, 0.14f)}, normal, 3);
    }
    const auto trunk = std::uint32_t(model->indices.size());
    std::mt19937 random{7};
    std::uniform_real_distribution<float> unit{-1, 1};
    const glm::vec3 crown{0, 5.2f, 0};
    for (int card = 0; card < 130; ++card) {
        glm::vec3 direction{unit(random), unit(random), unit(random)};
        direction = glm::normalize(direction);
        const glm::vec3 centre = crown + direction * glm::vec3{2.1f, 2.6f, 2.1f} * (0.55f + 0.45f * std::abs(unit(random)));
        const glm::vec3 u = glm::normalize(glm::vec3{unit(random), unit(random) * 0.4f, unit(random)}) * 0.75f;
        const glm::vec3 v = glm::normalize(glm::cross(u, glm::vec3{unit(random), unit(random), unit(random)})) * 0.75f;
        addQuad(*model, {centre - u - v, centre + u - v, centre + u + v, centre - u + v}, glm::normalize(centre - crown), 1);
    }
    model->parts = {{.firstIndex = 0, .indexCount = trunk, .material = 0},
                    {.firstIndex = trunk, .indexCount = std::uint32_t(model->indices.size()) - trunk, .material = 1}};
    model->materials = {{.name = "bark", .metallic = 0, .roughness = 0.95f, .baseColourTexture = {.image = 0}},
                        {.name = "leaves", .metallic = 0, .roughness = 0.8f, .alphaMode = io::AlphaMode::Mask, .doubleSided = true, .baseColourTexture = {.image = 1}}};
    model->images = {ground({0.3f, 0.23f, 0.17f}, 0.9, 4), picture(128, [](double u, double v) {
                         double cover = 0, shade = 0.6;
                         for (int leaf = 0; leaf < 26; ++leaf) {
                             const double x = 0.1 + 0.8 * noiseAt(leaf, 3), y = 0.1 + 0.8 * noiseAt(leaf, 5), a = noiseAt(leaf, 9) * 6.28;
                             const double dx = (u - x) * std::cos(a) + (v - y) * std::sin(a), dy = (v - y) * std::cos(a) - (u - x) * std::sin(a);
                             const double inside = 1 - std::hypot(dx / 0.085, dy / 0.04);
                             if (inside > -0.15) cover = 1, shade = 0.65 + 0.35 * noiseAt(leaf, 21);
                         }
                         return glm::vec4{0.25 * shade, 0.38 * shade, 0.11 * shade, cover};
                     })};
    for (const io::Vertex& vertex : model->vertices)
        model->bounds.add(vertex.position);
    return model;
}

io::TemplateId addTemplate(TestWorld& world, const std::string& name, std::shared_ptr<const io::Model> model)
{
    const io::TemplateId id = world.scene.templateSlot(name);
    world.scene.exchange(id, io::Template{.name = name, .model = "models/" + name + ".glb"});
    world.assets.models.resize(world.scene.templates().size());
    world.assets.models[io::number(id) - 1] = std::move(model);
    return id;
}

io::ObjectId addObject(TestWorld& world, io::TemplateId id, const io::Transform& transform)
{
    const io::ObjectId object = world.scene.freshId();
    world.scene.exchange(object, io::Object{.id = object, .templateId = id, .transform = transform});
    return object;
}

TestWorld makeWorld(const WorldOptions& options)
{
    TestWorld world;
    io::Terrain terrain;
    if (options.heightMap.x > 0) {
        terrain.heightMap = "terrain/hills.png";
        world.scene.exchange(heightMap(options.heightMap, options.metresPerTexel, hills));
        addLayers(terrain, world.assets);
    }
    world.scene.exchange(std::move(terrain));
    const io::TemplateId tree = addTemplate(world, "tree", treeModel());
    const io::TemplateId block = addTemplate(world, "block", box({3, 2, 2}, {0.5f, 0.46f, 0.42f, 1}));

    std::mt19937 random{42};
    std::uniform_real_distribution<double> place{-240, 240}, turn{0, 360}, size{0.7, 1.7};
    for (int i = 0; i < options.trees + options.boxes; ++i) {
        io::Transform t;
        t.position = {place(random), 0, place(random)};
        t.position.y = world.scene.heights() ? world.scene.heights()->height(t.position.x, t.position.z).value_or(0) : 0;
        t.rotation.y = float(turn(random));
        t.scale = glm::vec3{float(size(random))};
        addObject(world, i < options.trees ? tree : block, t);
    }
    return world;
}

} // namespace test
