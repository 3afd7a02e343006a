#include "io/scene/scene.h"

#include "io/base/contract.h"

#include <algorithm>

namespace io {

const Object* Scene::find(ObjectId id) const
{
    const auto found = m_indexOf.find(number(id));
    return found == m_indexOf.end() ? nullptr : &m_objects[found->second];
}

const Object& Scene::at(ObjectId id) const
{
    const Object* object = find(id);
    EXPECTS(object != nullptr);
    return *object;
}

std::vector<ObjectId> Scene::sortedIds() const
{
    std::vector<ObjectId> ids;
    ids.reserve(m_objects.size());
    for (const Object& object : m_objects)
        ids.push_back(object.id);
    std::sort(ids.begin(), ids.end());
    return ids;
}

TemplateId Scene::findTemplate(std::string_view name) const
{
    for (std::size_t i = 0; i < m_templates.size(); ++i)
        if (m_templates[i].name == name) return TemplateId(i + 1);
    return TemplateId::None;
}

const Template* Scene::find(TemplateId id) const
{
    const std::uint32_t n = number(id);
    if (n == 0 || n > m_templates.size() || !m_templates[n - 1].value) return nullptr;
    return &*m_templates[n - 1].value;
}

std::string_view Scene::templateName(TemplateId id) const
{
    const std::uint32_t n = number(id);
    return n == 0 || n > m_templates.size() ? std::string_view{} : std::string_view{m_templates[n - 1].name};
}

const Camera* Scene::findCamera(std::string_view name) const
{
    const auto found = std::find_if(m_cameras.begin(), m_cameras.end(), [&](const Camera& c) { return c.name == name; });
    return found == m_cameras.end() ? nullptr : &*found;
}

const CameraPath* Scene::findPath(std::string_view name) const
{
    const auto found = std::find_if(m_paths.begin(), m_paths.end(), [&](const CameraPath& p) { return p.name == name; });
    return found == m_paths.end() ? nullptr : &*found;
}

const ScatterLayer* Scene::find(ScatterId id) const
{
    const auto found = std::ranges::find(m_scatterLayers, id, &ScatterLayer::id);
    return found == m_scatterLayers.end() ? nullptr : &*found;
}

const ScatterLayer* Scene::findScatterLayer(std::string_view name) const
{
    const auto found = std::ranges::find(m_scatterLayers, name, &ScatterLayer::name);
    return found == m_scatterLayers.end() ? nullptr : &*found;
}

const InstanceTiles& Scene::instances(ScatterId id) const
{
    static const InstanceTiles kNone;
    const auto found = m_instances.find(id);
    return found == m_instances.end() ? kNone : found->second;
}

const InstanceTile* Scene::find(const LayerTile& tile) const
{
    const InstanceTiles& tiles = instances(tile.layer);
    const auto found = tiles.find(tile.tile);
    return found == tiles.end() ? nullptr : found->second.get();
}

std::size_t Scene::instanceCount() const
{
    std::size_t count = 0;
    for (const ScatterLayer& layer : m_scatterLayers)
        count += io::instanceCount(instances(layer.id));
    return count;
}

ObjectId Scene::idOf(const InstanceRef& instance) const
{
    const ObjectId first = m_instanceIds.first(instance.at);
    return first == ObjectId::None ? first : ObjectId{number(first) + instance.index};
}

std::optional<InstanceRef> Scene::findInstance(ObjectId id) const
{
    const std::optional<InstanceRef> found = isInstance(id) ? m_instanceIds.find(id) : std::nullopt;
    return found && find(found->at.layer) ? found : std::nullopt;
}

const Instance& Scene::at(const InstanceRef& instance) const
{
    const InstanceTile* tile = find(instance.at);
    EXPECTS(tile && instance.index < tile->instances.size());
    return tile->instances[instance.index];
}

TemplateId Scene::templateOf(const InstanceRef& instance) const
{
    const ScatterLayer* layer = find(instance.at.layer);
    const std::size_t species = at(instance).species;
    return layer && species < layer->species.size() ? findTemplate(layer->species[species].templateName) : TemplateId::None;
}

void Scene::takeIdsUpTo(ScatterId last)
{
    m_lastScatterId = std::max(m_lastScatterId, number(last));
}

ScatterId Scene::freshScatterId()
{
    return ScatterId{++m_lastScatterId};
}

ObjectId Scene::freshId()
{
    return ObjectId{++m_lastId};
}

void Scene::takeIdsUpTo(ObjectId last)
{
    m_lastId = std::max(m_lastId, number(last));
}

TemplateId Scene::templateSlot(std::string_view name)
{
    if (const TemplateId known = findTemplate(name); known != TemplateId::None) return known;
    m_templates.push_back({.name = std::string{name}, .value = std::nullopt});
    return TemplateId(m_templates.size());
}

std::optional<Object> Scene::exchange(ObjectId id, std::optional<Object> object)
{
    EXPECTS(id != ObjectId::None && !isInstance(id));
    const auto found = m_indexOf.find(number(id));
    takeIdsUpTo(id);
    if (object) object->id = id;

    if (found == m_indexOf.end()) {
        if (object) {
            m_indexOf.emplace(number(id), std::uint32_t(m_objects.size()));
            m_objects.push_back(std::move(*object));
        }
        return std::nullopt;
    }
    Object& place = m_objects[found->second];
    std::optional<Object> before = std::move(place);
    if (object) {
        place = std::move(*object);
    } else { // the last one takes its place, so that the array stays dense
        if (&place != &m_objects.back()) {
            place = std::move(m_objects.back());
            m_indexOf[number(place.id)] = found->second;
        }
        m_objects.pop_back();
        m_indexOf.erase(number(id));
    }
    return before;
}

std::optional<Template> Scene::exchange(TemplateId id, std::optional<Template> value)
{
    EXPECTS(id != TemplateId::None && number(id) <= m_templates.size());
    TemplateSlot& slot = m_templates[number(id) - 1];
    if (value) value->name = slot.name;
    return std::exchange(slot.value, std::move(value));
}

Environment Scene::exchange(Environment environment)
{
    return std::exchange(m_environment, std::move(environment));
}
Terrain Scene::exchange(Terrain terrain)
{
    const bool moved = terrain.metresPerTexel != m_terrain.metresPerTexel || terrain.origin != m_terrain.origin;
    if (moved && m_heights) m_heights = std::make_shared<const HeightMap>(m_heights->placed(terrain.metresPerTexel, terrain.origin));
    return std::exchange(m_terrain, std::move(terrain));
}
std::shared_ptr<const HeightMap> Scene::exchange(std::shared_ptr<const HeightMap> heights)
{
    return std::exchange(m_heights, std::move(heights));
}
std::shared_ptr<const CoverMap> Scene::exchange(std::shared_ptr<const CoverMap> cover)
{
    return std::exchange(m_cover, std::move(cover));
}
Grass Scene::exchange(Grass grass)
{
    const bool moved = grass.metresPerTexel != m_grass.metresPerTexel || grass.origin != m_grass.origin;
    if (moved && m_grassMap) m_grassMap = std::make_shared<const GrassMap>(m_grassMap->field(), grass.metresPerTexel, grass.origin);
    return std::exchange(m_grass, std::move(grass));
}
std::shared_ptr<const GrassMap> Scene::exchange(std::shared_ptr<const GrassMap> map)
{
    return std::exchange(m_grassMap, std::move(map));
}
std::vector<Camera> Scene::exchange(std::vector<Camera> cameras)
{
    return std::exchange(m_cameras, std::move(cameras));
}
std::vector<CameraPath> Scene::exchange(std::vector<CameraPath> paths)
{
    return std::exchange(m_paths, std::move(paths));
}

std::vector<ScatterLayer> Scene::exchange(std::vector<ScatterLayer> layers)
{
    for (const ScatterLayer& layer : layers)
        takeIdsUpTo(layer.id);
    return std::exchange(m_scatterLayers, std::move(layers));
}

InstanceTiles Scene::exchange(ScatterId layer, InstanceTiles tiles)
{
    InstanceTiles before = instances(layer);
    for (const auto& [place, tile] : before)
        if (!tiles.contains(place)) m_instanceIds.set({layer, place}, 0);
    for (const auto& [place, tile] : tiles)
        m_instanceIds.set({layer, place}, tile->instances.size());
    if (tiles.empty()) m_instances.erase(layer);
    else m_instances[layer] = std::move(tiles);
    return before;
}

std::shared_ptr<const InstanceTile> Scene::exchange(const LayerTile& tile, std::shared_ptr<const InstanceTile> value)
{
    if (value && value->empty()) value = nullptr;
    m_instanceIds.set(tile, value ? value->instances.size() : 0);
    InstanceTiles& tiles = m_instances[tile.layer];
    std::shared_ptr<const InstanceTile> before;
    if (const auto known = tiles.find(tile.tile); known != tiles.end()) {
        before = std::exchange(known->second, std::move(value));
        if (!known->second) tiles.erase(known);
    } else if (value) {
        tiles.emplace(tile.tile, std::move(value));
    }
    if (tiles.empty()) m_instances.erase(tile.layer);
    return before;
}

void Scene::reserve(std::size_t objects)
{
    m_objects.reserve(objects);
    m_indexOf.reserve(objects);
}

bool sameContent(const Scene& a, const Scene& b)
{
    if (a.objects().size() != b.objects().size() || a.environment() != b.environment() || a.terrain() != b.terrain() ||
        !a.heights() != !b.heights() || (a.heights() && *a.heights() != *b.heights()) ||
        !a.cover() != !b.cover() || (a.cover() && *a.cover() != *b.cover()) ||
        a.grass() != b.grass() || !a.grassMap() != !b.grassMap() || (a.grassMap() && *a.grassMap() != *b.grassMap()) || !std::ranges::equal(a.cameras(), b.cameras()) || !std::ranges::equal(a.paths(), b.paths()))
        return false;
    if (!std::ranges::equal(a.scatterLayers(), b.scatterLayers())) return false;
    for (const ScatterLayer& layer : a.scatterLayers())
        if (!sameInstances(a.instances(layer.id), b.instances(layer.id))) return false;
    for (const Object& object : a.objects()) {
        const Object* other = b.find(object.id);
        if (!other || a.templateName(object.templateId) != b.templateName(other->templateId)) return false;
        Object renamed = *other; // slots may be numbered differently; the names were just compared
        renamed.templateId = object.templateId;
        if (renamed != object) return false;
    }
    const auto covers = [](const Scene& x, const Scene& y) {
        return std::ranges::all_of(x.templates(), [&](const Scene::TemplateSlot& slot) {
            const Template* other = y.find(y.findTemplate(slot.name));
            return slot.value ? other && *other == *slot.value : other == nullptr;
        });
    };
    return covers(a, b) && covers(b, a);
}

} // namespace io
