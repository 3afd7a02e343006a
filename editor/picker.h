// Picker: what is under a ray. Objects by their triangles (Embree), leaves by their alpha, the ground by the same
// triangles that are drawn. A mirror of the scene: it follows its changes.
#pragma once

#include "editor/view.h"
#include "io/scene/assets.h"
#include "io/scene/changes.h"
#include "io/scene/scene.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace editor {

enum class Surface { None, Object, Terrain, Instance };
constexpr const char* nameOf(Surface surface)
{
    return surface == Surface::Object ? "object" : surface == Surface::Terrain ? "terrain" : surface == Surface::Instance ? "instance" : "none";
}

struct PickHit {
    Surface surface = Surface::None;
    io::ObjectId id = io::ObjectId::None; // of an instance too: Scene::findInstance()
    io::TemplateId templateId = io::TemplateId::None;
    glm::dvec3 position{0};     // m, world
    glm::dvec3 normal{0, 1, 0}; // of the triangle, unit, towards the ray's origin
    double distance = 0;        // m

    explicit operator bool() const { return surface != Surface::None; }
};

struct PickOptions {
    std::span<const io::ObjectId> skip; // rays pass through these
    bool objects = true; // and instances
    bool terrain = true;
    double maxDistance = 1e7; // m
    double pixelWidth = 0; // m, of a pixel at 1 m: leaves are then judged as the picture shows them, blurred far away
};

double pixelWidth(const View& view);

// Pixels from the top left; the corners in any order.
struct PixelRect {
    glm::dvec2 from{0}, to{0};
};

class TerrainRay;

class Picker {
public:
    Picker();
    ~Picker();
    Picker(const Picker&) = delete;
    Picker& operator=(const Picker&) = delete;

    // Costs what `changes` names. The index over objects is renewed by the rays that come, as far as they reach.
    void update(const io::Scene& scene, const io::Assets& assets, const io::Changes& changes);

    void prepare(); // renews all of the index at once

    void setBoxesOnly(bool boxesOnly); // every object by the box around it
    bool boxesOnly() const;

    PickHit pick(const io::Ray& ray, const PickOptions& options = {}) const;
    // The ground as rays meet it now; a copy stays as it is. Empty: there is none.
    const TerrainRay& ground() const;

    PickHit pick(const View& view, glm::dvec2 pixel, PickOptions options = {}) const; // sets pixelWidth
    // The nearest hit of each object, and of the ground, near to far.
    std::vector<PickHit> pickAll(const io::Ray& ray, std::size_t max = 32, const PickOptions& options = {}) const;
    std::vector<PickHit> pickAll(const View& view, glm::dvec2 pixel, std::size_t max = 32) const; // with pixelWidth

    // Objects whose middle is seen inside the rectangle, sorted by id. With `seen` (ids that the rectangle shows,
    // as Renderer::readIds) it is exactly those of them that exist, so nothing that is hidden.
    std::vector<io::ObjectId> pickBox(const View& view, const PixelRect& rect,
                                      std::optional<std::span<const std::uint32_t>> seen = std::nullopt) const;

    io::WorldBox bounds(io::ObjectId id) const; // empty for groups and unknown ids

private:
    struct State;
    std::unique_ptr<State> m_state;
};

// Which of the things under the cursor a click means: the nearest first, and at each further click at the same
// place the next one behind it.
class ClickCycle {
public:
    static constexpr double kSamePlace = 4; // pixels

    PickHit next(std::span<const PickHit> hits, glm::dvec2 pixel);
    void reset() { m_ids.clear(); }

private:
    std::vector<io::ObjectId> m_ids;
    glm::dvec2 m_pixel{0};
    std::size_t m_index = 0;
};

} // namespace editor
