#include "editor/arrange.h"

#include "editor/placement.h"
#include "editor/random.h"
#include "io/scene/ground.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <unordered_map>

namespace editor {
namespace {

// What stands where, in squares wide enough that only neighbours can touch.
class Crowd {
public:
    explicit Crowd(double widestFootprint) : m_cell{std::max(2 * widestFootprint, 0.5)} {}

    void add(glm::dvec2 at, double footprint) { m_cells[key(cellOf(at))].push_back({at, footprint}); }
    bool hasRoom(glm::dvec2 at, double footprint) const
    {
        const glm::ivec2 cell = cellOf(at);
        for (int dz = -1; dz <= 1; ++dz)
            for (int dx = -1; dx <= 1; ++dx)
                if (const auto found = m_cells.find(key(cell + glm::ivec2{dx, dz})); found != m_cells.end())
                    for (const One& one : found->second)
                        if (glm::distance(one.at, at) < one.footprint + footprint) return false;
        return true;
    }

private:
    struct One {
        glm::dvec2 at;
        double footprint;
    };
    glm::ivec2 cellOf(glm::dvec2 at) const { return glm::ivec2{glm::floor(at / m_cell)}; }
    static std::uint64_t key(glm::ivec2 cell)
    {
        return std::uint64_t(std::uint32_t(cell.x)) << 32 | std::uint32_t(cell.y);
    }

    double m_cell; // m
    std::unordered_map<std::uint64_t, std::vector<One>> m_cells;
};

double footprintOf(const Document& document, io::TemplateId id)
{
    const io::Template* what = document.scene().find(id);
    return what ? what->footprint : 0;
}

glm::dvec2 flat(const glm::dvec3& position)
{
    return {position.x, position.z};
}

Crowd crowdAround(const Document& document, const ScatterOptions& options)
{
    double widest = 0;
    for (const io::Scene::TemplateSlot& slot : document.scene().templates())
        if (slot.value) widest = std::max(widest, double(slot.value->footprint));
    Crowd crowd{widest};
    for (const io::Object& object : document.scene().objects()) {
        const glm::dvec2 at = flat(object.transform.position);
        if (object.templateId != io::TemplateId::None &&
            glm::distance(at, options.centre) <= options.radius + 2 * widest)
            crowd.add(at, footprintOf(document, object.templateId));
    }
    return crowd;
}

// A random place that fits, or nothing.
std::optional<io::Object> oneMore(const Document& document, const ScatterOptions& options, const Crowd& crowd,
                                  Random& random)
{
    const double distance = options.radius * std::sqrt(random.unit());
    const double angle = random.in(0, glm::two_pi<double>());
    const io::TemplateId id = options.templates[std::size_t(random.unit() * double(options.templates.size()))];
    const std::uint64_t seed = random.bits();

    const glm::dvec2 at = options.centre + distance * glm::dvec2{std::cos(angle), std::sin(angle)};
    const io::HeightMap& ground = *document.scene().heights();
    const auto height = io::groundHeight(document.scene(), at.x, at.y);
    const auto normal = ground.normal(at.x, at.y);
    if (!height || !normal) return std::nullopt;
    const double slope = glm::degrees(std::acos(glm::clamp(normal->y, -1.0, 1.0)));
    if (slope < options.slope.x || slope > options.slope.y || !crowd.hasRoom(at, footprintOf(document, id)))
        return std::nullopt;
    const PickHit hit{.surface = Surface::Terrain, .position = {at.x, *height, at.y}, .normal = *normal};
    return io::Object{.templateId = id, .transform = placedOn(document, id, hit, {.seed = seed})};
}

} // namespace

std::vector<io::ObjectId> scatter(Document& document, const ScatterOptions& options)
{
    constexpr int kTries = 8; // a copy
    if (options.templates.empty() || !document.scene().heights()) return {};
    const double wanted = std::round(options.density * glm::pi<double>() * options.radius * options.radius);
    const auto count = std::size_t(std::clamp(wanted, 0.0, double(ScatterOptions::kMost)));

    Random random{options.seed};
    Crowd crowd = crowdAround(document, options);
    std::vector<io::Object> copies;
    for (std::size_t i = 0; i < count; ++i) {
        for (int attempt = 0; attempt < kTries; ++attempt) {
            std::optional<io::Object> copy = oneMore(document, options, crowd, random);
            if (!copy) continue;
            crowd.add(flat(copy->transform.position), footprintOf(document, copy->templateId));
            copies.push_back(std::move(*copy));
            break;
        }
    }
    std::vector<io::ObjectId> ids;
    for (io::Object& copy : copies)
        ids.push_back(copy.id = document.freshId());
    addObjects(document, "Scatter " + std::to_string(ids.size()) + " objects", std::move(copies));
    return ids;
}

} // namespace editor
