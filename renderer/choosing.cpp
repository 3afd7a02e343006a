#include "renderer/choosing.h"

#include "renderer/gl/machine.h"

namespace renderer {
namespace {

CullRequest without(CullRequest request, std::uint32_t flags)
{
    request.refused |= flags;
    return request;
}

std::uint32_t visible(std::span<const DrawList> lists)
{
    std::uint64_t count = 0;
    for (const DrawList& list : lists)
        count += list.visible;
    return std::uint32_t(count);
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
        scenery.world.batchedDraws(gpu.stream(), request, blended, lists);
        scenery.world.directDraws(gpu.stream(), request, blended, lists);
        m_counts = {.drawn = visible(lists)};
        return lists;
    }
    const ModelLibrary& models = scenery.world.sharedModels();
    scenery.cullTable.update(models);
    const CullRequest opaque = without(request, CULL_BLENDS);
    lists.push_back(occlusion ? m_view.early(gpu, scenery.cullTable, scenery.world.gpuScene(), opaque)
                              : m_view.all(gpu, scenery.cullTable, scenery.world.gpuScene(), opaque));
    lists.back().models = &models;
    m_counts = m_view.counts();
    if (models.blends()) scenery.world.batchedDraws(gpu.stream(), only(request, CULL_BLENDS), blended, lists);
    scenery.world.directDraws(gpu.stream(), request, blended, lists);
    m_counts.drawn += visible(lists); // the first list's are the GPU's to count
    return lists;
}

DrawList ViewChooser::chooseRest(GpuFrame& gpu, Scenery& scenery, const CullRequest& request, const gl::Texture& pyramid)
{
    DrawList list = m_view.late(gpu, scenery.cullTable, scenery.world.gpuScene(), without(request, CULL_BLENDS), pyramid);
    list.models = &scenery.world.sharedModels();
    return list;
}

} // namespace renderer
