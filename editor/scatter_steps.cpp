#include "editor/scatter_steps.h"

#include <algorithm>
#include <cmath>

namespace editor {

PlantSurface visibleSurface(const io::Scene& scene, const Picker& picker)
{
    return [&scene, &picker](double x, double z) -> std::optional<PlantSpot> {
        constexpr double kSky = 1e5; // m
        for (const PickHit& hit : picker.pickAll({.origin = {x, kSky, z}, .direction = {0, -1, 0}}))
            if (hit.surface == Surface::Terrain || scene.find(hit.id)) return PlantSpot{hit.position, hit.normal};
        return std::nullopt;
    };
}

Planting plantingOf(const Document& document, const io::ScatterLayer& layer, const Picker* picker)
{
    PlantSurface surface;
    if (layer.meshes && picker) surface = visibleSurface(document.scene(), *picker);
    return {plantRules(document.scene(), document.assets(), layer), document.scene(), std::move(surface)};
}

void followRules(Document& document, const std::string& name, const PlaneRect& bounds)
{
    for (const io::ScatterLayer& layer : std::vector<io::ScatterLayer>{document.scene().scatterLayers().begin(), document.scene().scatterLayers().end()})
        if (layer.rule && !layer.meshes)
            if (auto slots = evaluated(layerTiles(document.scene(), layer), plantingOf(document, layer), bounds)) setInstances(document, name, *std::move(slots));
}

void liftPlants(Document& document, const std::string& name, const io::HeightMap& before, const PlaneRect& bounds)
{
    const auto& now = document.scene().heights();
    if (!now) return;
    InstanceSlots slots;
    const double side = io::kInstanceTile;
    const glm::ivec2 low{glm::floor(bounds.low / side)}, high{glm::floor(bounds.high / side)};
    for (const io::ScatterLayer& layer : document.scene().scatterLayers())
        for (int z = low.y; z <= high.y; ++z)
            for (int x = low.x; x <= high.x; ++x) {
                const io::LayerTile where{layer.id, {x, z}};
                const io::InstanceTile* tile = document.scene().find(where);
                if (!tile) continue;
                io::InstanceTile lifted = *tile;
                for (io::Instance& instance : lifted.instances) {
                    const glm::dvec2 at = glm::dvec2{x, z} * side + glm::dvec2{instance.x, instance.z} * io::kInstanceStep;
                    const auto old = before.height(at.x, at.y), risen = now->height(at.x, at.y);
                    if (old && risen) instance.y += std::int32_t(std::lround((*risen - *old) / io::kInstanceStep));
                }
                if (lifted != *tile) slots.emplace_back(where, std::make_shared<const io::InstanceTile>(std::move(lifted)));
            }
    if (!slots.empty()) setInstances(document, name, std::move(slots));
}

void setSpecies(Document& document, const std::string& name, io::ScatterId id, std::vector<io::Species> species)
{
    const io::ScatterLayer* known = document.scene().find(id);
    if (!known) return;
    constexpr int kGone = -1;
    std::vector<int> numbers; // of the old ones, in the new list; plants know theirs by number
    for (const io::Species& old : known->species) {
        const auto found = std::ranges::find(species, old.templateName, &io::Species::templateName);
        numbers.push_back(found == species.end() ? kGone : int(found - species.begin()));
    }
    InstanceSlots slots;
    for (const auto& [place, tile] : document.scene().instances(id)) {
        io::InstanceTile now = *tile;
        std::erase_if(now.instances, [&](const io::Instance& instance) { return instance.species >= numbers.size() || numbers[instance.species] == kGone; });
        for (io::Instance& instance : now.instances)
            instance.species = std::uint8_t(numbers[instance.species]);
        if (now != *tile) slots.emplace_back(io::LayerTile{id, place}, now.empty() ? nullptr : std::make_shared<const io::InstanceTile>(std::move(now)));
    }
    const Gesture gesture{document, name};
    if (!slots.empty()) setInstances(document, name, std::move(slots));
    std::vector<io::ScatterLayer> layers{document.scene().scatterLayers().begin(), document.scene().scatterLayers().end()};
    std::ranges::find(layers, id, &io::ScatterLayer::id)->species = std::move(species);
    setScatterLayers(document, name, std::move(layers));
}

void clearPlants(Document& document, const std::string& name, io::ScatterId layer)
{
    InstanceSlots slots;
    for (const auto& [place, tile] : document.scene().instances(layer))
        slots.emplace_back(io::LayerTile{layer, place}, nullptr);
    setInstances(document, name, std::move(slots));
}

std::vector<io::ObjectId> plantsToObjects(Document& document, const std::string& name, io::ScatterId id, const PlantRegion& region)
{
    const io::ScatterLayer* layer = document.scene().find(id);
    if (!layer) return {};
    std::vector<io::ObjectId> ids;
    std::vector<io::Object> objects;
    for (const auto& [place, tile] : document.scene().instances(id))
        for (const io::Instance& instance : tile->instances) {
            const io::Transform transform = transformOf(place, instance);
            if (instance.species >= layer->species.size() || !region.contains({transform.position.x, transform.position.z})) continue;
            const io::TemplateId what = document.scene().findTemplate(layer->species[instance.species].templateName);
            if (!document.scene().find(what)) continue;
            ids.push_back(document.freshId());
            objects.push_back({.id = ids.back(), .templateId = what, .transform = transform});
        }
    const Gesture gesture{document, name};
    setInstances(document, name, erased(layerTiles(document.scene(), *layer), region));
    addObjects(document, name, std::move(objects));
    return ids;
}

} // namespace editor
