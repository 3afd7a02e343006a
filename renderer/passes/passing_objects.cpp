#include "renderer/passes/passing_objects.h"

namespace renderer {

DrawList drawsOf(GpuFrame& gpu, const World& world, std::span<const Ghost> objects)
{
    std::vector<glsl::Instance> instances;
    std::vector<Seen> seen;
    for (const Ghost& object : objects) {
        const int model = world.modelOf(object.templateId);
        if (model < 0) continue;
        const ModelEntry& entry = world.models().entry(model);
        seen.push_back({std::uint32_t(instances.size()), binIndex(entry, 0, isMirrored(object.transform), false)});
        instances.push_back(instanceOf(object.transform, io::ObjectId::None));
    }
    world.models().bindMaterials();
    return makeDrawList(gpu.stream(), {.models = world.models(), .seen = seen, .instances = instances});
}

} // namespace renderer
