#include "renderer/world.h"

#include "io/base/contract.h"
#include "io/scene/instance_walk.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr std::size_t kFewPlaces = 256; // more changed places than this count as everywhere

bool isFinite(const io::Transform& t)
{
    const double sum = t.position.x + t.position.y + t.position.z + t.rotation.x + t.rotation.y + t.rotation.z +
                       t.scale.x + t.scale.y + t.scale.z;
    return std::isfinite(sum) && t.scale.x != 0 && t.scale.y != 0 && t.scale.z != 0;
}

} // namespace

void World::update(const io::Scene& scene, const io::Assets& assets, const io::Changes& changes)
{
    if (changes.none()) return;
    if (changes.everything || !changes.templates.empty()) ++m_revision;
    if (changes.everything) return rebuild(scene, assets);
    if (!changes.templates.empty()) updateTemplates(scene, assets, changes.templates);
    for (const io::ObjectId id : changes.objects)
        updateObject(scene, id);
    if (changes.scatter) updateInstances(scene, allTiles(scene), true);
    else if (!changes.instances.empty()) updateInstances(scene, changes.instances, false);
    if (wasteful()) return rebuild(scene, assets);
    m_batched.uploadModels();
}

// Batched models that were replaced stay in the buffers; when they outnumber those in use, all is packed anew.
bool World::wasteful() const
{
    return m_batched.models() > 2 * m_templates.size() + 8;
}

void World::rebuild(const io::Scene& scene, const io::Assets& assets)
{
    m_batched.clear();
    m_direct.clear();
    m_templates.clear();
    for (std::size_t i = 0; i < scene.templates().size(); ++i)
        readTemplate(scene, assets, io::TemplateId(i + 1));
    m_batched.uploadModels();

    m_handleOf.clear();
    m_tiles.clear();
    m_tileOf.clear();
    m_scattered = 0;
    m_bounds = {};
    m_mostSway = 0;
    m_selection.clear();
    m_touched.clear();
    ++m_revision;
    m_handleOf.reserve(scene.objects().size());
    m_growing = true;
    m_batched.grow();
    m_direct.grow();
    for (const io::Object& object : scene.objects())
        updateObject(scene, object.id);
    updateInstances(scene, allTiles(scene), true);
    m_batched.settle();
    m_direct.settle();
    m_growing = false;
}

void World::readTemplate(const io::Scene& scene, const io::Assets& assets, io::TemplateId id)
{
    const std::size_t slot = io::number(id) - 1;
    if (m_templates.size() <= slot) m_templates.resize(slot + 1);
    TemplateState state;
    const io::Template* value = scene.find(id);
    if (value) {
        state.path = value->drawPath;
        if (slot < assets.models.size() && assets.models[slot])
            state.model = on(state.path).registerModel(assets.models[slot], value->impostor);
        state.castShadow = value->castShadow && !value->model.empty();
        state.marker = value->model.empty();
        state.wind = value->wind;
        state.standing = slot < assets.models.size() ? assets.models[slot] : nullptr;
        state.asked = *value;
    }
    m_templates[slot] = state;
}

// Bounds, model and flags of every copy may be different now.
void World::updateTemplates(const io::Scene& scene, const io::Assets& assets, std::span<const io::TemplateId> ids)
{
    const std::vector<TemplateState> before = m_templates;
    for (const io::TemplateId id : ids)
        if (id != io::TemplateId::None) readTemplate(scene, assets, id);
    for (const io::Object& object : scene.objects())
        if (std::ranges::find(ids, object.templateId) != ids.end()) updateObject(scene, object.id);
    if (!m_tiles.empty()) updateInstances(scene, allTiles(scene), true);
    for (const TemplateState& state : before)
        unloadUnused(state);
}

void World::unloadUnused(const TemplateState& before)
{
    const auto shows = [&](const TemplateState& state) { return state.shows(before); };
    if (before.path != io::DrawPath::Direct || before.model < 0 || std::ranges::any_of(m_templates, shows)) return;
    (void)m_direct.unload(before.model); // another template may have held it, and it is gone already
}

const World::TemplateState& World::stateOf(io::TemplateId id) const
{
    static const TemplateState kNone;
    const std::uint32_t n = io::number(id);
    return n == 0 || n > m_templates.size() ? kNone : m_templates[n - 1];
}

const io::FootprintShape& World::footprintOf(io::TemplateId id) const
{
    const TemplateState& state = stateOf(id);
    if (!state.footprint) state.footprint = state.standing ? io::FootprintShape{state.asked, *state.standing} : io::FootprintShape{};
    return *state.footprint;
}

ModelRef World::modelOf(io::TemplateId id) const
{
    const TemplateState& state = stateOf(id);
    if (state.model < 0) return {};
    return {&on(state.path).library(state.model), state.path == io::DrawPath::Direct ? 0 : state.model};
}

InstanceHandle World::handleOf(io::ObjectId id) const
{
    if (io::isInstance(id)) {
        auto tile = m_tileOf.upper_bound(io::number(id));
        if (tile == m_tileOf.begin()) return {};
        const Tile& of = m_tiles.at((--tile)->second);
        const std::uint32_t index = io::number(id) - of.first;
        return index < of.handles.size() ? of.handles[index] : InstanceHandle{};
    }
    const auto known = m_handleOf.find(io::number(id));
    return known == m_handleOf.end() ? InstanceHandle{} : known->second;
}

const glsl::CullRecord* World::recordOf(io::ObjectId id) const
{
    const InstanceHandle handle = handleOf(id);
    return on(handle.path()).find(handle);
}

void World::updateObject(const io::Scene& scene, io::ObjectId id)
{
    const io::Object* object = scene.find(id);
    if (!object) return remove(id);
    const InstanceHandle before = handleOf(id);
    const InstanceHandle now = place(before, {id, object->templateId, object->transform});
    if (now == before) return;
    if (now == InstanceHandle{}) m_handleOf.erase(io::number(id));
    else m_handleOf[io::number(id)] = now;
}

void World::move(io::ObjectId id, const io::Transform& transform)
{
    const glsl::CullRecord* record = recordOf(id);
    if (record && isFinite(transform)) place(handleOf(id), {id, io::TemplateId{record->templateId}, transform});
}

InstanceHandle World::place(InstanceHandle handle, const Standing& standing)
{
    const TemplateState& state = stateOf(standing.templateId);
    if (state.model < 0 || !isFinite(standing.transform)) {
        remove(handle);
        return {};
    }
    const Placement placement{.model = state.model,
                              .transform = standing.transform,
                              .id = standing.id,
                              .templateId = standing.templateId,
                              .flags = (state.castShadow ? CULL_CASTS_SHADOW : 0u) | (state.marker ? CULL_MARKER : 0u),
                              .wind = state.wind};
    PlacedModels& models = on(state.path);
    if (models.modelOf(handle) == state.model) {
        markPlace(handle);
        const io::Status moved = models.move(handle, placement);
        EXPECTS(moved);
    } else { // new here, or shown by another model now
        remove(handle);
        const io::Result<InstanceHandle> added = models.add(placement);
        EXPECTS(added);
        handle = *added;
        m_selectionStale = true; // it may be one that was selected before it was away
    }
    m_bounds.add(boxOf(*models.find(handle)));
    m_mostSway = std::max(m_mostSway, models.find(handle)->sway);
    markPlace(handle);
    return handle;
}

std::vector<io::LayerTile> World::allTiles(const io::Scene& scene) const
{
    std::vector<io::LayerTile> all;
    for (const auto& [at, tile] : m_tiles)
        all.push_back(at);
    io::eachTile(scene, [&](const io::LayerTile& at) {
        if (!m_tiles.contains(at)) all.push_back(at);
    });
    return all;
}

// All numbers that go before any come, as they go from one tile to another.
void World::updateInstances(const io::Scene& scene, std::span<const io::LayerTile> tiles, bool all)
{
    for (const io::LayerTile& at : tiles)
        if (const auto known = m_tiles.find(at); known != m_tiles.end()) m_tileOf.erase(known->second.first);
    for (const io::LayerTile& at : tiles)
        placeTile(scene, at, all);
}

void World::placeTile(const io::Scene& scene, const io::LayerTile& at, bool all)
{
    Tile& tile = m_tiles[at];
    const Tile before = std::exchange(tile, {});
    const io::InstanceTiles& tiles = scene.instances(at.layer);
    if (const auto held = tiles.find(at.tile); held != tiles.end()) tile.shown = held->second;
    tile.first = io::number(scene.idOf({at, 0}));
    const auto handleBefore = [&](std::size_t i) { return i < before.handles.size() ? before.handles[i] : InstanceHandle{}; };
    const auto same = [&](std::size_t i) {
        return !all && tile.first == before.first && i < before.handles.size() && before.shown->instances[i] == tile.shown->instances[i];
    };
    const io::ScatterLayer* layer = scene.find(at.layer);
    if (layer && layer->shown) io::eachInstance(scene, at, [&](io::ObjectId id, io::TemplateId templateId, const io::Transform& transform) {
        const std::size_t i = tile.handles.size();
        tile.handles.push_back(same(i) ? handleBefore(i) : place(handleBefore(i), {id, templateId, transform}));
    });
    for (std::size_t gone = tile.handles.size(); gone < before.handles.size(); ++gone)
        remove(before.handles[gone]);
    const auto drawn = [](const InstanceHandle& handle) { return handle != InstanceHandle{}; };
    m_scattered += std::size_t(std::ranges::count_if(tile.handles, drawn));
    m_scattered -= std::size_t(std::ranges::count_if(before.handles, drawn));
    if (tile.handles.empty()) m_tiles.erase(at);
    else m_tileOf[tile.first] = at;
}

void World::markPlace(InstanceHandle handle)
{
    const glsl::CullRecord* record = on(handle.path()).find(handle);
    if (!record || m_growing || m_touched.size() > kFewPlaces) return;
    if (m_touched.size() == kFewPlaces) ++m_revision;
    m_touched.emplace_back(record->centre, record->radius + record->sway * WIND_MOST_REACH);
}

void World::remove(io::ObjectId id)
{
    const auto known = m_handleOf.find(io::number(id));
    if (known == m_handleOf.end()) return;
    remove(known->second);
    m_handleOf.erase(known);
}

void World::remove(InstanceHandle handle)
{
    if (handle == InstanceHandle{}) return;
    markPlace(handle);
    (void)on(handle.path()).remove(handle); // gone with its model already, perhaps
}

void World::tint(io::ObjectId id, Tint tint)
{
    const InstanceHandle handle = handleOf(id);
    if (on(handle.path()).find(handle)) (void)on(handle.path()).tint(handle, tint);
}

void World::select(std::span<const io::ObjectId> ids)
{
    if (!m_selectionStale && std::ranges::equal(ids, m_selection)) return;
    m_selectionStale = false;
    for (const io::ObjectId id : m_selection)
        tint(id, Tint::None);
    m_selection.assign(ids.begin(), ids.end());
    for (const io::ObjectId id : m_selection)
        tint(id, Tint::Selected);
}

void World::upload(bool culledThere)
{
    m_uploadedBytes += m_batched.uploadInstances({.records = culledThere, .spheres = culledThere});
    m_uploadedBytes += m_direct.uploadInstances({.records = true});
}

glsl::CullCounts World::batchedDraws(GpuStream& stream, const CullRequest& request, bool blended,
                                     std::vector<DrawList>& lists) const
{
    return m_batched.draws(stream, request, blended, m_direct.blends(), lists);
}

glsl::CullCounts World::directDraws(GpuStream& stream, const CullRequest& request, bool blended,
                                    std::vector<DrawList>& lists) const
{
    return m_direct.draws(stream, request, blended, m_direct.blends(), lists);
}

std::vector<const InstanceTree*> World::trees() const
{
    std::vector<const InstanceTree*> trees = m_batched.trees();
    const std::vector<const InstanceTree*> direct = m_direct.trees();
    trees.insert(trees.end(), direct.begin(), direct.end());
    return trees;
}

io::WorldBox World::boundsOf(std::span<const io::ObjectId> ids) const
{
    io::WorldBox box;
    for (const io::ObjectId id : ids) {
        const InstanceHandle handle = handleOf(id);
        if (const glsl::CullRecord* record = on(handle.path()).find(handle)) box.add(boxOf(*record));
    }
    return box;
}

} // namespace renderer
