// What a click finds is what one sees: rays against the id buffer of the drawn picture.
#include "editor/picker.h"
#include "tests/golden/valley.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

namespace test {
namespace {

constexpr glm::ivec2 kSize{960, 540};
constexpr int kPoints = 1000;

struct IdBuffer {
    std::vector<std::uint32_t> ids;

    std::uint32_t at(glm::ivec2 p) const { return ids[std::size_t(p.y) * kSize.x + std::size_t(p.x)]; }
    // Where a neighbour is another thing, a pixel's middle and a triangle's edge are a matter of rounding.
    bool isSilhouette(glm::ivec2 p) const
    {
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                const glm::ivec2 q = glm::clamp(p + glm::ivec2{x, y}, glm::ivec2{0}, kSize - 1);
                if (at(q) != at(p)) return true;
            }
        return false;
    }
};

std::uint32_t idOf(const editor::PickHit& hit)
{
    if (hit.surface == editor::Surface::Terrain) return renderer::kTerrainId;
    return io::number(hit.id); // 0 for none
}

struct Tally {
    int compared = 0, agreed = 0, silhouettes = 0, silhouettesAgreed = 0;
    std::string disagreements;
};

void compareAt(const std::string& camera, const editor::Picker& picker, Tally& tally)
{
    valley().renderer().render({.camera = valley().camera(camera), .size = kSize});
    const IdBuffer buffer{valley().renderer().readIds({0, 0}, kSize)};
    const editor::View view{.camera = valley().camera(camera), .size = kSize};
    std::mt19937 dice{7};
    for (int i = 0; i < kPoints; ++i) {
        const glm::ivec2 pixel{dice() % unsigned(kSize.x), dice() % unsigned(kSize.y)};
        const std::uint32_t seen = buffer.at(pixel), picked = idOf(picker.pick(view, glm::dvec2{pixel} + 0.5));
        if (buffer.isSilhouette(pixel)) {
            ++tally.silhouettes;
            tally.silhouettesAgreed += seen == picked;
            continue;
        }
        ++tally.compared;
        tally.agreed += seen == picked;
        if (seen != picked)
            tally.disagreements +=
                fmt::format("\n  {} at {},{}: seen {:#x}, picked {:#x}", camera, pixel.x, pixel.y, seen, picked);
    }
}

TEST(Picking, findsWhatIsSeen)
{
    editor::Picker picker;
    picker.update(valley().document->scene(), valley().document->assets(), {.everything = true});
    Tally tally;
    for (const io::Camera& camera : valley().document->scene().cameras())
        compareAt(camera.name, picker, tally);
    fmt::print("picking: {} of {} agree, at silhouettes {} of {}{}\n", tally.agreed, tally.compared,
               tally.silhouettesAgreed, tally.silhouettes, tally.disagreements);
    EXPECT_GE(tally.agreed, 0.99 * tally.compared) << tally.disagreements;
    EXPECT_GE(tally.compared, 300);
}

} // namespace
} // namespace test
