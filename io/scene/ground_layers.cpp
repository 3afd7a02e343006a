#include "io/scene/ground_layers.h"

#include <algorithm>
#include <cmath>

namespace io {
namespace {

// Rises at the low end and falls at the high one, each over twice the half width; ends of the scale have no border.
float ramps(float value, const glm::vec2& range, float half, const glm::vec2& scale)
{
    const auto ramp = [&](float above) { return std::clamp(0.5f + above * 0.5f / half, 0.0f, 1.0f); };
    const float low = range.x > scale.x ? ramp(value - range.x) : 1, high = range.y < scale.y ? ramp(range.y - value) : 1;
    return low * high;
}

float flowAt(const GroundFlow& flow, const glm::dvec2& from)
{
    const glm::ivec2 cell = glm::clamp(glm::ivec2{glm::round(from / flow.cell)}, glm::ivec2{0}, flow.size - 1);
    return flow.values[std::size_t(cell.y) * flow.size.x + cell.x];
}

} // namespace

GroundLayers::GroundLayers(std::shared_ptr<const HeightMap> heights, std::shared_ptr<const CoverMap> cover, std::vector<TerrainLayer> layers)
    : m_heights{std::move(heights)}, m_cover{std::move(cover)}, m_layers{std::move(layers)}
{
    if (m_layers.size() > kMostLayers) m_layers.resize(kMostLayers);
    if (std::ranges::any_of(m_layers, [](const TerrainLayer& layer) { return layer.flow != glm::vec2{0, 1}; })) m_flow = flowOf(*m_heights);
    if (m_cover && m_cover->size() != m_heights->size) m_cover = nullptr;
}

float GroundLayers::byRule(const TerrainLayer& layer, float slope, float altitude, float flow) const
{
    const float blend = std::max(layer.blend, 1e-3f);
    float share = ramps(slope, layer.slope, blend * 7.5f, {0, 90}) * ramps(altitude, layer.altitude, blend * 20, {-1e5f, 1e5f});
    if (m_flow) share *= ramps(flow, layer.flow, blend * 0.1f, {0, 1});
    return share * share * (3 - 2 * share);
}

GroundLayers::Shares GroundLayers::at(double x, double z) const
{
    Shares shares{};
    const auto height = m_heights->height(x, z);
    const auto normal = m_heights->normal(x, z);
    if (!height || !normal) return shares;
    const auto slope = float(glm::degrees(std::acos(glm::clamp(normal->y, 0.0, 1.0))));
    const float flow = m_flow ? flowAt(*m_flow, glm::dvec2{x, z} - m_heights->origin) : 0;
    float left = 1; // that no layer above has taken
    for (std::size_t i = m_layers.size(); i-- > 0;) {
        shares[i] = byRule(m_layers[i], slope, float(*height), flow) * left;
        left -= shares[i];
    }
    if (m_cover) showPainted(shares, x, z);
    return shares;
}

void GroundLayers::showPainted(Shares& shares, double x, double z) const
{
    const glm::dvec2 texel = (glm::dvec2{x, z} - m_heights->origin) / m_heights->metresPerTexel;
    const glm::ivec2 low = glm::clamp(glm::ivec2{texel}, glm::ivec2{0}, m_heights->size - 2);
    const glm::vec2 f{texel - glm::dvec2{low}};
    Shares painted{};
    float rules = 0;
    for (int i = 0; i < 4; ++i) {
        const glm::ivec2 corner{i & 1, i >> 1};
        const float weight = (corner.x ? f.x : 1 - f.x) * (corner.y ? f.y : 1 - f.y);
        const Cover cover = unpacked(m_cover->at(low.x + corner.x, low.y + corner.y));
        rules += weight * (1 - cover.painted);
        painted[std::size_t(cover.base)] += weight * cover.painted * (1 - cover.share);
        painted[std::size_t(cover.over)] += weight * cover.painted * cover.share;
    }
    for (std::size_t i = 0; i < shares.size(); ++i)
        shares[i] = shares[i] * rules + painted[i];
}

} // namespace io
