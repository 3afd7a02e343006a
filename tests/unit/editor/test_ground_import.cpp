// A height map becomes the ground as one step; one that does not fit changes nothing unless it is forced to.
#include "tests/support/program.h"
#include "tests/unit/editor/worlds.h"

#include "editor/ground_import.h"
#include "editor/painting.h"
#include "editor/script.h"
#include "io/files/atomic_file.h"
#include "io/files/height_map_file.h"
#include "io/files/image_file.h"
#include "io/files/json.h"
#include "io/files/png_file.h"

#include <filesystem>
#include <gtest/gtest.h>

using namespace editor;
namespace fs = std::filesystem;

namespace {

io::HeightGrid slope(glm::ivec2 size, float step)
{
    io::HeightGrid grid{.size = size};
    for (int z = 0; z < size.y; ++z)
        for (int x = 0; x < size.x; ++x)
            grid.metres.push_back(float(x + z) * step);
    return grid;
}

class GroundImport : public ::testing::Test {
protected:
    test::Folder m_folder;
    fs::path m_project = m_folder.path() / "project";
    std::unique_ptr<Document> m_document;

    void SetUp() override
    {
        fs::create_directories(m_project / "terrain");
        ASSERT_TRUE(io::writeHeightMap16(m_project / "terrain/h.png", slope({33, 33}, 0.1f), 0, 10));
        io::World world;
        world.project = {.folder = m_project, .name = "Test", .scenes = {{"main", "scenes/main.scene.json"}}, .start = "main"};
        world.entry = world.project.scenes[0];
        world.environmentFile = "environments/main.json";
        world.scene.exchange(io::Terrain{.heightMap = "terrain/h.png", .origin = {-16, -16}, .maxHeight = 10, .layers = {{.name = "grass"}, {.name = "rock"}}});
        ASSERT_TRUE(io::saveWorld(world));
        auto opened = Document::open(m_project);
        ASSERT_TRUE(opened) << opened.error().text();
        m_document = *std::move(opened);
    }
    std::string heightMap(const char* name, glm::ivec2 size, double low, double high)
    {
        EXPECT_TRUE(io::writeHeightMap16(m_folder.path() / name, slope(size, 0.05f), low, high));
        return m_folder / name;
    }
    io::Result<HeightImportReport> import(const std::string& file, bool force = false, io::HeightMeasures measures = {})
    {
        return importHeights(*m_document, "Import heights", {.file = file, .measures = measures, .force = force});
    }
    const io::Scene& scene() { return m_document->scene(); }
};

TEST_F(GroundImport, WhatFitsTakesItsPlaceAndIsOneStep)
{
    const auto before = scene().heights();
    const auto report = import(heightMap("new.png", {33, 33}, 0, 10));
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_TRUE(report->differences.empty());
    EXPECT_EQ(scene().terrain().heightMap, "terrain/new.png");
    EXPECT_EQ(scene().terrain().origin, glm::dvec2(-16, -16));
    EXPECT_NEAR(scene().heights()->at(10, 10), 1, 1e-3);
    EXPECT_EQ(m_document->history().names(), std::vector<std::string>{"Import heights"});
    EXPECT_FALSE(fs::exists(m_project / "terrain/new.png")); // until Save

    m_document->undo();
    EXPECT_EQ(*scene().heights(), *before);
    EXPECT_EQ(scene().terrain().heightMap, "terrain/h.png");
    m_document->redo();
    const std::string text = test::text(scene());
    ASSERT_TRUE(m_document->save());
    EXPECT_EQ(io::readImage(m_project / "terrain/new.png")->bytes, io::readImage(m_folder / "new.png")->bytes);
    const auto again = Document::open(m_project);
    ASSERT_TRUE(again);
    EXPECT_EQ(test::text((*again)->scene()), text);
    EXPECT_EQ(*(*again)->scene().heights(), *scene().heights());
}

TEST_F(GroundImport, WhatDoesNotFitChangesNothingUnlessForced)
{
    const auto before = scene().heights();
    const std::string text = test::text(scene()), file = heightMap("new.png", {65, 65}, 0, 10);
    const auto refused = import(file, false, {.metresPerTexel = 2, .heights = glm::dvec2{-5, 20}});
    ASSERT_FALSE(refused);
    for (const char* word : {"new.png", "65 x 65 texels, not 33 x 33", "2 m a texel, not 1", "heights -5 … 20 m, not 0 … 10 m", "nothing was changed", "force"})
        EXPECT_NE(refused.error().text().find(word), std::string::npos) << word << ": " << refused.error().text();
    EXPECT_EQ(scene().heights(), before);
    EXPECT_EQ(test::text(scene()), text);
    EXPECT_FALSE(m_document->modified());

    const auto done = import(file, true, {.metresPerTexel = 2, .heights = glm::dvec2{-5, 20}});
    ASSERT_TRUE(done) << done.error().text();
    EXPECT_EQ(done->differences.size(), 3u);
    EXPECT_EQ(scene().heights()->size, glm::ivec2(65));
    EXPECT_EQ(scene().heights()->origin, glm::dvec2(-64, -64));
    EXPECT_EQ(scene().heights()->metresPerTexel, 2);
    EXPECT_EQ(scene().terrain().layers.size(), 2u); // layers stay
    m_document->undo();
    EXPECT_EQ(*scene().heights(), *before);
    EXPECT_EQ(scene().heights()->metresPerTexel, 1);
    EXPECT_EQ(test::text(scene()), text);
    m_document->redo();
    EXPECT_EQ(scene().heights()->origin, glm::dvec2(-64, -64));
}

TEST_F(GroundImport, BadFilesLeaveTheGround)
{
    const auto before = scene().heights();
    const std::string nan = m_folder.write("nan.r32", std::string(33 * 33 * 4, '\xff'));
    const std::string odd = m_folder.write("odd.raw", std::string(999, 'x'));
    const std::string text = m_folder.write("text.png", "no picture");
    const std::string good = heightMap("good.png", {33, 33}, 0, 10);
    for (const std::string& file : {nan, odd, text, m_folder / "missing.png"}) {
        const auto refused = import(file, true);
        ASSERT_FALSE(refused) << file;
        EXPECT_NE(refused.error().text().find(file), std::string::npos);
    }
    EXPECT_FALSE(import(good, true, {.metresPerTexel = 0}));
    EXPECT_FALSE(import(good, true, {.metresPerTexel = -3}));
    EXPECT_FALSE(import(good, true, {.heights = glm::dvec2{4, 4}}));
    EXPECT_EQ(scene().heights(), before);
    EXPECT_FALSE(m_document->modified());
}

TEST_F(GroundImport, FloatsAreKeptAsFloats)
{
    std::vector<float> metres(33 * 33, 3.3f);
    metres[7] = 9.000001f;
    const auto report = import(m_folder.write("f.r32", {reinterpret_cast<const char*>(metres.data()), metres.size() * 4}));
    ASSERT_TRUE(report) << report.error().text(); // within the two heights that are there
    EXPECT_EQ(scene().terrain().heightMap, "terrain/f.exr");
    ASSERT_TRUE(m_document->save());
    const auto again = Document::open(m_project);
    ASSERT_TRUE(again);
    EXPECT_EQ((*again)->scene().heights()->read({{0, 0}, {33, 33}}).metres, metres);
}

TEST_F(GroundImport, WhatWasPaintedIsKeptStretchedOrDropped)
{
    const auto paint = [&] {
        Brush brush{.tool = BrushTool::Paint, .layer = 1};
        const auto patch = paintOn(*scene().heights(), coverOf(scene()), brush, {.amount = 1}, true);
        changeCover(*m_document, "Paint", *patch);
    };
    paint();
    const auto painted = scene().cover();
    ASSERT_TRUE(import(heightMap("same.png", {33, 33}, 0, 10)));
    EXPECT_EQ(scene().cover(), painted);
    const auto larger = import(heightMap("larger.png", {65, 65}, 0, 10), true);
    ASSERT_TRUE(larger);
    EXPECT_EQ(larger->differences.back().then, "stretched");
    ASSERT_NE(scene().cover(), nullptr);
    EXPECT_EQ(scene().cover()->size(), glm::ivec2(65));
    EXPECT_EQ(scene().cover()->at(64, 64), painted->at(32, 32));
    const auto other = import(heightMap("other.png", {40, 20}, 0, 10), true);
    ASSERT_TRUE(other);
    EXPECT_EQ(other->differences.back().then, "dropped");
    EXPECT_EQ(scene().cover(), nullptr);
    EXPECT_EQ(scene().terrain().coverMap, "");
    ASSERT_TRUE(m_document->save());
    EXPECT_TRUE(io::checkProject(m_project).empty());
    m_document->undo();
    EXPECT_EQ(scene().cover()->size(), glm::ivec2(65));
    m_document->undo();
    m_document->undo();
    EXPECT_EQ(*scene().cover(), *painted);
    ASSERT_TRUE(m_document->save());
    EXPECT_TRUE(io::checkProject(m_project).empty());
}

TEST_F(GroundImport, FilesOfOthersAreNotOverwritten)
{
    const std::string old = test::textOf(m_project / "terrain/h.png");
    fs::create_directories(m_folder.path() / "out");
    const std::string file = heightMap("out/other.png", {33, 33}, 0, 10);
    fs::copy_file(m_project / "terrain/h.png", m_project / "terrain/other.png");
    ASSERT_TRUE(import(file));
    EXPECT_EQ(scene().terrain().heightMap, "terrain/other_2.png");
    ASSERT_TRUE(import(heightMap("out/h.png", {33, 33}, 0, 10))); // h.png is not the scene's any more
    EXPECT_EQ(scene().terrain().heightMap, "terrain/h_2.png");
    ASSERT_TRUE(m_document->save());
    ASSERT_TRUE(import(heightMap("out/h_2.png", {33, 33}, 0, 10)));
    EXPECT_EQ(scene().terrain().heightMap, "terrain/h_2.png"); // its own again
    ASSERT_TRUE(m_document->save());
    EXPECT_EQ(test::textOf(m_project / "terrain/h.png"), old);
}

TEST_F(GroundImport, ScriptsDoTheSame)
{
    Selection selection;
    Picker picker;
    View view;
    Script script{*m_document, selection, picker, view};
    const auto answer = [&](const std::string& line) { return script.execute(*io::parseJson(line, "line")); };
    const std::string file = heightMap("new.png", {65, 65}, 0, 10);
    const io::Value refused = answer(R"({"do":"import_heights","file":")" + file + R"("})");
    EXPECT_FALSE(*refused.find("ok")->asBool());
    EXPECT_NE(refused.find("error")->asString()->find("not 33 x 33"), std::string::npos);
    const io::Value done = answer(R"({"do":"import_heights","file":")" + file + R"(","heights":[-3,17],"metres_per_texel":0.5,"force":true})");
    ASSERT_TRUE(*done.find("ok")->asBool()) << io::writeJson(done);
    EXPECT_EQ(*done.find("height_map")->asString(), "terrain/new.png");
    EXPECT_EQ(*done.find("heights_from")->asString(), "given");
    const io::Value out = answer(R"({"do":"export_heights","out":")" + (m_folder / "out.png") + R"("})");
    ASSERT_TRUE(*out.find("ok")->asBool()) << io::writeJson(out);
    EXPECT_EQ(io::readImage(m_folder / "out.png")->bytes, io::readImage(file)->bytes);
    EXPECT_TRUE(*answer(R"({"do":"export_heights","out":")" + (m_folder / "out.glb") + R"(","step":4})").find("ok")->asBool());
    for (const char* wrong : {R"({"do":"import_heights"})", R"({"do":"import_heights","file":"x.png","sample":"u17"})", R"({"do":"import_heights","file":"x.png","size":[1,2]})",
                              R"({"do":"import_heights","file":"x.png","metres":3})", R"({"do":"export_heights","out":"x.png","step":3})",
                              R"({"do":"export_heights","out":"x.doc"})"})
        EXPECT_FALSE(*answer(wrong).find("ok")->asBool()) << wrong;
    EXPECT_EQ(*answer(R"({"do":"undo"})").find("undone")->asString(), "Import heights");
}

} // namespace
