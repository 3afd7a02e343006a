// The lamps of a scene: one for each copy of a template that has a light.
#pragma once

#include "io/scene/changes.h"
#include "io/scene/scene.h"
#include "renderer/eye.h"

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace renderer {

struct Lamp {
    io::ObjectId object = io::ObjectId::None;
    io::TemplateId templateId = io::TemplateId::None;
    glm::dvec3 place{0};           // m, world
    glm::vec3 direction{0, 0, -1}; // unit; of a spot
    glm::vec3 intensity{0};        // irradiance a metre away
    float range = 1;               // m
    float inner = 0, outer = 0;    // radians from the axis; 0: shines all around
    bool castShadow = false;
    bool isSpot() const { return outer > 0; }
    bool operator==(const Lamp&) const = default;
};

// Nothing where a copy carries no light, or none that could be seen.
std::optional<Lamp> lampOf(const io::Object& object, const io::LightSource& light);

class Lamps {
public:
    void update(const io::Scene& scene, const io::Changes& changes); // costs what changed

    std::span<const Lamp> all() const { return m_lamps; }
    // Those whose light a view can show: of more than `most` the brightest from the eye. Brightest first.
    std::vector<Lamp> inView(const Eye& eye, std::size_t most) const;

private:
    void updateObject(const io::Scene& scene, io::ObjectId id);
    void updateTemplates(const io::Scene& scene, std::span<const io::TemplateId> ids);
    void remove(io::ObjectId id);

    std::vector<Lamp> m_lamps; // densely, in no order
    std::unordered_map<std::uint32_t, std::size_t> m_rowOf; // by object id
};

} // namespace renderer
