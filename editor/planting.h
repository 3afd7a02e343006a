// Planting: where plants stand in a world: a pattern of the plane laid over its ground, less what the rules leave out. It holds
// all that it needs of the world, so that it can work beside the window while the world goes on.
#pragma once

#include "editor/plant_pattern.h"
#include "io/scene/assets.h"
#include "io/scene/ground_layers.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace editor {

// One kind of plant and how copies of it vary.
struct PlantKind {
    io::TemplateId templateId = io::TemplateId::None;
    float weight = 1;
    float spacing = 0;      // m, between two of it
    float room = 0;         // m, radius that no other plant's may reach into
    glm::vec2 scale{1};     // factors
    glm::vec2 yaw{0, 360};  // degrees
    float tilt = 0;         // degrees, the most that it leans at random
    float sink = 0;         // m below the surface
    float align = 0;        // 0 upright, 1 along the surface's normal
    float foot = 0;         // m, the lowest of its model above its origin
};

struct PlantRules {
    std::vector<PlantKind> kinds;
    double density = 0.1; // per m2, where nothing is left out
    double spacing = 0;   // m, between any two
    std::uint64_t seed = 1;
    glm::dvec2 slope{0, 90};         // degrees from level
    glm::dvec2 altitude{-1e5, 1e5};  // m
    std::string ground;              // only where this layer of the terrain shows most; empty: anywhere
    double clearance = 0;            // m, to the footprints of objects and of other layers' plants
    io::ScatterId layer = io::ScatterId::None; // whose plants they are
};

// Of a layer, with its species in their order; one whose template is missing has no weight.
PlantRules plantRules(const io::Scene& scene, const io::Assets& assets, const io::ScatterLayer& layer);
// As templates alone say, none nearer to another than their footprints.
PlantRules plantRules(const io::Scene& scene, const io::Assets& assets, std::span<const io::TemplateId> templates);

struct Plant {
    std::uint32_t kind = 0;
    io::Transform transform;
};

// What a plant can stand on.
struct PlantSpot {
    glm::dvec3 position{0};
    glm::dvec3 normal{0, 1, 0};
};
// What lies there, for plants that grow on more than the ground; called from the thread that asks for plants.
using PlantSurface = std::function<std::optional<PlantSpot>(double x, double z)>;

// Plants that are there already: new ones keep away, and those that are none of the pattern's count as some of it.
class Standing {
public:
    explicit Standing(const PlantPattern& pattern) : m_pattern{pattern} {}
    void add(const glm::dvec2& at, std::uint32_t kind);
    bool hasRoom(const PatternPoint& point) const;
    bool has(const glm::dvec2& at) const; // in that very place
    int count(const glm::ivec2& square) const;
    bool empty() const { return m_ones.empty(); }

private:
    struct One {
        glm::dvec2 at;
        std::uint32_t kind;
    };
    static std::uint64_t key(const glm::ivec2& square) { return std::uint64_t(std::uint32_t(square.x)) << 32 | std::uint32_t(square.y); }
    const PlantPattern& m_pattern;
    std::unordered_map<std::uint64_t, std::vector<One>> m_ones;
};

class Planting {
public:
    // Where there is a surface, plants grow on that and nowhere else.
    Planting(PlantRules rules, const io::Scene& scene, PlantSurface surface = {});

    const PlantRules& rules() const { return m_rules; }
    const PlantPattern& pattern() const { return m_pattern; }
    PlaneRect reach() const { return m_reach; } // of the ground: no plant stands beyond
    bool beside() const { return !m_surface; }   // whether another thread may ask for plants

    // Plants in `part` where `wanted` (none: everywhere) lets them, besides those that stand there.
    std::vector<Plant> plants(const PlaneRect& part, const std::function<bool(const glm::dvec2&)>& wanted = {}, const Standing* standing = nullptr) const;

    // One of the mix at a place that a person chose, whatever the rules say. None: every kind is missing.
    std::optional<Plant> one(const glm::dvec3& point, std::uint64_t seed) const;

private:
    struct Obstacle {
        glm::dvec2 at;
        double radius;
    };
    std::unordered_map<std::uint64_t, int> strangersAmong(std::span<const PatternPoint> points, const Standing& standing) const; // by square
    bool allows(const PatternPoint& point, const PlantSpot& spot) const;
    bool clear(const glm::dvec2& at, double room) const;
    bool clearOfPlants(const glm::dvec2& at) const;
    void findObstacles(const io::Scene& scene);
    void findNeighbours(const io::Scene& scene);
    std::optional<PlantSpot> spotAt(const glm::dvec2& at) const;
    io::Transform transformOf(const PatternPoint& point, const PlantSpot& spot) const;

    PlantRules m_rules;
    PlantPattern m_pattern;
    PlantSurface m_surface;
    std::shared_ptr<const io::HeightMap> m_heights;
    std::shared_ptr<const io::CoverMap> m_cover;
    std::shared_ptr<const io::GroundLayers> m_layers; // where a layer is asked for
    int m_layer = -1;                                 // -1: none is asked for; kMostLayers: one that is missing
    std::unordered_map<std::uint64_t, std::vector<Obstacle>> m_obstacles; // by square of kObstacles
    struct Neighbours { // another layer's plants
        io::InstanceTiles tiles;
        std::vector<double> away; // m from those of each species
    };
    std::vector<Neighbours> m_neighbours; // none where no clearance is asked for
    PlaneRect m_reach;
};

} // namespace editor
