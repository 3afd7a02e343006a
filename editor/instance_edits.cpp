#include "editor/instance_edits.h"

#include "io/scene/instance_walk.h"

#include <algorithm>
#include <unordered_set>

namespace editor {
namespace {

// Tiles as they are to become, each copied when it is first asked for.
class ChangedTiles {
public:
    explicit ChangedTiles(const io::Scene& scene) : m_scene{scene} {}
    io::InstanceTile& operator[](const io::LayerTile& at)
    {
        const auto [tile, fresh] = m_tiles.try_emplace(at);
        if (const io::InstanceTile* now = fresh ? m_scene.find(at) : nullptr) tile->second = *now;
        return tile->second;
    }
    std::vector<SwapInstances::Slot> slots() &&
    {
        std::vector<SwapInstances::Slot> slots;
        for (auto& [at, tile] : m_tiles)
            slots.emplace_back(at, std::make_shared<const io::InstanceTile>(std::move(tile)));
        return slots;
    }

private:
    const io::Scene& m_scene;
    std::map<io::LayerTile, io::InstanceTile> m_tiles;
};

std::vector<SwapInstances::Slot> without(const io::Scene& scene, std::span<const io::ObjectId> ids)
{
    std::map<io::LayerTile, std::vector<std::uint32_t>> gone;
    for (const io::ObjectId id : ids)
        if (const auto instance = scene.findInstance(id)) gone[instance->at].push_back(instance->index);
    ChangedTiles tiles{scene};
    for (auto& [at, indices] : gone) {
        io::InstanceTile& tile = tiles[at];
        const bool rule = scene.find(at.layer)->rule;
        std::ranges::sort(indices, std::ranges::greater{});
        const auto twice = std::ranges::unique(indices);
        indices.erase(twice.begin(), twice.end());
        for (const std::uint32_t index : indices) {
            if (rule) markErased(tile, tile.instances[index]);
            tile.instances.erase(tile.instances.begin() + index);
        }
    }
    return std::move(tiles).slots();
}

// Where an object of this template may go.
struct Place {
    io::ScatterId layer = io::ScatterId::None;
    int species = 0;
};
std::optional<Place> placeFor(const io::Scene& scene, const io::Object& object, io::ScatterId wanted)
{
    const glm::vec3 scale = object.transform.scale;
    if (scale.x <= 0 || scale.x != scale.y || scale.x != scale.z) return std::nullopt;
    const std::string_view name = scene.templateName(object.templateId);
    if (name.empty()) return std::nullopt;
    for (const io::ScatterLayer& layer : scene.scatterLayers()) {
        if (wanted != io::ScatterId::None && layer.id != wanted) continue;
        const auto species = std::ranges::find(layer.species, name, &io::Species::templateName);
        if (species != layer.species.end()) return Place{layer.id, int(species - layer.species.begin())};
    }
    return std::nullopt;
}

} // namespace

std::vector<io::ObjectId> instancesAmong(const io::Scene& scene, std::span<const io::ObjectId> ids)
{
    std::vector<io::ObjectId> instances(ids.begin(), ids.end());
    std::erase_if(instances, [&](io::ObjectId id) { return !scene.findInstance(id); });
    return instances;
}

std::vector<io::ObjectId> withoutInstances(std::span<const io::ObjectId> ids)
{
    std::vector<io::ObjectId> objects(ids.begin(), ids.end());
    std::erase_if(objects, io::isInstance);
    return objects;
}

void removeInstances(Document& document, std::string name, std::span<const io::ObjectId> instances)
{
    setInstances(document, std::move(name), without(document.scene(), instances));
}

std::vector<io::ObjectId> promote(Document& document, std::string name, std::span<const io::ObjectId> instances)
{
    std::vector<io::Object> objects;
    std::vector<io::ObjectId> made;
    std::unordered_set<std::uint32_t> known;
    for (const io::ObjectId id : instances) {
        const auto instance = document.scene().findInstance(id);
        if (!instance || !known.insert(io::number(id)).second) continue;
        objects.push_back(objectOf(document.scene(), *instance));
        objects.back().id = document.freshId();
        made.push_back(objects.back().id);
    }
    const Gesture gesture{document, name};
    removeInstances(document, name, instances);
    addObjects(document, std::move(name), std::move(objects));
    return made;
}

Demoted demote(Document& document, std::string name, std::span<const io::ObjectId> objects, io::ScatterId layer)
{
    Demoted done;
    std::vector<io::ObjectId> gone;
    ChangedTiles tiles{document.scene()};
    for (const io::ObjectId id : document.hierarchy().withMembers(objects)) {
        const io::Object* object = document.scene().find(id);
        if (!object) continue;
        const auto place = placeFor(document.scene(), *object, layer);
        if (!place) {
            ++done.left;
            continue;
        }
        const io::PlacedInstance placed = io::instanceAt(object->transform, place->species, io::kPaintedInstance);
        io::InstanceTile& tile = tiles[{place->layer, placed.tile}];
        done.instances.push_back({{place->layer, placed.tile}, std::uint32_t(tile.instances.size())});
        tile.instances.push_back(placed.instance);
        gone.push_back(id);
    }
    const Gesture gesture{document, name};
    removeObjects(document, name, gone);
    setInstances(document, std::move(name), std::move(tiles).slots());
    return done;
}

io::Object objectOf(const io::Scene& scene, const io::InstanceRef& instance)
{
    const io::ScatterLayer* layer = scene.find(instance.at.layer);
    const io::Instance& held = scene.at(instance);
    io::Object object{.templateId = scene.templateOf(instance), .transform = io::transformOf(instance.at.tile, held)};
    if (layer && held.species >= layer->species.size()) object.templateId = io::TemplateId::None;
    return object;
}

std::string instanceName(const io::Scene& scene, const io::InstanceRef& instance)
{
    const io::ScatterLayer* layer = scene.find(instance.at.layer);
    const std::size_t species = scene.at(instance).species;
    if (!layer || species >= layer->species.size()) return {};
    return layer->species[species].templateName + " (" + layer->name + ")";
}

std::uint64_t trianglesOf(const Document& document, const io::ScatterLayer& layer)
{
    const io::Scene& scene = document.scene();
    std::vector<std::uint64_t> each;
    for (const io::TemplateId id : io::templatesOf(scene, layer)) {
        const io::Template* of = scene.find(id);
        const io::Model* model = document.assets().model(id);
        each.push_back(of && model && !of->model.empty() ? model->triangles() : 0);
    }
    std::uint64_t triangles = 0;
    for (const auto& [place, tile] : scene.instances(layer.id))
        for (const io::Instance& instance : tile->instances)
            if (instance.species < each.size()) triangles += each[instance.species];
    return triangles;
}

} // namespace editor
