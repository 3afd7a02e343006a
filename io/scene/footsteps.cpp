#include "io/scene/footsteps.h"

#include <algorithm>

namespace io {
namespace {

constexpr double kFirstStep = 0.35; // m after standing still

} // namespace

// A person takes some 1.8 steps a second while walking and 2.8 while running.
double strideAt(float speed)
{
    return std::clamp(0.42 + 0.32 * double(speed), 0.5, 2.6);
}

std::string Footsteps::walk(const Scene& scene, const Feet& feet)
{
    if (feet.walked <= 0) {
        if (feet.speed <= 0) m_left = kFirstStep;
        return {};
    }
    m_left -= feet.walked;
    if (m_left > 0) return {};
    m_left = strideAt(feet.speed);
    return soundUnder(scene, feet);
}

std::string Footsteps::soundUnder(const Scene& scene, const Feet& feet)
{
    if (const Template* what = scene.find(feet.on)) {
        if (!what->steps.empty()) return what->steps;
    }
    const GroundLayers* layers = layersOf(scene);
    if (!layers) return {};
    const GroundLayers::Shares shares = layers->at(feet.at.x, feet.at.z);
    const std::size_t count = std::min(shares.size(), m_of.size());
    const auto most = std::max_element(shares.begin(), shares.begin() + std::ptrdiff_t(count));
    if (count == 0 || *most <= 0) return {};
    return m_of[std::size_t(most - shares.begin())].steps;
}

const GroundLayers* Footsteps::layersOf(const Scene& scene)
{
    const std::vector<TerrainLayer>& layers = scene.terrain().layers;
    const bool any = std::ranges::any_of(layers, [](const TerrainLayer& layer) { return !layer.steps.empty(); });
    if (!scene.heights() || !any) return nullptr;
    if (!m_layers || m_heights != scene.heights() || m_cover != scene.cover() || m_of != layers) {
        m_heights = scene.heights();
        m_cover = scene.cover();
        m_of = layers;
        m_layers = std::make_unique<const GroundLayers>(m_heights, m_cover, m_of);
    }
    return m_layers.get();
}

} // namespace io
