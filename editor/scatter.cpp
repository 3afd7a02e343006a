#include "editor/scatter.h"

#include "io/base/random.h"

#include <algorithm>

namespace editor {
namespace {

glm::dvec2 flat(const io::Object& object)
{
    return {object.transform.position.x, object.transform.position.z};
}

Standing standingObjects(const io::Scene& scene, const Planting& planting, const PlaneRect& bounds)
{
    Standing standing{planting.pattern()};
    const std::vector<PlantKind>& kinds = planting.rules().kinds;
    const double reach = 2 * planting.pattern().side();
    const PlaneRect near{bounds.low - reach, bounds.high + reach};
    for (const io::Object& object : scene.objects()) {
        if (!near.contains(flat(object))) continue;
        const auto kind = std::ranges::find(kinds, object.templateId, &PlantKind::templateId);
        if (kind != kinds.end()) standing.add(flat(object), std::uint32_t(kind - kinds.begin()));
    }
    return standing;
}

} // namespace

std::vector<io::ObjectId> scatter(Document& document, const std::string& name, const Planting& planting, const PlantRegion& region)
{
    const Standing standing = standingObjects(document.scene(), planting, region.bounds());
    std::vector<io::ObjectId> ids;
    std::vector<io::Object> copies;
    for (const Plant& plant : planting.plants(region.bounds(), [&](const glm::dvec2& at) { return region.contains(at); }, &standing)) {
        if (copies.size() == kMostScattered) break;
        ids.push_back(document.freshId());
        copies.push_back({.id = ids.back(), .templateId = planting.rules().kinds[plant.kind].templateId, .transform = plant.transform});
    }
    addObjects(document, name, std::move(copies));
    return ids;
}

std::vector<io::ObjectId> scatteredIn(const io::Scene& scene, std::span<const io::TemplateId> templates, const PlantRegion& region)
{
    std::vector<io::ObjectId> ids;
    for (const io::Object& object : scene.objects())
        if (region.contains(flat(object)) && std::ranges::find(templates, object.templateId) != templates.end()) ids.push_back(object.id);
    std::ranges::sort(ids);
    return ids;
}

std::vector<io::ObjectId> thinnedOut(const io::Scene& scene, std::vector<io::ObjectId> ids, double share)
{
    std::erase_if(ids, [&](io::ObjectId id) {
        const glm::ivec2 at{glm::round(flat(scene.at(id)) * 1024.0)};
        return double(io::unitOf(io::hash(at.x, at.y, 0x7415u))) < share;
    });
    return ids;
}

} // namespace editor
