// What a view draws of the objects, wherever that is found out: on the CPU where software draws, else on the GPU.
#pragma once

#include "renderer/gpu_culling.h"
#include "renderer/scenery.h"

#include <vector>

namespace renderer {

bool culledOnGpu(const Settings& settings);

enum class Occlusion {
    Off,
    SeenBefore, // only what the last frame saw; chooseRest() finds what came into sight
    Kept,       // what the last frame with SeenBefore saw, and no more
};

// One view's lists, of the batched path and of each direct model in view. On the GPU things that blend are still sorted
// by the CPU, in a list of their own, and direct models are culled there.
class ViewChooser {
public:
    explicit ViewChooser(ShaderLibrary& shaders) : m_view{shaders} {}

    std::vector<DrawList> choose(GpuFrame& gpu, Scenery& scenery, const CullRequest& request, const Settings& settings,
                                 Occlusion occlusion);
    DrawList chooseRest(GpuFrame& gpu, Scenery& scenery, const CullRequest& request, const gl::Texture& pyramid);
    const glsl::CullCounts& counts() const { return m_counts; } // of the GPU: of a frame a little earlier

private:
    DrawList opaqueOnGpu(GpuFrame& gpu, Scenery& scenery, const CullRequest& request, Occlusion occlusion);

    CulledView m_view;
    glsl::CullCounts m_counts{};
};

} // namespace renderer
