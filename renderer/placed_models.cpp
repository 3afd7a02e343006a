#include "renderer/placed_models.h"

#include <algorithm>
#include <fmt/format.h>

namespace renderer {

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

PlacedModels::PlacedModels(io::DrawPath path) : m_path{path}, m_handles{path}
{
    if (isDirect()) m_pool = std::make_shared<TexturePool>();
    else m_sets.push_back(std::make_unique<Set>(nullptr));
}

bool PlacedModels::isRegistered(int model) const
{
    if (model < 0) return false;
    return isDirect() ? std::size_t(model) < m_sets.size() && m_sets[std::size_t(model)] : model < shared().size();
}

io::Error PlacedModels::notRegistered(int model) const
{
    return {fmt::format("model {} of the {} path", model, nameOf(m_path)),
            "it was never registered there, or is unloaded; register the model first"};
}

int PlacedModels::registerModel(const std::shared_ptr<const io::Model>& model, bool impostor)
{
    if (!isDirect()) return shared().add(model, impostor);
    const auto known = std::ranges::find_if(m_sets, [&](const auto& set) { return set && set->model == model; });
    if (known != m_sets.end()) return int(known - m_sets.begin());
    auto set = std::make_unique<Set>(m_pool);
    set->models.add(model);
    set->models.upload();
    set->model = model;
    m_sets.push_back(std::move(set));
    return int(m_sets.size()) - 1;
}

io::Status PlacedModels::unload(int model)
{
    if (!isRegistered(model)) return notRegistered(model);
    if (!isDirect())
        return io::Error{fmt::format("model {} of the batched path", model),
                         "it lies in buffers that all models share and cannot be unloaded alone; choose the direct path for it"};
    for (const std::uint32_t slot : setOf(model).instances.slots())
        m_handles.free(slot);
    m_sets[std::size_t(model)].reset();
    m_pool->forgetUnused();
    return {};
}

void PlacedModels::clear()
{
    for (const auto& set : m_sets) {
        if (!set) continue;
        for (const std::uint32_t slot : set->instances.slots())
            m_handles.free(slot);
        set->instances.clear();
    }
    if (!isDirect()) return shared().clear();
    m_sets.clear();
    m_pool->forgetUnused();
}

void PlacedModels::place(InstancePlace at, const Placement& placement)
{
    const ModelEntry& model = entry(placement.model);
    const io::Transform& transform = placement.transform;
    const glm::dmat4 matrix = io::worldFromModel(transform);
    const glm::dvec3 centre{matrix * glm::dvec4{model.centre, 1}};
    const glm::vec3 size = glm::abs(transform.scale);
    const double radius = double(model.radius) * std::max({size.x, size.y, size.z});
    const std::uint32_t flags =
        placement.flags | (isMirrored(transform) ? CULL_MIRRORED : 0) | (model.blended ? CULL_BLENDS : 0);
    const std::uint32_t number = isDirect() ? 0 : std::uint32_t(placement.model);
    glsl::Instance instance = instanceOf(transform, placement.id);
    glsl::CullRecord record = cullRecord(centre, radius, number, flags);
    record.templateId = io::number(placement.templateId);
    if (placement.wind > 0 && model.bounds.max.y > 0) {
        m_sets[at.set]->models.letSway(int(number));
        const float height = model.bounds.max.y * size.y;
        instance.axisX.w = placement.wind;
        instance.axisY.w = height;
        instance.axisZ.w = 1 / model.bounds.max.y;
        record.sway = placement.wind * height;
    }
    m_sets[at.set]->instances.set(at.row, instance, record);
}

io::Result<InstanceHandle> PlacedModels::add(const Placement& placement)
{
    if (!isRegistered(placement.model)) return notRegistered(placement.model);
    InstancePlace at{.set = isDirect() ? std::uint32_t(placement.model) : 0};
    const InstanceHandle handle = m_handles.give(at);
    at.row = m_sets[at.set]->instances.add(handle.slot);
    m_handles.moved(handle.slot, at);
    place(at, placement);
    return handle;
}

io::Status PlacedModels::move(InstanceHandle handle, const Placement& placement)
{
    const io::Result<InstancePlace> at = m_handles.find(handle);
    if (!at) return at.error();
    if (placement.model != modelOf(handle))
        return io::Error{fmt::format("instance {} of the {} path", handle.slot, nameOf(m_path)),
                         fmt::format("it is a copy of model {}, not {}; remove it and add another", modelOf(handle), placement.model)};
    place(*at, placement);
    return {};
}

io::Status PlacedModels::tint(InstanceHandle handle, Tint tint)
{
    const io::Result<InstancePlace> at = m_handles.find(handle);
    if (!at) return at.error();
    m_sets[at->set]->instances.setFlags(at->row, tint == Tint::Selected ? INSTANCE_SELECTED : 0);
    return {};
}

io::Status PlacedModels::remove(InstanceHandle handle)
{
    const io::Result<InstancePlace> at = m_handles.find(handle);
    if (!at) return at.error();
    m_handles.free(handle.slot);
    if (const auto successor = m_sets[at->set]->instances.remove(at->row)) m_handles.moved(*successor, *at);
    return {};
}

const glsl::CullRecord* PlacedModels::find(InstanceHandle handle) const
{
    const InstancePlace* at = m_handles.peek(handle);
    return at ? &m_sets[at->set]->instances.cullRecord(at->row) : nullptr;
}

int PlacedModels::modelOf(InstanceHandle handle) const
{
    const InstancePlace* at = m_handles.peek(handle);
    if (!at) return -1;
    return isDirect() ? int(at->set) : int(m_sets[0]->instances.cullRecord(at->row).model);
}

void PlacedModels::grow()
{
    for (const auto& set : m_sets)
        if (set) set->instances.grow();
}

void PlacedModels::settle()
{
    for (const auto& set : m_sets)
        if (set) set->instances.settle();
}

void PlacedModels::uploadModels()
{
    for (const auto& set : m_sets)
        if (set) set->models.upload();
}

std::uint64_t PlacedModels::uploadInstances(InstanceSet::Wanted wanted)
{
    std::uint64_t bytes = 0;
    for (const auto& set : m_sets)
        if (set) bytes += set->instances.upload(wanted);
    return bytes;
}

glsl::CullCounts PlacedModels::draws(GpuStream& stream, const CullRequest& request, bool blended, bool apart,
                                     std::vector<DrawList>& lists) const
{
    glsl::CullCounts counts{};
    for (const auto& set : m_sets) {
        if (!set || set->instances.size() == 0) continue;
        DrawList list = set->instances.draws(stream, {.models = set->models,
                                                      .request = request,
                                                      .blended = blended,
                                                      .apart = apart,
                                                      .direct = isDirect()});
        addTo(counts, list.counts);
        if (list.visible > 0) lists.push_back(std::move(list));
    }
    return counts;
}

std::vector<const InstanceTree*> PlacedModels::trees() const
{
    std::vector<const InstanceTree*> trees;
    for (const auto& set : m_sets)
        if (set) trees.push_back(&set->instances.tree());
    return trees;
}

std::size_t PlacedModels::instances() const
{
    std::size_t count = 0;
    for (const auto& set : m_sets)
        if (set) count += set->instances.size();
    return count;
}

std::size_t PlacedModels::models() const
{
    if (!isDirect()) return std::size_t(shared().size());
    return std::size_t(std::ranges::count_if(m_sets, [](const auto& set) { return set != nullptr; }));
}

bool PlacedModels::blends() const
{
    return std::ranges::any_of(m_sets, [](const auto& set) { return set && set->models.blends(); });
}

} // namespace renderer
