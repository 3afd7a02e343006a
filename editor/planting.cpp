#include "editor/planting.h"

#include "editor/placement.h"
#include "editor/random.h"
#include "io/scene/ground.h"
#include "io/scene/instance_walk.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace editor {
namespace {

constexpr double kSamePlace = 0.01; // m: never two in one place, even where nothing is asked of their spacing
constexpr double kObstacles = 32; // m, side of the squares in which they lie

std::uint64_t keyOf(const glm::ivec2& square)
{
    return std::uint64_t(std::uint32_t(square.x)) << 32 | std::uint32_t(square.y);
}

PatternRules patternOf(const PlantRules& rules)
{
    PatternRules pattern{.kinds = {}, .density = rules.density, .spacing = rules.spacing, .seed = rules.seed};
    for (const PlantKind& kind : rules.kinds)
        pattern.kinds.push_back({kind.weight, kind.spacing, kind.room});
    return pattern;
}

float footOf(const io::Assets& assets, io::TemplateId id)
{
    const io::Model* model = assets.model(id);
    return model && !model->bounds.empty() ? model->bounds.min.y : 0;
}

double slopeOf(const glm::dvec3& normal)
{
    return glm::degrees(std::acos(glm::clamp(normal.y, -1.0, 1.0)));
}

} // namespace

PlantRules plantRules(const io::Scene& scene, const io::Assets& assets, const io::ScatterLayer& layer)
{
    PlantRules rules{.kinds = {},
                     .density = double(layer.density),
                     .spacing = double(layer.spacing),
                     .seed = layer.seed,
                     .slope = glm::dvec2{layer.slope},
                     .altitude = glm::dvec2{layer.altitude},
                     .ground = layer.ground,
                     .clearance = double(layer.clearance),
                     .layer = layer.id};
    for (const io::Species& species : layer.species) {
        const io::TemplateId id = scene.findTemplate(species.templateName);
        const io::Template* what = scene.find(id);
        rules.kinds.push_back({.templateId = id,
                               .weight = what ? species.weight : 0,
                               .spacing = species.spacing,
                               .room = 0,
                               .scale = layer.scale * species.scale,
                               .yaw = layer.yaw,
                               .tilt = layer.tilt,
                               .sink = layer.sink + (what ? what->sink : 0),
                               .align = layer.align,
                               .foot = footOf(assets, id)});
    }
    return rules;
}

PlantRules plantRules(const io::Scene& scene, const io::Assets& assets, std::span<const io::TemplateId> templates)
{
    PlantRules rules;
    for (const io::TemplateId id : templates) {
        const io::Template* what = scene.find(id);
        if (!what) continue;
        rules.kinds.push_back({.templateId = id,
                               .weight = 1,
                               .spacing = 0,
                               .room = what->footprint,
                               .scale = what->scale,
                               .yaw = what->yaw,
                               .tilt = what->tilt,
                               .sink = what->sink,
                               .align = what->alignToGround ? 1.0f : 0.0f,
                               .foot = footOf(assets, id)});
    }
    return rules;
}

void Standing::add(const glm::dvec2& at, std::uint32_t kind)
{
    m_ones[key(m_pattern.squareAt(at))].push_back({at, kind});
}

int Standing::count(const glm::ivec2& square) const
{
    const auto found = m_ones.find(key(square));
    return found == m_ones.end() ? 0 : int(found->second.size());
}

bool Standing::has(const glm::dvec2& at) const
{
    const auto found = m_ones.find(key(m_pattern.squareAt(at)));
    return found != m_ones.end() && std::ranges::any_of(found->second, [&](const One& one) { return glm::distance(one.at, at) < kSamePlace; });
}

bool Standing::hasRoom(const PatternPoint& point) const
{
    const std::size_t kinds = m_pattern.rules().kinds.size();
    const glm::ivec2 square = m_pattern.squareAt(point.at);
    for (int z = -1; z <= 1; ++z)
        for (int x = -1; x <= 1; ++x) {
            const auto found = m_ones.find(key(square + glm::ivec2{x, z}));
            if (found == m_ones.end()) continue;
            for (const One& one : found->second) {
                const double least = one.kind < kinds ? m_pattern.rules().least(one.kind, point.kind) : m_pattern.rules().spacing;
                if (glm::distance(one.at, point.at) < std::max(least, kSamePlace)) return false;
            }
        }
    return true;
}

Planting::Planting(PlantRules rules, const io::Scene& scene, PlantSurface surface)
    : m_rules{std::move(rules)}, m_pattern{patternOf(m_rules)}, m_surface{std::move(surface)}, m_heights{scene.heights()}, m_cover{scene.cover()}
{
    if (m_heights) m_reach = {m_heights->origin, m_heights->origin + glm::dvec2{m_heights->size - 1} * m_heights->metresPerTexel};
    if (!m_heights && m_surface)
        for (const io::Object& object : scene.objects()) { // no ground: as far as things stand
            const glm::dvec2 at{object.transform.position.x, object.transform.position.z};
            m_reach = {glm::min(m_reach.low, at - 64.0), glm::max(m_reach.high, at + 64.0)};
        }
    if (!m_rules.ground.empty() && m_heights) {
        const auto& layers = scene.terrain().layers;
        const auto found = std::ranges::find(layers, m_rules.ground, &io::TerrainLayer::name);
        m_layer = found == layers.end() ? io::kMostLayers : int(found - layers.begin());
        m_layers = std::make_shared<io::GroundLayers>(m_heights, m_cover, layers);
    }
    findObstacles(scene);
    if (m_rules.clearance > 0) findNeighbours(scene);
}

void Planting::findNeighbours(const io::Scene& scene)
{
    for (const io::ScatterLayer& layer : scene.scatterLayers()) {
        if (layer.id == m_rules.layer || scene.instances(layer.id).empty()) continue;
        Neighbours& one = m_neighbours.emplace_back(scene.instances(layer.id));
        for (const io::TemplateId id : io::templatesOf(scene, layer)) {
            const io::Template* what = scene.find(id);
            one.away.push_back(m_rules.clearance + double(what ? what->footprint : 0));
        }
    }
}

void Planting::findObstacles(const io::Scene& scene)
{
    float room = 0;
    for (const PlantKind& kind : m_rules.kinds)
        room = std::max(room, kind.room);
    for (const io::Object& object : scene.objects()) {
        const io::Template* what = scene.find(object.templateId);
        if (!what || (what->footprint <= 0 && room <= 0 && m_rules.clearance <= 0)) continue;
        const Obstacle one{{object.transform.position.x, object.transform.position.z}, double(what->footprint) + m_rules.clearance};
        const double reach = one.radius + double(room);
        const glm::ivec2 low{glm::floor((one.at - reach) / kObstacles)}, high{glm::floor((one.at + reach) / kObstacles)};
        for (int z = low.y; z <= high.y; ++z)
            for (int x = low.x; x <= high.x; ++x)
                m_obstacles[keyOf({x, z})].push_back(one);
    }
}

bool Planting::clear(const glm::dvec2& at, double room) const
{
    if (m_obstacles.empty()) return true;
    const auto found = m_obstacles.find(keyOf(glm::ivec2{glm::floor(at / kObstacles)}));
    return found == m_obstacles.end() ||
           std::ranges::none_of(found->second, [&](const Obstacle& one) { return glm::distance(one.at, at) < one.radius + room; });
}

bool Planting::clearOfPlants(const glm::dvec2& at) const
{
    constexpr double kSide = io::kInstanceTile;
    for (const Neighbours& one : m_neighbours) {
        const double farthest = one.away.empty() ? 0 : std::ranges::max(one.away);
        const glm::ivec2 low{glm::floor((at - farthest) / kSide)}, high{glm::floor((at + farthest) / kSide)};
        for (int z = low.y; z <= high.y; ++z)
            for (int x = low.x; x <= high.x; ++x) {
                const auto found = one.tiles.find({x, z});
                if (found == one.tiles.end()) continue;
                const glm::dvec2 from = at - glm::dvec2{x, z} * kSide;
                for (const io::Instance& instance : found->second->instances)
                    if (instance.species < one.away.size() && glm::distance(glm::dvec2{instance.x, instance.z} * io::kInstanceStep, from) < one.away[instance.species]) return false;
            }
    }
    return true;
}

std::optional<PlantSpot> Planting::spotAt(const glm::dvec2& at) const
{
    if (m_surface) return m_surface(at.x, at.y);
    if (!m_heights || io::holeAt(*m_heights, m_cover.get(), at.x, at.y)) return std::nullopt;
    const auto height = m_heights->height(at.x, at.y);
    const auto normal = m_heights->normal(at.x, at.y);
    if (!height || !normal) return std::nullopt;
    return PlantSpot{{at.x, *height, at.y}, *normal};
}

bool Planting::allows(const PatternPoint& point, const PlantSpot& spot) const
{
    const double slope = slopeOf(spot.normal);
    if (slope < m_rules.slope.x || slope > m_rules.slope.y) return false;
    if (spot.position.y < m_rules.altitude.x || spot.position.y > m_rules.altitude.y) return false;
    // On top of a thing one does not keep away from it.
    if (!m_surface && !clear(point.at, double(m_rules.kinds[point.kind].room))) return false;
    if (!clearOfPlants(point.at)) return false;
    if (m_layer < 0) return true;
    if (m_layer >= io::kMostLayers || !m_heights->contains(point.at.x, point.at.y)) return false;
    const io::GroundLayers::Shares shares = m_layers->at(point.at.x, point.at.y);
    return std::ranges::max_element(shares) - shares.begin() == m_layer && shares[std::size_t(m_layer)] > 0;
}

io::Transform Planting::transformOf(const PatternPoint& point, const PlantSpot& spot) const
{
    const PlantKind& kind = m_rules.kinds[point.kind];
    const glm::dvec3 up = glm::normalize(glm::mix(glm::dvec3{0, 1, 0}, spot.normal, double(kind.align)));
    const io::Template varied{.yaw = kind.yaw, .scale = kind.scale, .tilt = kind.tilt, .alignToGround = kind.align > 0, .sink = kind.sink};
    io::Transform result = placedOn(varied, {}, spot.position, up, {.seed = point.seed});
    // It stays above its point, at the height where its foot, or what is to be in the ground, lies in the surface's plane.
    const double below = double(kind.foot * result.scale.y) + double(kind.sink);
    result.position = spot.position;
    result.position.y -= below * glm::dot(up, spot.normal) / std::max(spot.normal.y, 0.1);
    return result;
}

std::vector<Plant> Planting::plants(const PlaneRect& part, const std::function<bool(const glm::dvec2&)>& wanted, const Standing* standing) const
{
    std::vector<Plant> found;
    const PlaneRect inside{glm::max(part.low, m_reach.low), glm::min(part.high, m_reach.high)};
    const bool crowded = standing && !standing->empty();
    const std::vector<PatternPoint> points = m_pattern.points(crowded ? m_pattern.wholeSquares(inside) : inside);
    const std::unordered_map<std::uint64_t, int> strangers = crowded ? strangersAmong(points, *standing) : std::unordered_map<std::uint64_t, int>{};
    for (const PatternPoint& point : points) {
        if (!inside.contains(point.at) || (wanted && !wanted(point.at))) continue;
        if (crowded) {
            if (!standing->hasRoom(point)) continue;
            const auto taken = strangers.find(keyOf(point.square));
            if (taken != strangers.end() && int(point.index) >= m_pattern.wanted(point.square) - taken->second) continue;
        }
        const std::optional<PlantSpot> spot = spotAt(point.at);
        if (spot && allows(point, *spot)) found.push_back({point.kind, transformOf(point, *spot)});
    }
    return found;
}

std::optional<Plant> Planting::one(const glm::dvec3& point, std::uint64_t seed) const
{
    if (m_pattern.rules().density <= 0) return std::nullopt;
    Random random{seed};
    const PatternPoint chosen{.at = {point.x, point.z}, .kind = m_pattern.kindFor(random.unit()), .seed = random.bits()};
    const std::optional<PlantSpot> spot = spotAt(chosen.at);
    return Plant{chosen.kind, transformOf(chosen, spot ? *spot : PlantSpot{point, {0, 1, 0}})};
}

std::unordered_map<std::uint64_t, int> Planting::strangersAmong(std::span<const PatternPoint> points, const Standing& standing) const
{
    std::unordered_map<std::uint64_t, int> strangers;
    for (const PatternPoint& point : points) {
        const auto [count, isNew] = strangers.try_emplace(keyOf(point.square), 0);
        if (isNew) count->second = standing.count(point.square);
        if (standing.has(point.at)) --count->second;
    }
    return strangers;
}

} // namespace editor
