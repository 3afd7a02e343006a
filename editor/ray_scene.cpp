#include "editor/ray_scene.h"

#include "editor/ray_tiles.h"
#include "io/base/contract.h"
#include "io/base/log.h"
#include "io/scene/instance_walk.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace editor {
namespace {

void report(void*, RTCError code, const char* text)
{
    io::log::error("Embree: {} (error {})", text ? text : "unknown", int(code));
}

bool withinReach(const io::WorldBox& box)
{
    bool good = !box.empty();
    for (int axis = 0; axis < 3; ++axis)
        good = good && std::abs(box.min[axis]) <= io::SceneTree<std::uint32_t>::kReach &&
               std::abs(box.max[axis]) <= io::SceneTree<std::uint32_t>::kReach;
    return good;
}

} // namespace

struct RayScene::State {
    using MeshesByModel = std::unordered_map<const io::Model*, std::weak_ptr<RayMesh>>;
    struct Slot {
        std::shared_ptr<RayMesh> mesh; // null: nothing to hit
        std::shared_ptr<RayMesh> box;  // made when first needed
    };

    EmbreeDevice device{rtcNewDevice(nullptr)};
    MeshesByModel meshes, boxes;
    std::vector<Slot> templates;
    std::vector<std::uint32_t> freePlaces;
    io::HandleTable placeOf; // object id -> place, as its node
    RayTiles tiles{device.get(), [this](io::TemplateId id) { return shown(id); }};
    bool boxesOnly = false;
    struct Numbers { // of a tile's instances, one after the other
        std::uint32_t first = 0, end = 0;
    };
    std::map<io::LayerTile, Numbers> numbersOf;

    static Numbers numbersIn(const io::Scene& scene, const io::LayerTile& at)
    {
        const io::ScatterLayer* layer = scene.find(at.layer);
        const io::InstanceTile* tile = layer && layer->shown ? scene.find(at) : nullptr;
        const std::uint32_t first = tile ? io::number(scene.idOf({at, 0})) : 0;
        return {first, first + std::uint32_t(tile ? tile->instances.size() : 0)};
    }

    State()
    {
        EXPECTS(device != nullptr);
        rtcSetDeviceErrorFunction(device.get(), report, nullptr);
    }

    std::shared_ptr<RayMesh> shared(MeshesByModel& known, const std::shared_ptr<const io::Model>& model, bool box)
    {
        if (!model || model->indices.empty()) return nullptr;
        std::weak_ptr<RayMesh>& entry = known[model.get()];
        if (auto mesh = entry.lock(); mesh && (box || mesh->model() == model)) return mesh;
        auto mesh = std::make_shared<RayMesh>(device.get(), box ? boxAround(model->bounds) : model);
        entry = mesh;
        return mesh;
    }

    // Whether there is something to hit in a template's instances.
    bool known(const io::Assets& assets, io::TemplateId id)
    {
        const std::uint32_t n = io::number(id);
        if (n == 0 || n > assets.models.size()) return false;
        if (templates.size() < n) templates.resize(n);
        Slot& slot = templates[n - 1];
        const auto& model = assets.models[n - 1];
        if (!slot.mesh || slot.mesh->model() != model) slot = {.mesh = shared(meshes, model, false)};
        return slot.mesh != nullptr;
    }

    // The mesh that instances of a template stand for now.
    std::shared_ptr<RayMesh> shown(io::TemplateId id)
    {
        Slot& slot = templates[io::number(id) - 1];
        if (!boxesOnly) return slot.mesh;
        if (!slot.box) slot.box = shared(boxes, slot.mesh->model(), true);
        return slot.box;
    }

    std::uint32_t find(io::ObjectId id) const { return placeOf.find(io::number(id)).node; }
    const RayInstance* instance(io::ObjectId id) const
    {
        const std::uint32_t place = find(id);
        return place == io::HandleTable::kNowhere ? nullptr : &tiles.instances[place];
    }

    void remove(io::ObjectId id)
    {
        const std::uint32_t place = find(id);
        if (place == io::HandleTable::kNowhere) return;
        tiles.takeOut(place);
        tiles.instances[place].id = io::ObjectId::None;
        freePlaces.push_back(place);
        placeOf.erase(io::number(id));
    }

    std::uint32_t newPlace(io::ObjectId id)
    {
        if (freePlaces.empty()) {
            freePlaces.push_back(std::uint32_t(tiles.instances.size()));
            tiles.instances.emplace_back();
        }
        const std::uint32_t place = freePlaces.back();
        freePlaces.pop_back();
        placeOf.set(io::number(id), {place, 0});
        return place;
    }

    void set(io::ObjectId id, io::TemplateId templateId, const io::Transform& transform, const io::Assets& assets)
    {
        const io::WorldBox bounds = known(assets, templateId) ? io::transformed(assets.model(templateId)->bounds, io::worldFromModel(transform)) : io::WorldBox{};
        if (!withinReach(bounds)) return remove(id);

        std::uint32_t place = find(id);
        if (place != io::HandleTable::kNowhere) {
            const RayInstance& instance = tiles.instances[place];
            if (instance.templateId == templateId && instance.transform == transform) return;
            tiles.takeOut(place);
        } else {
            place = newPlace(id);
        }
        RayInstance& instance = tiles.instances[place];
        instance.id = id;
        instance.templateId = templateId;
        instance.transform = transform;
        instance.bounds = bounds;
        tiles.add(place);
    }
    void set(const io::Object& object, const io::Assets& assets) { set(object.id, object.templateId, object.transform, assets); }

    // All that go before any come, as numbers go from one tile to another.
    void setInstances(const io::Scene& scene, const io::Assets& assets, std::span<const io::LayerTile> changed)
    {
        for (const io::LayerTile& at : changed) {
            const auto before = numbersOf.find(at);
            if (before == numbersOf.end()) continue;
            const Numbers now = numbersIn(scene, at);
            for (std::uint32_t id = before->second.first; id < before->second.end; ++id)
                if (id < now.first || id >= now.end) remove(io::ObjectId{id});
            numbersOf.erase(before);
        }
        for (const io::LayerTile& at : changed) {
            const Numbers now = numbersIn(scene, at);
            if (now.first == now.end) continue;
            numbersOf[at] = now;
            io::eachInstance(scene, at, [&](io::ObjectId id, io::TemplateId templateId, const io::Transform& transform) { set(id, templateId, transform, assets); });
        }
    }

    // The tiles that were, and those that are.
    std::vector<io::LayerTile> allTiles(const io::Scene& scene) const
    {
        std::vector<io::LayerTile> all;
        for (const auto& [at, numbers] : numbersOf)
            all.push_back(at);
        io::eachTile(scene, [&](const io::LayerTile& at) {
            if (!numbersOf.contains(at)) all.push_back(at);
        });
        return all;
    }

    void setAll(const io::Scene& scene, const io::Assets& assets)
    {
        tiles.clear();
        freePlaces.clear();
        placeOf.clear();
        templates.clear();
        meshes.clear();
        boxes.clear();
        numbersOf.clear();
        const std::size_t count = scene.objects().size() + scene.instanceCount();
        placeOf.reserve(count);
        tiles.instances.reserve(count);
        for (const io::Object& object : scene.objects())
            set(object, assets);
        setInstances(scene, assets, allTiles(scene));
    }

    // Instances of templates whose model is another one now.
    void renew(const io::Scene& scene, const io::Assets& assets, std::span<const io::TemplateId> changed)
    {
        std::vector<io::TemplateId> other;
        for (const io::TemplateId id : changed) {
            const std::size_t slot = io::number(id) - 1;
            const auto now = slot < assets.models.size() ? assets.models[slot] : nullptr;
            const auto before =
                slot < templates.size() && templates[slot].mesh ? templates[slot].mesh->model() : nullptr;
            if (now != before) other.push_back(id);
        }
        if (other.empty()) return;
        for (const io::Object& object : scene.objects()) {
            if (std::ranges::find(other, object.templateId) == other.end()) continue;
            remove(object.id);
            set(object, assets);
        }
        for (const auto& [at, numbers] : numbersOf)
            io::eachInstance(scene, at, [&](io::ObjectId id, io::TemplateId templateId, const io::Transform& transform) {
                if (std::ranges::find(other, templateId) == other.end()) return;
                remove(id);
                set(id, templateId, transform, assets);
            });
    }
};

RayScene::RayScene() : m_state{std::make_unique<State>()} {}
RayScene::~RayScene() = default;

void RayScene::update(const io::Scene& scene, const io::Assets& assets, const io::Changes& changes)
{
    State& s = *m_state;
    if (changes.everything) return s.setAll(scene, assets);
    s.renew(scene, assets, changes.templates);
    for (const io::ObjectId id : changes.objects) {
        if (const io::Object* object = scene.find(id))
            s.set(*object, assets);
        else
            s.remove(id);
    }
    if (changes.scatter) s.setInstances(scene, assets, s.allTiles(scene));
    else s.setInstances(scene, assets, changes.instances);
}

void RayScene::setBoxesOnly(bool boxesOnly)
{
    if (std::exchange(m_state->boxesOnly, boxesOnly) != boxesOnly) m_state->tiles.touchAll();
}

bool RayScene::boxesOnly() const
{
    return m_state->boxesOnly;
}

void RayScene::prepare()
{
    m_state->tiles.prepare();
}

namespace {

// Embree found the triangle in floats; where the ray meets its plane is worked out again in doubles.
PickHit exactly(const io::Ray& ray, const RayTreeHit& found, const RayInstance& instance)
{
    PickHit hit{
        .surface = io::isInstance(instance.id) ? Surface::Instance : Surface::Object, .id = instance.id, .templateId = instance.templateId, .distance = found.distance};
    const glm::dmat3 linear{*found.linear}; // as good as what is drawn, and no sines
    const std::size_t first = found.part->firstIndex + 3 * found.triangle;
    const glm::dvec3 corners[3] = {corner(*found.part->model, first), corner(*found.part->model, first + 1),
                                   corner(*found.part->model, first + 2)};
    const glm::dvec3 a = instance.transform.position + linear * corners[0];
    const glm::dvec3 normal = glm::cross(linear * (corners[1] - corners[0]), linear * (corners[2] - corners[0]));
    const double fall = glm::dot(normal, ray.direction);
    const double length = glm::length(normal);
    if (length > 0) {
        hit.normal = fall > 0 ? -normal / length : normal / length;
        const double exact = glm::dot(normal, a - ray.origin) / fall;
        // A plane seen edge-on says little about where; the float answer is the better one then.
        if (std::abs(fall) > 1e-6 * length && exact >= 0) hit.distance = exact;
    } else {
        hit.normal = -ray.direction;
    }
    hit.position = ray.origin + ray.direction * hit.distance;
    return hit;
}

} // namespace

PickHit RayScene::hit(const io::Ray& ray, double maxDistance, std::span<const io::ObjectId> skip, double pixelWidth)
{
    if (!std::isfinite(glm::dot(ray.origin, ray.origin)) || !std::isfinite(glm::dot(ray.direction, ray.direction)))
        return {};
    RayTiles& tiles = m_state->tiles;
    const RayTreeHit found = tiles.hit({.ray = ray, .skip = skip, .pixelWidth = float(pixelWidth)}, maxDistance);
    return found.part ? exactly(ray, found, tiles.instances[found.place]) : PickHit{};
}

bool RayScene::holds(io::ObjectId id) const
{
    return m_state->instance(id) != nullptr;
}

io::WorldBox RayScene::bounds(io::ObjectId id) const
{
    const RayInstance* instance = m_state->instance(id);
    return instance ? instance->bounds : io::WorldBox{};
}

void RayScene::forEachInside(std::span<const glm::dvec4> planes,
                             const std::function<void(io::ObjectId, const io::WorldBox&)>& visit)
{
    m_state->tiles.forEachInside(planes, [&](const RayInstance& i) { visit(i.id, i.bounds); });
}

} // namespace editor
