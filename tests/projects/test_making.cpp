#include "projects/make/models.h"
#include "projects/make/noise.h"
#include "projects/make/random.h"
#include "projects/make/shapes.h"
#include "projects/make/terrain_forms.h"

#include "io/files/atomic_file.h"
#include "io/files/model_file.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace {

TEST(Making, OneModelIsTheBytesThatAreCommitted)
{
    make::Textures textures;
    const io::Result<std::string> made = io::encodeGlb(make::buildModel("rock_small", textures));
    ASSERT_TRUE(made);
    const io::Result<std::string> committed =
        io::readFile(std::filesystem::path{WOLD_SOURCE_DIR} / "projects/valley/models/rock_small.glb");
    ASSERT_TRUE(committed);
    EXPECT_TRUE(*made == *committed) << "run wold-make-worlds projects, look at the pictures, and commit both";
}

TEST(Making, RandomNumbersAreThoseOfPcg32)
{
    make::Random random{42, 54}; // the first numbers of the reference implementation's demo
    EXPECT_EQ(random.next(), 0xa15c02b7u);
    EXPECT_EQ(random.next(), 0x7b47f409u);
    EXPECT_EQ(random.next(), 0xba1d3330u);
}

TEST(Making, NoiseWithAPeriodTiles)
{
    for (float x = 0.13f; x < 4; x += 0.37f) {
        const glm::vec2 p{x, 3.7f - x};
        EXPECT_NEAR(make::noise(p, 7, {4, 3}), make::noise(p + glm::vec2{4, -3}, 7, {4, 3}), 1e-5f);
        EXPECT_EQ(make::cells(p, 7, {4, 3}).id, make::cells(p + glm::vec2{8, 3}, 7, {4, 3}).id);
    }
}

TEST(Making, RefiningHitsTheCountAndKeepsTheShape)
{
    const auto areaOf = [](const make::Mesh& mesh) {
        double area = 0;
        for (const make::Triangle& t : mesh.triangles())
            area += 0.5 * glm::length(glm::cross(t.corners[1].position - t.corners[0].position,
                                                 t.corners[2].position - t.corners[0].position));
        return area;
    };
    for (const std::size_t count : {12u, 13u, 40u, 41u, 1000u}) {
        make::Mesh mesh;
        make::addBeam(mesh, {.from = {0, 0, 0}, .to = {2, 0, 0}, .width = 0.4f, .height = 0.3f});
        make::Triangle flag; // an open border, so that odd counts can be reached
        flag.corners[1].position = {0, 5, 0};
        flag.corners[2].position = {0, 5, 1};
        if (count % 2 == 1) mesh.add(flag);
        const double before = areaOf(mesh);
        make::refineTo(mesh, count);
        EXPECT_EQ(mesh.count(), count);
        EXPECT_NEAR(areaOf(mesh), before, 1e-4);
    }
}

TEST(Making, EveryModelIsSound)
{
    for (const std::span<const make::Entry> entries : {make::valleyEntries(), make::forestEntries()})
        for (const make::Entry& entry : entries) {
            const make::Mesh mesh = entry.build();
            ASSERT_GT(mesh.count(), 0u) << entry.name;
            for (const make::Triangle& t : mesh.triangles()) {
                ASSERT_LT(t.surface, int(mesh.surfaces().size())) << entry.name;
                for (const io::Vertex& corner : t.corners) {
                    ASSERT_NEAR(glm::length(corner.normal), 1, 1e-3) << entry.name;
                    ASSERT_LT(glm::length(corner.position), 40) << entry.name;
                    ASSERT_FALSE(glm::any(glm::isnan(corner.uv0))) << entry.name;
                }
            }
        }
}

TEST(Making, ValleyTreesAreLightEnoughForSoftwareDrawing)
{
    for (const make::Entry& entry : make::valleyEntries())
        if (entry.category == "Trees") {
            EXPECT_LT(entry.build().count(), 1250u) << entry.name;
        }
}

TEST(Making, DoublingKeepsTheOldTexels)
{
    io::HeightGrid coarse = make::blankHeights(9, 2);
    make::fill(coarse, [](glm::vec2 p) { return make::noise(p, 3) * 5; });
    const io::HeightGrid fine = make::doubled(coarse);
    EXPECT_EQ(fine.size, glm::ivec2{17});
    EXPECT_EQ(fine.origin, coarse.origin);
    for (int z = 0; z < 9; ++z)
        for (int x = 0; x < 9; ++x)
            EXPECT_EQ(fine.at(2 * x, 2 * z), coarse.at(x, z));
}

} // namespace
