// Brushes that grow grass: like painting, but on the map of grass, whose texels are its own.
#include "editor/brush.h"
#include "io/base/contract.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

constexpr float kNothing = 0.5f / 255; // less than a texel can hold
constexpr float kSoft = 4;             // degrees, over which a limit of the slope fades

// Where the brush may change the ground.
float allowedAt(const io::HeightMap& map, const Brush& brush, const glm::dvec2& place)
{
    const auto height = map.height(place.x, place.y);
    if (!height || *height < double(brush.altitude.x) || *height > double(brush.altitude.y)) return 0;
    if (brush.slope.x <= 0 && brush.slope.y >= 90) return 1;
    const float slope = glm::degrees(std::acos(std::clamp(float(map.normal(place.x, place.y)->y), -1.0f, 1.0f)));
    const float above = brush.slope.x <= 0 ? 1 : std::clamp((slope - brush.slope.x) / kSoft + 0.5f, 0.0f, 1.0f);
    const float below = brush.slope.y >= 90 ? 1 : std::clamp((brush.slope.y - slope) / kSoft + 0.5f, 0.0f, 1.0f);
    return above * below;
}

void mow(io::GrassCover& cover, int which, float share)
{
    float& density = cover.density[which];
    density *= 1 - share;
    if (density < kNothing) density = 0;
}

// A texel knows two kinds: a third takes the place of the sparser one.
int placeOf(const io::GrassCover& cover, int kind)
{
    for (const int i : {0, 1})
        if (cover.density[i] > 0 && cover.kind[i] == kind) return i;
    return cover.density[0] <= cover.density[1] ? 0 : 1;
}

} // namespace

io::GrassCover grown(io::GrassCover cover, const Brush& brush, float share)
{
    EXPECTS(growsGrass(brush.tool));
    const bool bare = cover.density[0] == 0 && cover.density[1] == 0;
    if (brush.tool == BrushTool::Mow) {
        for (const int i : {0, 1})
            if (brush.everyKind || cover.kind[i] == brush.kind) mow(cover, i, share);
        return cover;
    }
    if (brush.tool == BrushTool::GrassHeight) {
        if (!bare) cover.height += (brush.height - cover.height) * share;
        return cover;
    }
    const int place = placeOf(cover, brush.kind);
    if (cover.kind[place] != brush.kind) cover.density[place] = 0;
    cover.kind[place] = brush.kind;
    cover.density[place] += (brush.density - cover.density[place]) * share;
    cover.height = bare ? brush.height : cover.height + (brush.height - cover.height) * share;
    return cover;
}

std::optional<CoverPatch> growOn(const io::HeightMap& map, const io::GrassMap& grass, const Brush& brush, const Dab& dab, bool everywhere)
{
    EXPECTS(growsGrass(brush.tool));
    const double reach = everywhere ? 1e9 : double(brush.radius);
    const io::Texel low{glm::ceil((dab.centre - reach - grass.origin) / grass.metresPerTexel)};
    const io::Texel high{glm::floor((dab.centre + reach - grass.origin) / grass.metresPerTexel)};
    const io::TexelRect rect = common({low, high + io::Texel{1}}, grass.field().rect());
    if (rect.empty()) return std::nullopt;
    CoverPatch patch{glm::ivec2{rect.low}, glm::ivec2{rect.high - rect.low}, grass.field().read(rect)};
    for (int z = 0; z < patch.size.y; ++z)
        for (int x = 0; x < patch.size.x; ++x) {
            const glm::dvec2 place = grass.origin + glm::dvec2{patch.at + glm::ivec2{x, z}} * grass.metresPerTexel;
            float share = everywhere ? 1.0f : fading(brush, float(glm::distance(place, dab.centre) / double(brush.radius)));
            if (share > 0) share *= allowedAt(map, brush, place);
            if (share <= 0) continue;
            std::uint32_t& texel = patch.texels[std::size_t(z) * std::size_t(patch.size.x) + std::size_t(x)];
            texel = io::packed(grown(io::unpackedGrass(texel), brush, std::min(share * dab.amount, 1.0f)));
        }
    return patch;
}

} // namespace editor
