// The ground as a glTF mesh, read back by our own reader.
#include "support.h"

#include "io/files/height_export.h"
#include "io/files/json.h"
#include "io/files/model_file.h"

#include <cmath>

namespace io {
namespace {

HeightMap hills(glm::ivec2 size)
{
    HeightGrid grid{.size = size, .metresPerTexel = 2, .origin = {-10, -20}};
    for (int z = 0; z < size.y; ++z)
        for (int x = 0; x < size.x; ++x)
            grid.metres.push_back(10 * std::sin(float(x) * 0.1f) + float(z) * 0.5f);
    return HeightMap{grid};
}

struct Mesh {
    TemporaryFolder folder;
    Result<MeshExport> done;
    Complaints complaints;
    Result<Model> model = Error{"", ""};

    Mesh(const HeightMap& map, int step, const char* name = "ground.glb", const CoverMap* cover = nullptr)
        : done{exportTerrainMesh(folder / name, map, cover, {.layers = {{.name = "grass", .colour = {0.1f, 0.2f, 0.3f}}}}, step)}
    {
        if (done) model = readModel(folder / name, folder.path(), complaints);
    }
};

TEST(TerrainMesh, IsTheGroundItself)
{
    const HeightMap map = hills({70, 40});
    for (const char* name : {"ground.glb", "gr ound.gltf"}) {
        const Mesh mesh{map, 1, name};
        ASSERT_TRUE(mesh.done) << mesh.done.error().text();
        ASSERT_TRUE(mesh.model) << mesh.model.error().text();
        EXPECT_TRUE(mesh.complaints.empty()) << listed(mesh.complaints);
        EXPECT_EQ(mesh.done->triangles, 69u * 39 * 2);
        EXPECT_EQ(mesh.model->indices.size(), mesh.done->triangles * 3);
        for (const Vertex& v : mesh.model->vertices) {
            const auto height = map.height(v.position.x, v.position.z);
            ASSERT_TRUE(height);
            ASSERT_NEAR(v.position.y, *height, 1e-4);
            ASSERT_NEAR(glm::length(v.normal), 1, 1e-3);
            ASSERT_GT(v.normal.y, 0.5f);
            ASSERT_NEAR(v.uv0.x, (v.position.x + 10) / 138, 1e-4);
            ASSERT_NEAR(v.uv0.y, (v.position.z + 20) / 78, 1e-4);
        }
        for (std::size_t i = 0; i < mesh.model->indices.size(); i += 3) { // all face up
            const auto at = [&](std::size_t k) { return mesh.model->vertices[mesh.model->indices[i + k]].position; };
            ASSERT_GT(glm::cross(at(1) - at(0), at(2) - at(0)).y, 0);
        }
    }
}

TEST(TerrainMesh, LargeGroundIsSplitAndThinned)
{
    const HeightMap map = hills({601, 300});
    const Mesh whole{map, 1};
    ASSERT_TRUE(whole.model);
    EXPECT_EQ(whole.done->tiles, 6);
    EXPECT_EQ(whole.done->triangles, 600u * 299 * 2);
    const Mesh thin{map, 7};
    ASSERT_TRUE(thin.model);
    EXPECT_EQ(thin.done->triangles, 86u * 43 * 2);
    Box bounds;
    for (const Vertex& v : thin.model->vertices)
        bounds.add(v.position);
    EXPECT_FLOAT_EQ(bounds.max.x, -10 + 600 * 2); // the last row and column are there, whatever the step
    EXPECT_FLOAT_EQ(bounds.max.z, -20 + 299 * 2);
    EXPECT_EQ(meshStep({4097, 4097}), 8);
    EXPECT_EQ(meshStep({513, 513}), 1);
    EXPECT_EQ(meshStep({2, 2}), 1);
    const HeightMap wide = hills({2, 2});
    EXPECT_TRUE(Mesh(wide, 100).done);
}

TEST(TerrainMesh, TooManyTrianglesAreRefusedWithAStep)
{
    const TemporaryFolder folder;
    const HeightMap map{HeightGrid{.size = {6000, 6000}, .metres = std::vector<float>(6000 * 6000)}};
    const auto done = exportTerrainMesh(folder / "g.glb", map, nullptr, {}, 1);
    ASSERT_FALSE(done);
    EXPECT_NE(done.error().what.find("a step of 2 texels"), std::string::npos) << done.error().what;
    EXPECT_FALSE(fs::exists(folder / "g.glb"));
    EXPECT_FALSE(exportTerrainMesh(folder / "g.obj", map, nullptr, {}, 8));
}

TEST(TerrainMesh, HolesAreLeftOut)
{
    const HeightMap map = hills({20, 20});
    std::vector<std::uint32_t> texels(400);
    for (int i : {45, 46, 65})
        texels[std::size_t(i)] = kHoleBit;
    const CoverMap cover{map.size, texels};
    const Mesh mesh{map, 1, "g.glb", &cover};
    ASSERT_TRUE(mesh.model) << mesh.model.error().text();
    EXPECT_EQ(mesh.done->triangles, (19u * 19 - 3) * 2);
    const CoverMap nothing{map.size, std::vector<std::uint32_t>(400, kHoleBit)};
    EXPECT_FALSE(Mesh(map, 1, "g.glb", &nothing).done);
}

} // namespace
} // namespace io
