#include "renderer/choosing.h"

#include "renderer/gl/machine.h"

#include <numeric>

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
                                          const Settings& settings, Occlusion occlusion)
{
    std::vector<DrawList> lists;
    const bool blended = !request.towardSun; // glass casts no shadow
    if (!culledOnGpu(settings)) {
        m_counts = scenery.world.batchedDraws(gpu.stream(), request, blended, lists);
        addTo(m_counts, scenery.world.directDraws(gpu.stream(), request, blended, lists));
        return lists;
    }
    lists.push_back(opaqueOnGpu(gpu, scenery, without(request, CULL_BLENDS), occlusion));
    m_counts = m_view.counts();
    gpu.count(0, std::accumulate(std::begin(m_counts.triangles), std::end(m_counts.triangles), std::uint64_t(0)));
    if (scenery.world.sharedModels().blends())
        addTo(m_counts, scenery.world.batchedDraws(gpu.stream(), only(request, CULL_BLENDS), blended, lists));
    addTo(m_counts, scenery.world.directDraws(gpu.stream(), request, blended, lists));
    return lists;
}

DrawList ViewChooser::opaqueOnGpu(GpuFrame& gpu, Scenery& scenery, const CullRequest& request, Occlusion occlusion)
{
    const ModelLibrary& models = scenery.world.sharedModels();
    scenery.cullTable.update(models);
    const GpuCullScene scene = scenery.world.gpuScene();
    DrawList list;
    if (occlusion == Occlusion::SeenBefore) list = m_view.early(gpu, scenery.cullTable, scene, request);
    else if (occlusion == Occlusion::Kept) list = m_view.kept(gpu, scenery.cullTable, scene, request);
    else list = m_view.all(gpu, scenery.cullTable, scene, request);
    list.models = &models;
    return list;
}

DrawList ViewChooser::chooseRest(GpuFrame& gpu, Scenery& scenery, const CullRequest& request, const gl::Texture& pyramid)
{
    DrawList list = m_view.late(gpu, scenery.cullTable, scenery.world.gpuScene(), without(request, CULL_BLENDS), pyramid);
    list.models = &scenery.world.sharedModels();
    return list;
}

} // namespace renderer
