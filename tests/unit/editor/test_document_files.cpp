#include "tests/unit/editor/worlds.h"

#include "editor/arrange.h"
#include "editor/brush.h"
#include "editor/painting.h"
#include "io/files/atomic_file.h"
#include "io/files/height_map_file.h"
#include "io/files/image_file.h"
#include "io/files/png_file.h"
#include "io/files/model_file.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace editor;
namespace fs = std::filesystem;

namespace {

// A project of two templates and a ground in a folder that goes away with the test.
class DocumentFiles : public ::testing::Test {
protected:
    void SetUp() override
    {
        m_folder = fs::temp_directory_path() / ("wold_document_" + std::to_string(getpid()));
        fs::remove_all(m_folder);
        const fs::path project = m_folder / "project";
        fs::create_directories(project / "models");
        write(project / "models/blob.glb", io::encodeGlb(test::blob(2, 6)));
        write(project / "models/tip.glb", io::encodeGlb(test::pyramid(3)));
        io::Image heights{
            .size = {33, 33}, .channels = 1, .type = io::PixelType::U16, .bytes = std::vector<std::byte>(33 * 33 * 2)};
        heights.row<std::uint16_t>(16)[16] = 65535;
        fs::create_directories(project / "terrain");
        write(project / "terrain/h.png", io::encodePng(heights));

        io::World world;
        world.project = {
            .folder = project, .name = "Test", .scenes = {{"main", "scenes/main.scene.json"}}, .start = "main"};
        world.entry = world.project.scenes[0];
        world.environmentFile = "environments/main.json";
        const io::TemplateId blob = world.scene.templateSlot("blob");
        world.scene.exchange(blob, io::Template{.name = "blob", .model = "models/blob.glb"});
        world.scene.exchange(world.scene.freshId(), io::Object{.templateId = blob});
        world.scene.exchange(world.scene.freshId(),
                             io::Object{.templateId = blob, .transform = {.position = {3, 1, 2}}});
        world.scene.exchange(io::Terrain{.heightMap = "terrain/h.png", .origin = {-16, -16}, .maxHeight = 10});
        const auto saved = io::saveWorld(world);
        ASSERT_TRUE(saved) << saved.error().text();
        auto opened = Document::open(project);
        ASSERT_TRUE(opened) << opened.error().text();
        m_document = std::move(*opened);
    }
    void TearDown() override { fs::remove_all(m_folder); }

    static void write(const fs::path& file, const io::Result<std::string>& bytes)
    {
        ASSERT_TRUE(bytes);
        const io::Status written = io::writeFile(file, *bytes);
        ASSERT_TRUE(written);
    }
    std::string read(const char* file) const { return *io::readFile(m_folder / file); }

    fs::path m_folder;
    std::unique_ptr<Document> m_document;
};

} // namespace

TEST_F(DocumentFiles, OpensSavesAndReloads)
{
    EXPECT_TRUE(m_document->complaints().empty());
    EXPECT_FALSE(m_document->modified());
    const auto nothing = m_document->save();
    ASSERT_TRUE(nothing);
    EXPECT_TRUE(nothing->written.empty());

    const std::string before = read("project/scenes/main.scene.json");
    moveBy(*m_document, "Move", std::vector{io::ObjectId{2}}, {1, 0, 0});
    EXPECT_TRUE(m_document->modified());
    EXPECT_EQ(read("project/scenes/main.scene.json"), before); // until Save
    const auto saved = m_document->save();
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->written.size(), 1u);
    EXPECT_FALSE(m_document->modified());

    m_document->undo();
    EXPECT_TRUE(m_document->modified());
    ASSERT_TRUE(m_document->save());
    EXPECT_EQ(read("project/scenes/main.scene.json"), before);
    m_document->redo();
    ASSERT_TRUE(m_document->reload());
    EXPECT_FALSE(m_document->modified());
    EXPECT_FALSE(m_document->history().canUndo());
    EXPECT_EQ(m_document->scene().at(io::ObjectId{2}).transform.position, (glm::dvec3{3, 1, 2}));
    EXPECT_TRUE(m_document->takeChanges().everything);
}

TEST_F(DocumentFiles, SaveAsMakesAWholeProjectElsewhereAndGoesOnThere)
{
    moveBy(*m_document, "Move", std::vector{io::ObjectId{2}}, {1, 0, 0});
    const std::string before = read("project/scenes/main.scene.json");
    const auto saved = m_document->saveAs(m_folder / "copy");
    ASSERT_TRUE(saved) << saved.error().text();
    EXPECT_FALSE(m_document->modified());
    EXPECT_EQ(m_document->project().folder, m_folder / "copy");
    EXPECT_EQ(read("project/scenes/main.scene.json"), before);
    EXPECT_EQ(read("copy/models/blob.glb"), read("project/models/blob.glb"));
    const auto opened = Document::open(m_folder / "copy");
    ASSERT_TRUE(opened);
    EXPECT_TRUE(io::sameContent((*opened.value()).scene(), m_document->scene()));
}

TEST_F(DocumentFiles, SaveAsRefusesPlacesThatWouldHurt)
{
    moveBy(*m_document, "Move", std::vector{io::ObjectId{2}}, {1, 0, 0});
    EXPECT_FALSE(m_document->saveAs(m_folder / "project"));
    EXPECT_FALSE(m_document->saveAs(m_folder / "project" / "inside"));
    EXPECT_FALSE(m_document->saveAs(m_folder)); // not empty
    EXPECT_FALSE(m_document->saveAs("/proc/nowhere/at/all"));
    EXPECT_TRUE(m_document->modified());
    EXPECT_EQ(m_document->project().folder, m_folder / "project");
    std::size_t entries = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator{m_folder})
        ++entries;
    EXPECT_EQ(entries, 1u);
}

TEST_F(DocumentFiles, ATemplatesModelFollowsItsFileNameThroughUndo)
{
    m_document->takeChanges();
    const std::size_t before = m_document->assets().models[0]->triangles();
    io::Template changed = *m_document->scene().find(io::TemplateId{1});
    changed.model = "models/tip.glb";
    setTemplate(*m_document, "Model", io::TemplateId{1}, changed);
    EXPECT_EQ(m_document->assets().models[0]->triangles(), 6u);
    EXPECT_EQ(m_document->takeChanges().templates, std::vector{io::TemplateId{1}});
    m_document->undo();
    EXPECT_EQ(m_document->assets().models[0]->triangles(), before);

    const auto same = m_document->assets().models[0];
    changed = *m_document->scene().find(io::TemplateId{1});
    changed.sink = 1;
    setTemplate(*m_document, "Sink", io::TemplateId{1}, changed);
    EXPECT_EQ(m_document->assets().models[0], same); // not read again
}

TEST_F(DocumentFiles, TheGroundFollowsItsSettingsThroughUndo)
{
    EXPECT_NEAR(*m_document->scene().heights()->height(0, 0), 10, 0.01);
    io::Terrain terrain = m_document->scene().terrain();
    terrain.maxHeight = 40;
    ASSERT_TRUE(setTerrain(*m_document, "Height", terrain));
    EXPECT_NEAR(*m_document->scene().heights()->height(0, 0), 40, 0.01);
    terrain.heightMap = "";
    ASSERT_TRUE(setTerrain(*m_document, "No ground", terrain));
    EXPECT_EQ(m_document->scene().heights(), nullptr);
    m_document->goTo(0);
    EXPECT_NEAR(*m_document->scene().heights()->height(0, 0), 10, 0.01);
}

TEST_F(DocumentFiles, AHeightMapThatCannotBeReadLeavesTheGround)
{
    const auto before = m_document->scene().heights();
    ASSERT_TRUE(io::writeFile(m_document->project().folder / "terrain/none.png", "no picture at all"));
    for (const char* file : {"terrain/none.png", "terrain/missing.png"}) {
        io::Terrain terrain = m_document->scene().terrain();
        terrain.heightMap = file;
        const io::Status set = setTerrain(*m_document, "Other", terrain);
        ASSERT_FALSE(set);
        EXPECT_NE(set.error().text().find(file), std::string::npos);
    }
    EXPECT_EQ(m_document->scene().heights(), before);
    EXPECT_NE(m_document->scene().terrain().heightMap, "terrain/missing.png");
    EXPECT_FALSE(m_document->history().canUndo());
}

TEST_F(DocumentFiles, ShapedGroundIsSavedWithTheRestAndComesBack)
{
    const fs::path file = m_document->project().folder / m_document->scene().terrain().heightMap;
    const auto bytes = io::readFile(file);
    ASSERT_TRUE(m_document->save());
    EXPECT_EQ(*io::readFile(file), *bytes); // nothing was shaped: not a byte is written
    EXPECT_FALSE(m_document->modified());

    const auto shape = [&](float amount) {
        const auto patch = dabOn(*m_document->scene().heights(), {.radius = 2}, {.centre = {1, 1}, .amount = amount});
        ASSERT_TRUE(patch);
        setHeights(*m_document, "Raise", std::make_shared<const io::HeightMap>(m_document->scene().heights()->with(patch->heights, patch->at)),
                   patch->rect());
    };
    shape(-3);
    EXPECT_TRUE(m_document->modified());
    const auto saved = m_document->save();
    ASSERT_TRUE(saved);
    EXPECT_NE(std::ranges::find(saved->written, fs::path{m_document->scene().terrain().heightMap}), saved->written.end());
    const double step = (m_document->scene().terrain().maxHeight - m_document->scene().terrain().minHeight) / 65535;
    const double height = *m_document->scene().heights()->height(1, 1);
    ASSERT_TRUE(m_document->reload());
    EXPECT_NEAR(*m_document->scene().heights()->height(1, 1), height, step);
    EXPECT_FALSE(m_document->modified());

    shape(500); // above what the file could hold: its range grows, and nothing is cut off
    const double top = *m_document->scene().heights()->height(1, 1);
    ASSERT_TRUE(m_document->save());
    EXPECT_GE(m_document->scene().terrain().maxHeight, top);
    EXPECT_NEAR(*m_document->scene().heights()->height(1, 1), top, 1e-3);
    ASSERT_TRUE(m_document->reload());
    EXPECT_NEAR(*m_document->scene().heights()->height(1, 1), top, 0.02);
}

TEST_F(DocumentFiles, UndoAcrossASaveThatMovedTheRangeDoesNotMoveTheGround)
{
    const auto patch = dabOn(*m_document->scene().heights(), {.radius = 2}, {.centre = {1, 1}, .amount = 70});
    setHeights(*m_document, "Raise", std::make_shared<const io::HeightMap>(m_document->scene().heights()->with(patch->heights, patch->at)),
               patch->rect());
    io::Terrain terrain = m_document->scene().terrain();
    terrain.layers.push_back({.name = "more"});
    ASSERT_TRUE(setTerrain(*m_document, "Layer", terrain)); // holds the range from before the save
    const double top = *m_document->scene().heights()->height(1, 1);
    ASSERT_TRUE(m_document->save());
    m_document->undo();
    ASSERT_TRUE(m_document->save());
    ASSERT_TRUE(m_document->reload());
    EXPECT_NEAR(*m_document->scene().heights()->height(1, 1), top, 0.01);
}

TEST_F(DocumentFiles, PaintThatWasUndoneAndDoneAgainIsWritten)
{
    io::Terrain terrain = m_document->scene().terrain();
    terrain.layers = {{.name = "one"}, {.name = "two"}};
    ASSERT_TRUE(setTerrain(*m_document, "Layers", terrain));
    const auto fill = [&] { fillCover(*m_document, "Fill", {.tool = BrushTool::Paint, .layer = 1}); };
    fill();
    ASSERT_TRUE(m_document->save());
    m_document->undo();
    fill(); // the file of the first one is still there, so another is made
    ASSERT_TRUE(m_document->save());
    const io::CoverMap painted = *m_document->scene().cover();
    ASSERT_TRUE(m_document->reload());
    ASSERT_NE(m_document->scene().cover(), nullptr);
    EXPECT_EQ(*m_document->scene().cover(), painted);
}

TEST_F(DocumentFiles, AnotherHeightMapIsFollowedByMirrorsAndNotWritten)
{
    const fs::path first = m_document->project().folder / m_document->scene().terrain().heightMap;
    const fs::path second = first.parent_path() / "other.png";
    const auto size = m_document->scene().heights()->size;
    io::HeightGrid slope{.size = size};
    for (int i = 0; i < size.x * size.y; ++i)
        slope.metres.push_back(float(i % size.x));
    const io::Terrain before = m_document->scene().terrain();
    ASSERT_TRUE(io::writeHeightMap16(second, slope, before.minHeight, before.maxHeight));
    const auto bytes = io::readFile(second);
    Picker picker;
    test::followed(picker, *m_document).prepare();
    const auto agrees = [&] {
        const io::HeightMap& map = *m_document->scene().heights();
        const glm::dvec2 at = map.origin + glm::dvec2{map.size - 1} * map.metresPerTexel * 0.7;
        const PickHit hit = test::followed(picker, *m_document).pick({.origin = {at.x, 1e4, at.y}, .direction = {0, -1, 0}}, {.objects = false});
        return hit.surface == Surface::Terrain && std::abs(hit.position.y - *map.height(at.x, at.y)) < 1e-3;
    };
    io::Terrain terrain = before;
    terrain.heightMap = "terrain/other.png";
    ASSERT_TRUE(setTerrain(*m_document, "Other", terrain));
    EXPECT_FALSE(m_document->scene().heights()->sameHeights(io::HeightMap{io::HeightGrid{.size = size, .metres = std::vector<float>(slope.metres.size(), 10)}}));
    EXPECT_TRUE(agrees());
    ASSERT_TRUE(m_document->save());
    EXPECT_EQ(*io::readFile(second), *bytes);
    m_document->undo();
    EXPECT_TRUE(agrees());
    EXPECT_NEAR(*m_document->scene().heights()->height(0, 0), 10, 0.01);
}

TEST_F(DocumentFiles, ShapedGroundIsScaledAndUndone)
{
    const auto patch = dabOn(*m_document->scene().heights(), {.radius = 3}, {.centre = {1, 1}, .amount = -5});
    setHeights(*m_document, "Lower", std::make_shared<const io::HeightMap>(m_document->scene().heights()->with(patch->heights, patch->at)),
               patch->rect());
    const auto shaped = m_document->scene().heights();
    io::Terrain terrain = m_document->scene().terrain();
    const double low = terrain.minHeight, factor = 3;
    terrain.maxHeight = low + (terrain.maxHeight - low) * factor;
    ASSERT_TRUE(setTerrain(*m_document, "Height", terrain));
    EXPECT_NEAR(*m_document->scene().heights()->height(1, 1), low + (*shaped->height(1, 1) - low) * factor, 1e-4);
    m_document->undo();
    EXPECT_TRUE(m_document->scene().heights()->sameHeights(*shaped));
    terrain.metresPerTexel = 7;
    terrain.maxHeight = m_document->scene().terrain().maxHeight;
    ASSERT_TRUE(setTerrain(*m_document, "Wider", terrain));
    EXPECT_EQ(m_document->scene().heights()->metresPerTexel, 7);
    m_document->goTo(0);
    EXPECT_NE(m_document->scene().heights()->metresPerTexel, 7);
    EXPECT_FALSE(m_document->scene().heights()->sameHeights(*shaped));
}

TEST_F(DocumentFiles, WhatCannotBeOpenedIsAnErrorWithItsPlace)
{
    const auto missing = Document::open(m_folder / "nowhere");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().text().find("nowhere"), std::string::npos);
    io::Template changed = *m_document->scene().find(io::TemplateId{1});
    changed.model = "models/none.glb";
    setTemplate(*m_document, "Model", io::TemplateId{1}, changed);
    EXPECT_FALSE(m_document->complaints().empty());
    EXPECT_NE(m_document->assets().models[0], nullptr); // a stand-in
}
