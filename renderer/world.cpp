#include "renderer/world.h"

#include "io/base/contract.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace renderer {
namespace {

constexpr std::uint32_t kGap = 64;     // slots between two changed ones that go up together
constexpr std::size_t kFewPlaces = 256; // more changed places than this count as everywhere

// Writes what `slots` (in order, perhaps doubled) name of `values` into `buffer`; answers the bytes.
template <class T>
std::uint64_t writeSlots(gl::Buffer& buffer, std::span<const T> values, std::span<const std::uint32_t> slots)
{
    std::uint64_t written = 0;
    for (std::size_t i = 0; i < slots.size();) {
        const std::uint32_t first = slots[i];
        std::uint32_t last = first;
        while (++i < slots.size() && slots[i] <= last + kGap)
            last = slots[i];
        const std::size_t end = std::min<std::size_t>(last + 1, values.size());
        if (first >= end) continue;
        const auto bytes = std::as_bytes(values.subspan(first, end - first));
        buffer.write(first * sizeof(T), bytes);
        written += bytes.size();
    }
    return written;
}

io::WorldBox boxOf(const glsl::CullRecord& record)
{
    const glm::dvec3 centre{record.centre};
    return {centre - double(record.radius), centre + double(record.radius)};
}

bool isFinite(const io::Transform& t)
{
    const double sum = t.position.x + t.position.y + t.position.z + t.rotation.x + t.rotation.y + t.rotation.z +
                       t.scale.x + t.scale.y + t.scale.z;
    return std::isfinite(sum) && t.scale.x != 0 && t.scale.y != 0 && t.scale.z != 0;
}

} // namespace

bool isMirrored(const io::Transform& transform)
{
    return transform.scale.x * transform.scale.y * transform.scale.z < 0;
}

glsl::Instance instanceOf(const io::Transform& transform, io::ObjectId id)
{
    glsl::Instance instance{};
    instance.positionHigh = glm::vec3{transform.position};
    instance.positionLow = glm::vec3{transform.position - glm::dvec3{instance.positionHigh}};
    instance.objectId = io::number(id);
    const glm::mat3 linear = io::linearPart(transform);
    instance.axisX = glm::vec4{linear[0], 0};
    instance.axisY = glm::vec4{linear[1], 0};
    instance.axisZ = glm::vec4{linear[2], 0};
    return instance;
}

void World::update(const io::Scene& scene, const io::Assets& assets, const io::Changes& changes)
{
    if (changes.none()) return;
    if (changes.everything || !changes.templates.empty()) ++m_revision;
    if (changes.everything) return rebuild(scene, assets);
    if (!changes.templates.empty()) updateTemplates(scene, assets, changes.templates);
    for (const io::ObjectId id : changes.objects)
        updateObject(scene, id);
    if (wasteful()) return rebuild(scene, assets);
    m_models.upload();
}

// Models that were replaced stay in the buffers; when they outnumber those in use, all is packed anew.
bool World::wasteful() const
{
    return m_models.size() > 2 * int(m_templates.size()) + 8;
}

void World::rebuild(const io::Scene& scene, const io::Assets& assets)
{
    m_models.clear();
    m_templates.clear();
    for (std::size_t i = 0; i < scene.templates().size(); ++i)
        readTemplate(scene, assets, io::TemplateId(i + 1));
    m_models.upload();

    m_records.clear();
    m_cullRecords.clear();
    m_slotOf.clear();
    m_bounds = {};
    m_tree.clear();
    m_dirty.clear();
    m_onGpu = false;
    m_selection.clear();
    m_touched.clear();
    ++m_revision;
    m_slotOf.reserve(scene.objects().size());
    m_growing = true;
    for (const io::Object& object : scene.objects())
        updateObject(scene, object.id);
    m_growing = false;
    std::vector<std::uint32_t> slots(m_records.size());
    std::iota(slots.begin(), slots.end(), 0u);
    m_tree.build(slots, [&](std::uint32_t slot) { return boxOf(m_cullRecords[slot]); });
}

void World::readTemplate(const io::Scene& scene, const io::Assets& assets, io::TemplateId id)
{
    const std::size_t slot = io::number(id) - 1;
    if (m_templates.size() <= slot) m_templates.resize(slot + 1);
    TemplateState state;
    const io::Template* value = scene.find(id);
    if (slot < assets.models.size() && assets.models[slot])
        state.model = m_models.add(assets.models[slot], value && value->impostor);
    if (value) {
        state.castShadow = value->castShadow && !value->model.empty();
        state.marker = value->model.empty();
    }
    m_templates[slot] = state;
}

// Bounds, model and flags of every copy may be different now.
void World::updateTemplates(const io::Scene& scene, const io::Assets& assets, std::span<const io::TemplateId> ids)
{
    for (const io::TemplateId id : ids)
        if (id != io::TemplateId::None) readTemplate(scene, assets, id);
    for (const io::Object& object : scene.objects())
        if (std::ranges::find(ids, object.templateId) != ids.end()) updateObject(scene, object.id);
}

int World::modelOf(io::TemplateId id) const
{
    const std::uint32_t n = io::number(id);
    return n == 0 || n > m_templates.size() ? -1 : m_templates[n - 1].model;
}

void World::updateObject(const io::Scene& scene, io::ObjectId id)
{
    const io::Object* object = scene.find(id);
    const bool drawn = object && modelOf(object->templateId) >= 0 && isFinite(object->transform);
    const auto known = m_slotOf.find(io::number(id));
    if (!drawn) {
        if (known != m_slotOf.end()) remove(known->second);
        return;
    }
    std::uint32_t slot = 0;
    if (known != m_slotOf.end()) {
        slot = known->second;
        markPlace(slot);
    } else {
        slot = std::uint32_t(m_records.size());
        m_slotOf.emplace(io::number(id), slot);
        m_records.emplace_back();
        m_cullRecords.emplace_back();
        m_selectionStale = true; // it may be one that was selected before it was away
    }
    place(slot, *object);
}

void World::place(std::uint32_t slot, const io::Object& object)
{
    const TemplateState& state = m_templates[io::number(object.templateId) - 1];
    const ModelEntry& model = m_models.entry(state.model);
    const std::uint32_t flags = m_records[slot].drawn;
    m_records[slot] = instanceOf(object.transform, object.id);
    m_records[slot].drawn = flags;
    const glm::dmat4 matrix = io::worldFromModel(object.transform);
    const glm::dvec3 centre{matrix * glm::dvec4{model.centre, 1}};
    const glm::vec3 size = glm::abs(object.transform.scale);
    const double radius = double(model.radius) * std::max({size.x, size.y, size.z});
    const std::uint32_t kind = (state.castShadow ? CULL_CASTS_SHADOW : 0) | (state.marker ? CULL_MARKER : 0) |
                                (isMirrored(object.transform) ? CULL_MIRRORED : 0) | (model.blended ? CULL_BLENDS : 0);
    m_cullRecords[slot] = cullRecord(centre, radius, std::uint32_t(state.model), kind);
    const io::WorldBox box = boxOf(m_cullRecords[slot]);
    m_bounds.add(box);
    if (!m_growing) m_tree.set(slot, box);
    markPlace(slot);
    touch(slot);
}

void World::markPlace(std::uint32_t slot)
{
    if (m_growing || m_touched.size() > kFewPlaces) return;
    if (m_touched.size() == kFewPlaces) ++m_revision;
    const glsl::CullRecord& record = m_cullRecords[slot];
    m_touched.emplace_back(record.centre, record.radius);
}

void World::remove(std::uint32_t slot)
{
    const auto last = std::uint32_t(m_records.size() - 1);
    m_slotOf.erase(m_records[slot].objectId);
    markPlace(slot);
    m_tree.remove(last);
    if (slot != last) { // the last one takes its place, so that the arrays stay dense
        m_records[slot] = m_records[last];
        m_cullRecords[slot] = m_cullRecords[last];
        m_slotOf[m_records[slot].objectId] = slot;
        m_tree.set(slot, boxOf(m_cullRecords[slot]));
        touch(slot);
    }
    m_records.pop_back();
    m_cullRecords.pop_back();
}

void World::touch(std::uint32_t slot)
{
    m_dirty.push_back(slot);
}

void World::setFlags(io::ObjectId id, std::uint32_t flags)
{
    const auto known = m_slotOf.find(io::number(id));
    if (known == m_slotOf.end() || m_records[known->second].drawn == flags) return;
    m_records[known->second].drawn = flags;
    touch(known->second);
}

void World::select(std::span<const io::ObjectId> ids)
{
    if (!m_selectionStale && std::ranges::equal(ids, m_selection)) return;
    m_selectionStale = false;
    for (const io::ObjectId id : m_selection)
        setFlags(id, 0);
    m_selection.assign(ids.begin(), ids.end());
    for (const io::ObjectId id : m_selection)
        setFlags(id, INSTANCE_SELECTED);
}

void World::upload(bool culledThere)
{
    if (!culledThere) { // views copy what they draw
        m_dirty.clear();
        m_onGpu = false;
        return;
    }
    gl::grow(m_recordBuffer, "instances", std::max<std::size_t>(m_records.size(), 1) * sizeof(glsl::Instance),
             m_recordBuffer.bytes());
    gl::grow(m_cullBuffer, "spheres of instances", std::max<std::size_t>(m_records.size(), 1) * sizeof(glsl::CullRecord),
             m_cullBuffer.bytes());
    if (!std::exchange(m_onGpu, true)) {
        m_dirty.resize(m_records.size());
        std::iota(m_dirty.begin(), m_dirty.end(), 0u);
    }
    std::ranges::sort(m_dirty);
    m_uploadedBytes += writeSlots(m_recordBuffer, std::span<const glsl::Instance>{m_records}, m_dirty);
    m_uploadedBytes += writeSlots(m_cullBuffer, std::span<const glsl::CullRecord>{m_cullRecords}, m_dirty);
    m_dirty.clear();
}

DrawList World::draws(GpuStream& stream, const CullRequest& request, bool blended) const
{
    cull({.records = m_cullRecords, .models = m_models.cullModels(), .tree = &m_tree}, request, m_seen);
    return makeDrawList(stream, {.models = m_models,
                                 .seen = m_seen,
                                 .instances = m_records,
                                 .blended = blended,
                                 .records = m_cullRecords,
                                 .eye = request.eye,
                                 .towardSun = request.towardSun});
}

io::WorldBox World::boundsOf(std::span<const io::ObjectId> ids) const
{
    io::WorldBox box;
    for (const io::ObjectId id : ids) {
        const auto known = m_slotOf.find(io::number(id));
        if (known == m_slotOf.end()) continue;
        const glsl::CullRecord& record = m_cullRecords[known->second];
        box.add(boxOf(record));
    }
    return box;
}

} // namespace renderer
