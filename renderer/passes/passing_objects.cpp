#include "renderer/passes/passing_objects.h"

#include <map>

namespace renderer {
namespace {

struct Passing { // those of one library
    std::vector<glsl::Instance> instances;
    std::vector<Seen> seen;
};

} // namespace

std::vector<DrawList> drawsOf(GpuFrame& gpu, const World& world, std::span<const Ghost> objects)
{
    std::map<const ModelLibrary*, Passing> passing;
    for (const Ghost& object : objects) {
        const ModelRef model = world.modelOf(object.templateId);
        if (!model) continue;
        Passing& here = passing[model.library];
        const std::uint32_t bin = binIndex(model.entry(), 0, isMirrored(object.transform), false);
        here.seen.push_back({std::uint32_t(here.instances.size()), bin});
        here.instances.push_back(instanceOf(object.transform, io::ObjectId::None));
    }
    std::vector<DrawList> lists;
    for (const auto& [library, here] : passing)
        lists.push_back(makeDrawList(gpu.stream(), {.models = *library, .seen = here.seen, .instances = here.instances}));
    return lists;
}

} // namespace renderer
