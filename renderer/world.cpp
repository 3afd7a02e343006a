#include "renderer/world.h"

#include "io/base/contract.h"

#include <algorithm>

namespace renderer {
namespace {

constexpr std::size_t kScattered = 2048; // more single records than this go up as one piece

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
    ++m_revision;
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
    m_flags.clear();
    m_slotOf.clear();
    m_bounds = {};
    m_slotOf.reserve(scene.objects().size());
    for (const io::Object& object : scene.objects())
        updateObject(scene, object.id);
    m_allDirty = true;
    m_selection.clear();
    m_flagsDirty = true;
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
    const bool drawn = object && modelOf(object->templateId) >= 0;
    const auto known = m_slotOf.find(io::number(id));
    if (!drawn) {
        if (known != m_slotOf.end()) remove(known->second);
        return;
    }
    std::uint32_t slot = 0;
    if (known != m_slotOf.end()) {
        slot = known->second;
    } else {
        slot = std::uint32_t(m_records.size());
        m_slotOf.emplace(io::number(id), slot);
        m_records.emplace_back();
        m_cullRecords.emplace_back();
        m_flags.emplace_back();
        m_flagsDirty = true;
    }
    place(slot, *object);
}

void World::place(std::uint32_t slot, const io::Object& object)
{
    const TemplateState& state = m_templates[io::number(object.templateId) - 1];
    const ModelEntry& model = m_models.entry(state.model);
    m_records[slot] = instanceOf(object.transform, object.id);
    const glm::dmat4 matrix = io::worldFromModel(object.transform);
    const glm::dvec3 centre{matrix * glm::dvec4{model.centre, 1}};
    const glm::vec3 size = glm::abs(object.transform.scale);
    const double radius = double(model.radius) * std::max({size.x, size.y, size.z});
    const std::uint32_t flags = (state.castShadow ? CULL_CASTS_SHADOW : 0) | (state.marker ? CULL_MARKER : 0) |
                                (isMirrored(object.transform) ? CULL_MIRRORED : 0);
    m_cullRecords[slot] = cullRecord(centre, radius, std::uint32_t(state.model), flags);
    m_bounds.add(centre - radius);
    m_bounds.add(centre + radius);
    touch(slot);
}

void World::remove(std::uint32_t slot)
{
    const auto last = std::uint32_t(m_records.size() - 1);
    m_slotOf.erase(m_records[slot].objectId);
    if (slot != last) { // the last one takes its place, so that the arrays stay dense
        m_records[slot] = m_records[last];
        m_cullRecords[slot] = m_cullRecords[last];
        m_flags[slot] = m_flags[last];
        m_slotOf[m_records[slot].objectId] = slot;
        touch(slot);
        m_flagsDirty = true;
    }
    m_records.pop_back();
    m_cullRecords.pop_back();
    m_flags.pop_back();
}

void World::touch(std::uint32_t slot)
{
    if (!m_allDirty) m_dirty.push_back(slot);
    if (m_dirty.size() > kScattered) m_allDirty = true;
}

void World::select(std::span<const io::ObjectId> ids)
{
    if (!m_flagsDirty && std::ranges::equal(ids, m_selection)) return;
    m_selection.assign(ids.begin(), ids.end());
    std::ranges::fill(m_flags, 0u);
    for (const io::ObjectId id : ids)
        if (const auto known = m_slotOf.find(io::number(id)); known != m_slotOf.end())
            m_flags[known->second] = INSTANCE_SELECTED;
    m_flagsDirty = true;
}

void World::upload()
{
    uploadRecords();
    if (m_flagsDirty) uploadFlags();
    m_flagsDirty = false;
    m_gpuRecords.instances(m_recordBuffer, m_flagBuffer);
    m_gpuRecords.materials(m_models.materials());
}

void World::uploadRecords()
{
    constexpr std::size_t kRecord = sizeof(glsl::Instance);
    const std::size_t bytes = std::max<std::size_t>(m_records.size(), 1) * kRecord;
    if (m_recordBuffer.bytes() < bytes) {
        gl::grow(m_recordBuffer, "instances", bytes, 0);
        m_allDirty = true;
    }
    const auto write = [&](std::size_t first, std::size_t count) {
        m_recordBuffer.write(first * kRecord, std::as_bytes(std::span{m_records}.subspan(first, count)));
        m_uploadedBytes += count * kRecord;
    };
    if (m_allDirty) {
        write(0, m_records.size());
    } else {
        std::ranges::sort(m_dirty);
        m_dirty.erase(std::unique(m_dirty.begin(), m_dirty.end()), m_dirty.end());
        for (const std::uint32_t slot : m_dirty)
            if (slot < m_records.size()) write(slot, 1);
    }
    m_dirty.clear();
    m_allDirty = false;
}

void World::uploadFlags()
{
    const std::size_t bytes = std::max<std::size_t>(m_flags.size(), 1) * sizeof(std::uint32_t);
    gl::grow(m_flagBuffer, "instance flags", bytes, 0);
    m_flagBuffer.write(0, std::as_bytes(std::span{m_flags}));
}

DrawList World::draws(GpuStream& stream, const CullRequest& request, bool blended) const
{
    cull({.records = m_cullRecords, .models = m_models.cullModels()}, cullView(request, m_cullRecords.size()), m_seen);
    return makeDrawList(stream, {.models = m_models,
                                 .seen = m_seen,
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
        box.add(glm::dvec3{record.centre} - double(record.radius));
        box.add(glm::dvec3{record.centre} + double(record.radius));
    }
    return box;
}

} // namespace renderer
