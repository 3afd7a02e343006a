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
    EXPECTS(id != ObjectId::None);
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
