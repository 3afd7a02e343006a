#include "renderer/choosing.h"

#include "renderer/gl/machine.h"

namespace renderer {
namespace {

CullRequest without(CullRequest request, std::uint32_t flags)
{
    request.refused |= flags;
    return request;
}

CullRequest only(CullRequest request, std::uint32_t flags)
{
    request.required |= flags;
    return request;
}

} // namespace

bool culledOnGpu(const Settings& settings)
{
    return settings.culler == Culler::Gpu || (settings.culler == Culler::Auto && !gl::drawsInSoftware());
}

std::vector<DrawList> ViewChooser::choose(GpuFrame& gpu, Scenery& scenery, const CullRequest& request,
                                          const Settings& settings, bool occlusion)
{
    std::vector<DrawList> lists;
    const bool blended = !request.towardSun; // glass casts no shadow
    if (!culledOnGpu(settings)) {
        lists.push_back(scenery.world.draws(gpu.stream(), request, blended));
        m_counts = {.drawn = std::uint32_t(lists.back().visible)};
        return lists;
    }
    scenery.cullTable.update(scenery.world.models());
    const CullRequest opaque = without(request, CULL_BLENDS);
    lists.push_back(occlusion ? m_view.early(gpu, scenery.cullTable, scenery.world.gpuScene(), opaque)
                              : m_view.all(gpu, scenery.cullTable, scenery.world.gpuScene(), opaque));
    m_counts = m_view.counts();
    if (scenery.world.models().blends())
        lists.push_back(scenery.world.draws(gpu.stream(), only(request, CULL_BLENDS), blended));
    return lists;
}

DrawList ViewChooser::chooseRest(GpuFrame& gpu, Scenery& scenery, const CullRequest& request, const gl::Texture& pyramid)
{
    return m_view.late(gpu, scenery.cullTable, scenery.world.gpuScene(), without(request, CULL_BLENDS), pyramid);
}

} // namespace renderer
