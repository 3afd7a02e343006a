#include "projects/make/stage.h"

#include "io/base/contract.h"
#include "io/files/height_map_file.h"
#include "io/files/image_file.h"
#include "io/files/model_file.h"
#include "projects/make/terrain_forms.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace fs = std::filesystem;
namespace {

constexpr float kSquare = 8; // m

double rounded(double value, double step)
{
    const double inverse = std::round(1 / step); // x / 1000 has a shorter text than x * 0.001
    return std::round(value * inverse) / inverse;
}

glm::dquat leaning(const glm::dvec3& up)
{
    const glm::dvec3 axis = glm::cross(glm::dvec3{0, 1, 0}, up);
    return glm::normalize(glm::dquat{1 + up.y, axis.x, axis.y, axis.z});
}

io::Image shrunk(const io::Image& image, int side)
{
    io::Image small = image;
    while (small.size.x > side) {
        io::Image half;
        half.size = small.size / 2;
        half.channels = small.channels;
        half.bytes.resize(std::size_t(half.size.x) * half.size.y * half.channels);
        for (int y = 0; y < half.size.y; ++y)
            for (int x = 0; x < int(half.rowBytes()); ++x) {
                const int c = x % half.channels, column = (x / half.channels) * 2 * half.channels + c;
                const auto *above = small.row<std::uint8_t>(2 * y), *below = small.row<std::uint8_t>(2 * y + 1);
                const int sum =
                    above[column] + above[column + half.channels] + below[column] + below[column + half.channels];
                half.row<std::uint8_t>(y)[x] = std::uint8_t((sum + 2) / 4);
            }
        small = std::move(half);
    }
    return small;
}

float groundAt(const Stage& stage, glm::vec3 p)
{
    return heightAt(stage.heights(), {p.x, p.z});
}

} // namespace

Stage::Stage(fs::path folder, std::string name, io::HeightGrid heights, Textures& textures)
    : m_heights{std::move(heights)}, m_textures{textures}
{
    m_world.project = {.folder = std::move(folder),
                       .name = std::move(name),
                       .scenes = {{.name = "main", .file = "scenes/main.scene.json"}},
                       .start = "main"};
    m_world.entry = m_world.project.scenes.front();
    m_world.environmentFile = "environments/main.json";
}

void Stage::addModels(std::span<const Entry> entries)
{
    for (const Entry& entry : entries) {
        const io::Model model = buildModel(entry.name, m_textures);
        io::Result<std::string> bytes = io::encodeGlb(model);
        EXPECTS(bool(bytes));
        io::Template what = templateOf(entry);
        m_models[what.model] = std::move(*bytes);
        // Whoever places a copy puts the bottom of its bounds on the ground; roots reach below that.
        what.sink = float(rounded(what.sink - std::min(0.0f, model.bounds.min.y), 0.01));
        m_depths[what.name] = model.bounds.min.y;
        m_world.scene.exchange(m_world.scene.templateSlot(what.name), what);
        m_world.project.templates.push_back(what.name);
    }
}

void Stage::addMarker(const std::string& name, glm::vec3 size, bool casts)
{
    m_world.scene.exchange(m_world.scene.templateSlot(name), io::Template{.name = name,
                                                                          .category = "Markers",
                                                                          .markerSize = size,
                                                                          .collision = io::Collision::None,
                                                                          .castShadow = casts});
    m_depths[name] = 0;
    m_world.project.templates.push_back(name);
}

void Stage::addParticles(const std::string& name, const std::string& category, const io::ParticleSource& particles)
{
    m_world.scene.exchange(m_world.scene.templateSlot(name), io::Template{.name = name,
                                                                          .category = category,
                                                                          .markerSize = {0.3f, 0.3f, 0.3f},
                                                                          .collision = io::Collision::None,
                                                                          .castShadow = false,
                                                                          .particles = particles});
    m_depths[name] = 0;
    m_world.project.templates.push_back(name);
}

void Stage::addSound(const std::string& name, const io::SoundSource& sound)
{
    m_world.scene.exchange(m_world.scene.templateSlot(name), io::Template{.name = name,
                                                                          .category = "Sounds",
                                                                          .markerSize = {0.3f, 0.3f, 0.3f},
                                                                          .collision = io::Collision::None,
                                                                          .footprintShape = io::Footprint::None,
                                                                          .castShadow = false,
                                                                          .sound = sound});
    m_depths[name] = 0;
    m_world.project.templates.push_back(name);
}

void Stage::edit(std::string_view name, const std::function<void(io::Template&)>& change)
{
    const io::TemplateId id = m_world.scene.findTemplate(name);
    EXPECTS(m_world.scene.find(id) != nullptr);
    io::Template what = *m_world.scene.find(id);
    change(what);
    m_world.scene.exchange(id, std::move(what));
}

io::ObjectId Stage::addGroup(const std::string& name, glm::vec2 at)
{
    const io::ObjectId id = m_world.scene.freshId();
    io::Object group{.name = name};
    group.transform.position = {rounded(at.x, 0.001), rounded(heightAt(m_heights, at), 0.001), rounded(at.y, 0.001)};
    m_world.scene.exchange(id, std::move(group));
    return id;
}

io::Transform Stage::placed(const Put& put, const io::Template& what, Random& random) const
{
    const float yaw = put.yaw.value_or(random.range(what.yaw.x, what.yaw.y));
    const float scale = put.scale.value_or(random.range(what.scale.x, what.scale.y));
    const double lean = glm::radians(double(random.range(0, what.tilt)));
    const double towards = random.range(0, 6.2831853f);
    const glm::dvec3 normal = m_heights.normal(put.at.x, put.at.y).value_or(glm::dvec3{0, 1, 0});
    const glm::dvec3 up = what.alignToGround ? normal : glm::dvec3{0, 1, 0};
    const glm::dquat turn = leaning(up) * glm::angleAxis(lean, glm::dvec3{std::cos(towards), 0, std::sin(towards)}) *
                            glm::angleAxis(glm::radians(double(yaw)), glm::dvec3{0, 1, 0});
    io::Transform result;
    const glm::vec3 degrees = io::eulerDegrees(turn);
    for (int axis = 0; axis < 3; ++axis)
        result.rotation[axis] = float(rounded(degrees[axis], 0.1));
    result.scale = glm::vec3{float(rounded(scale, 0.01))};
    const double depth = double(m_depths.find(put.what)->second) * result.scale.y;
    const glm::dvec3 ground{put.at.x, heightAt(m_heights, put.at) + put.lift, put.at.y};
    const glm::dvec3 position =
        ground - io::orientation(result.rotation) * glm::dvec3{0, depth, 0} - up * double(what.sink);
    for (int axis = 0; axis < 3; ++axis)
        result.position[axis] = rounded(position[axis], 0.001);
    return result;
}

io::ObjectId Stage::put(const Put& put, Random& random)
{
    const io::TemplateId id = m_world.scene.findTemplate(put.what);
    const io::Template* what = m_world.scene.find(id);
    EXPECTS(what != nullptr);
    const io::ObjectId fresh = m_world.scene.freshId();
    m_world.scene.exchange(fresh, io::Object{.id = fresh,
                                             .templateId = id,
                                             .transform = placed(put, *what, random),
                                             .parent = put.parent,
                                             .name = put.name});
    return fresh;
}

void Stage::addLayer(io::ScatterLayer layer)
{
    EXPECTS(m_planted.empty());
    layer.id = m_world.scene.freshScatterId();
    m_layer = std::move(layer);
}

void Stage::plant(const Put& put, Random& random)
{
    const io::Template* what = m_world.scene.find(m_world.scene.findTemplate(put.what));
    EXPECTS(what != nullptr);
    const auto species = std::ranges::find(m_layer.species, put.what, &io::Species::templateName);
    EXPECTS(species != m_layer.species.end());
    const io::PlacedInstance one = io::instanceAt(placed(put, *what, random), int(species - m_layer.species.begin()), io::kPaintedInstance);
    m_planted[one.tile].instances.push_back(one.instance);
}

bool Stage::isFree(glm::vec2 at, float radius) const
{
    constexpr int kReach = 2; // squares: nothing takes more than a radius of 8 m
    const glm::ivec2 home{glm::floor(at / kSquare)};
    for (int z = home.y - kReach; z <= home.y + kReach; ++z)
        for (int x = home.x - kReach; x <= home.x + kReach; ++x) {
            const auto found = m_taken.find({x, z});
            if (found == m_taken.end()) continue;
            for (const glm::vec3& other : found->second)
                if (glm::length(at - glm::vec2{other.x, other.y}) < radius + other.z) return false;
        }
    return true;
}

void Stage::take(glm::vec2 at, float radius)
{
    const glm::ivec2 square{glm::floor(at / kSquare)};
    m_taken[{square.x, square.y}].push_back({at, radius});
}

std::size_t Stage::count(std::string_view what) const
{
    const io::TemplateId id = m_world.scene.findTemplate(what);
    return std::size_t(std::ranges::count(m_world.scene.objects(), id, &io::Object::templateId));
}

void Stage::setViews(std::vector<io::Camera> cameras, std::vector<io::CameraPath> paths)
{
    m_world.scene.exchange(std::move(cameras));
    m_world.scene.exchange(std::move(paths));
}

void Stage::setGrass(io::Grass grass, io::TexelTiles<std::uint32_t> texels)
{
    m_world.scene.exchange(std::make_shared<const io::GrassMap>(std::move(texels), grass.metresPerTexel, grass.origin));
    m_world.scene.exchange(std::move(grass));
}

io::Status Stage::addGround(std::vector<io::TerrainLayer> layers, int side, double minHeight, double maxHeight)
{
    const fs::path& folder = m_world.project.folder;
    std::error_code error;
    fs::create_directories(folder / "terrain", error);
    fs::create_directories(folder / "textures", error);
    io::Terrain terrain{.heightMap = "terrain/heights.png",
                        .metresPerTexel = m_heights.metresPerTexel,
                        .origin = m_heights.origin,
                        .minHeight = minHeight,
                        .maxHeight = maxHeight};
    if (io::Status written = io::writeHeightMap16(folder / terrain.heightMap, m_heights, minHeight, maxHeight);
        !written)
        return written;
    for (io::TerrainLayer& layer : layers) {
        const Texture& texture = m_textures.get(layer.texture);
        const std::string stem = "textures/" + layer.texture;
        layer.texture = stem + ".jpg";
        layer.normalTexture = stem + "_normal.jpg";
        if (io::Status written = io::writeImage(folder / layer.texture, shrunk(*texture.colour, side), 85); !written)
            return written;
        if (io::Status written = io::writeImage(folder / layer.normalTexture, shrunk(*texture.normal, side), 75);
            !written)
            return written;
    }
    terrain.layers = std::move(layers);
    m_world.scene.exchange(std::move(terrain));
    return {};
}

io::Status Stage::save()
{
    std::error_code error;
    for (const char* sub : {"models", "scenes", "templates", "environments"})
        fs::create_directories(m_world.project.folder / sub, error);
    for (const auto& [file, bytes] : m_models)
        if (io::Status written = io::writeFile(m_world.project.folder / file, bytes); !written) return written;
    if (!m_planted.empty()) {
        io::InstanceTiles tiles;
        for (auto& [tile, planted] : m_planted)
            tiles[tile] = std::make_shared<const io::InstanceTile>(std::move(planted));
        m_world.scene.exchange(m_layer.id, std::move(tiles));
        m_world.scene.exchange(std::vector{m_layer});
    }
    const io::Result<io::FileTransaction::Report> saved = io::saveWorld(m_world);
    return saved ? io::Status{} : io::Status{saved.error()};
}

io::Camera cameraAt(const Stage& stage, const std::string& name, glm::vec3 eye, glm::vec3 target, float fov)
{
    const io::PathKey key = keyAt(stage, 0, eye, target, fov);
    return {.name = name, .eye = key.eye, .yaw = key.yaw, .pitch = key.pitch, .fov = fov};
}

io::PathKey keyAt(const Stage& stage, double time, glm::vec3 eye, glm::vec3 target, float fov)
{
    eye.y += groundAt(stage, eye);
    target.y += groundAt(stage, target);
    const glm::vec3 d = target - eye;
    const float yaw = glm::degrees(std::atan2(-d.x, -d.z));
    const float pitch = glm::degrees(std::atan2(d.y, glm::length(glm::vec2{d.x, d.z})));
    return {.time = time,
            .eye = {rounded(eye.x, 0.01), rounded(eye.y, 0.01), rounded(eye.z, 0.01)},
            .yaw = float(rounded(yaw, 0.1)),
            .pitch = float(rounded(pitch, 0.1)),
            .fov = fov};
}

} // namespace make
