#include "renderer/grass.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

namespace renderer {
namespace {

constexpr float kHighestFactor = 2; // of a kind's own height
constexpr double kCell = double(GRASS_CELL);
constexpr int kBlock = 16;          // texels of the map along a side, whose grass is counted together
constexpr double kSample = 8;       // m
constexpr double kInView = 0.3;     // share of what is around an eye that it sees: a quarter, and what tiles cannot tell from it
constexpr double kHalfStep = 1.0 / 1024; // of a number that is kept as a half

bool sees(const std::optional<Volume>& volume, const glm::dvec3& low, const glm::dvec3& high)
{
    if (!volume) return true;
    const glm::dvec3 centre = (low + high) * 0.5, half = high - centre;
    return std::ranges::all_of(volume->planes, [&](const glm::dvec4& p) {
        return glm::dot(glm::dvec3{p}, centre) + p.w + glm::dot(glm::abs(glm::dvec3{p}), half) >= 0;
    });
}

glsl::GrassKind kindOf(const io::GrassKind& k)
{
    return {.rootColour = k.rootColour,
            .groundColour = k.groundColour,
            .tipColour = k.tipColour,
            .variety = k.variety,
            .height = k.height,
            .width = k.width,
            .density = float(double(k.density) / io::kMostGrass),
            .steepness = {std::cos(glm::radians(k.slope.y)), std::cos(glm::radians(k.slope.x)) + 1e-5f},
            .altitude = k.altitude,
            .aboveWater = k.aboveWater,
            .bend = k.bend,
            .wind = k.wind,
            .clump = k.clump,
            .clumpSize = k.clumpSize};
}

} // namespace

void Grass::update(const io::Scene& scene, const io::Changes& changes)
{
    if (changes.grass || changes.everything) {
        m_kinds = scene.grass().kinds;
        if (m_kinds.size() > io::kMostGrassKinds) m_kinds.resize(io::kMostGrassKinds);
        m_tallest = 0;
        for (const io::GrassKind& kind : m_kinds)
            m_tallest = std::max({m_tallest, kind.height.x, kind.height.y});
    }
    if (changes.grass || changes.everything || !changes.templates.empty()) {
        m_plants.clear();
        for (const io::GrassKind& kind : m_kinds)
            m_plants.push_back(kind.plant.empty() ? io::TemplateId::None : scene.findTemplate(kind.plant));
    }
    const auto before = std::exchange(m_map, scene.grassMap());
    if (m_map && (changes.grass || changes.everything)) measure(m_map->field().rect());
    if (m_map == before) return;
    if (!m_map) {
        m_texels = {};
        return;
    }
    const bool another = !before || before->size() != m_map->size() || changes.everything;
    if (another) m_texels = gl::Texture{{.label = "grass", .size = m_map->size(), .filter = GL_NEAREST}};
    const std::vector<io::TexelRect> all{m_map->field().rect()};
    for (const io::TexelRect& changed : another ? all : changes.grassMap) {
        const io::TexelRect rect = common(changed, m_map->field().rect());
        if (rect.empty()) continue;
        measure(rect);
        const std::vector<std::uint32_t> rows = m_map->field().read(rect);
        m_texels.uploadPart(glm::ivec2{rect.low}, glm::ivec2{rect.high - rect.low}, rows.data(), GL_RGBA, GL_UNSIGNED_BYTE);
    }
}

// The blocks that hold those texels.
void Grass::measure(const io::TexelRect& texels)
{
    const io::TexelTiles<std::uint32_t>& field = m_map->field();
    m_blocks = (m_map->size() + kBlock - 1) / kBlock;
    m_dense.resize(std::size_t(m_blocks.x) * std::size_t(m_blocks.y));
    for (int z = int(texels.low.y) / kBlock; z * kBlock < texels.high.y; ++z)
        for (int x = int(texels.low.x) / kBlock; x * kBlock < texels.high.x; ++x) {
            const io::Texel low = io::Texel{x, z} * std::int64_t(kBlock);
            const std::vector<std::uint32_t> block = field.read(common({low, low + io::Texel{kBlock}}, field.rect()));
            double sum = 0;
            for (const std::uint32_t bits : block) {
                const io::GrassCover cover = io::unpackedGrass(bits);
                for (int i = 0; i < 2; ++i)
                    if (std::size_t(cover.kind[i]) < m_kinds.size()) sum += double(cover.density[i] * m_kinds[std::size_t(cover.kind[i])].density);
            }
            m_dense[std::size_t(z) * std::size_t(m_blocks.x) + std::size_t(x)] = float(sum / double(io::kMostGrass) / double(block.size()));
        }
}

float Grass::kept(const Eye& eye, const Settings& settings) const
{
    const glm::dvec2 middle{eye.position.x, eye.position.z};
    const double block = m_map->metresPerTexel * kBlock, distance = double(settings.grassDistance), thinned = double(grassFullTo(settings)) * 0.75;
    const int samples = std::max(1, int(std::lround(block / kSample)));
    const double step = block / samples, places = step * step / (kCell * kCell);
    const glm::ivec2 low = glm::max(glm::ivec2{glm::floor((middle - distance - m_map->origin) / block)}, glm::ivec2{0});
    const glm::ivec2 high = glm::min(glm::ivec2{glm::floor((middle + distance - m_map->origin) / block)}, m_blocks - 1);
    double plants = 0;
    for (int z = low.y; z <= high.y; ++z)
        for (int x = low.x; x <= high.x; ++x) {
            const double dense = double(m_dense[std::size_t(z) * std::size_t(m_blocks.x) + std::size_t(x)]);
            if (dense <= 0) continue;
            for (int i = 0; i < samples * samples; ++i) {
                const glm::dvec2 at = m_map->origin + glm::dvec2{x, z} * block + (glm::dvec2{i % samples, i / samples} + 0.5) * step;
                const double away = glm::distance(at, middle);
                if (away < distance) plants += dense * places * std::min(1.0, thinned * thinned / (away * away)); // a quarter at twice as far
            }
        }
    const double seen = plants * double(settings.grassDensity) * kInView;
    return float(std::clamp(double(settings.mostBlades) / std::max(seen, 1.0), 1e-6, 1.0));
}

std::vector<glsl::GrassTile> Grass::tiles(const Terrain& terrain, const Eye& eye, const std::optional<Volume>& volume, const Settings& settings) const
{
    std::vector<glsl::GrassTile> tiles;
    const glm::dvec2 middle{eye.position.x, eye.position.z};
    const float full = grassFullTo(settings);
    for (int level = 0; level < GRASS_LEVELS; ++level) {
        const double from = double(glsl::grassFrom(level, full)), to = std::min(double(glsl::grassFrom(level + 1, full)), double(settings.grassDistance));
        if (from >= to) break;
        const double side = kCell * GRASS_TILE * (1 << level);
        const glm::ivec2 low{glm::floor((middle - to) / side)}, high{glm::floor((middle + to) / side)};
        for (int z = low.y; z <= high.y; ++z)
            for (int x = low.x; x <= high.x; ++x) {
                const glm::dvec2 corner = glm::dvec2{x, z} * side, far = corner + side;
                const glm::dvec2 nearest = glm::clamp(middle, corner, far), farthest = glm::max(glm::abs(corner - middle), glm::abs(far - middle));
                if (glm::distance(middle, nearest) > to || glm::length(farthest) < from) continue;
                const glm::vec2 heights = terrain.heightsWithin(corner, far);
                if (heights.x > heights.y) continue;
                const double tall = double(m_tallest * kHighestFactor);
                if (!sees(volume, {corner.x - tall, double(heights.x), corner.y - tall}, {far.x + tall, double(heights.y) + tall, far.y + tall})) continue;
                const glm::vec2 fromEye{double(heights.x) - eye.position.y - kHalfStep * std::abs(double(heights.x) - eye.position.y),
                                        double(heights.y) - eye.position.y + kHalfStep * std::abs(double(heights.y) - eye.position.y)};
                tiles.push_back({.cell = glm::ivec2{x, z} * (GRASS_TILE << level), .level = level, .heights = glm::packHalf2x16(fromEye)});
            }
    }
    return tiles;
}

glsl::GrassFrame Grass::frame(const Eye& eye, const Settings& settings) const
{
    glsl::GrassFrame frame{};
    const glm::dvec2 place{eye.position.x, eye.position.z}, cell = glm::floor(place / kCell);
    frame.eyeCell = glm::ivec2{cell};
    frame.eyeRest = glm::vec2{place - cell * kCell};
    frame.mapFrom = glm::vec2{m_map->origin};
    frame.mapSize = glm::vec2{m_map->size()};
    frame.mapTexel = float(m_map->metresPerTexel);
    frame.eyeHeight = float(eye.position.y);
    frame.full = grassFullTo(settings);
    frame.distance = settings.grassDistance;
    frame.density = settings.grassDensity;
    frame.kept = kept(eye, settings);
    frame.most = std::uint32_t(std::max(settings.mostBlades, 0));
    for (std::size_t i = 0; i < m_kinds.size(); ++i)
        frame.kind[i] = kindOf(m_kinds[i]);
    return frame;
}

} // namespace renderer
