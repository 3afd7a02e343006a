#include "renderer/passes/passing_objects.h"

#include <numeric>

namespace renderer {

DrawList PassingObjects::bind(GpuFrame& gpu, const World& world, std::span<const Ghost> objects)
{
    std::vector<glsl::Instance> instances;
    std::vector<std::uint32_t> bins;
    for (const Ghost& object : objects) {
        const int model = world.modelOf(object.templateId);
        if (model < 0) continue;
        instances.push_back(instanceOf(object.transform, io::ObjectId::None));
        bins.push_back(std::uint32_t(model) * 2 + (isMirrored(object.transform) ? 1 : 0));
    }
    if (instances.empty()) return {};
    const std::vector<std::uint32_t> flags(instances.size(), 0);
    std::vector<std::uint32_t> slots(instances.size());
    std::iota(slots.begin(), slots.end(), 0u);
    m_records.instances(gpu.stream().put(std::span<const glsl::Instance>{instances}),
                        gpu.stream().put(std::span<const std::uint32_t>{flags}));
    m_records.materials(world.models().materials());
    m_records.bind();
    return makeDrawList(gpu.stream(), {.models = world.models(), .bins = bins, .visible = slots});
}

} // namespace renderer
