// What scripts do to the ground as a whole, and stamps.
#include "editor/script.h"
#include "io/files/image_file.h"
#include "io/files/json.h"
#include "tests/support/program.h"
#include "tests/support/small_world.h"
#include "tests/unit/editor/worlds.h"

#include <gtest/gtest.h>

using namespace editor;

namespace {

struct GroundScript : ::testing::Test {
    test::Folder folder;
    std::unique_ptr<Document> document;
    Selection selection;
    Picker picker;
    View view;
    std::unique_ptr<Script> script;

    GroundScript()
    {
        const std::filesystem::path project = folder.path() / "small";
        test::makeSmallWorld(project);
        document = *Document::open(project);
        script = std::make_unique<Script>(*document, selection, picker, view);
    }
    io::Value run(const std::string& line)
    {
        const io::Result<io::Value> command = io::parseJson(line, "script");
        EXPECT_TRUE(command) << line;
        return script->execute(*command);
    }
    bool ok(const std::string& line)
    {
        const io::Value answer = run(line);
        return answer.find("ok") && *answer.find("ok")->asBool();
    }
    const io::HeightMap& ground() { return *document->scene().heights(); }
};

TEST_F(GroundScript, GeneratesGroundThatIsSavedAndReadBack)
{
    const io::Value answer = run(R"({"do":"generate","seed":4,"width":129,"depth":97,"metres_per_texel":8,"highest":300,"origin":[-100,50]})");
    ASSERT_TRUE(answer.find("texels")) << io::writeJson(answer);
    EXPECT_EQ(ground().size, glm::ivec2(129, 97));
    EXPECT_EQ(ground().origin, glm::dvec2(-100, 50));
    EXPECT_EQ(document->history().position(), 1u);
    const io::HeightGrid made = ground().read(ground().texels());
    ASSERT_TRUE(ok(R"({"do":"save"})"));
    const auto again = Document::open(document->project().folder);
    ASSERT_TRUE(again);
    const io::HeightMap& read = *(*again)->scene().heights();
    ASSERT_EQ(read.size, ground().size);
    EXPECT_EQ(read.metresPerTexel, 8);
    for (int z = 0; z < read.size.y; ++z)
        for (int x = 0; x < read.size.x; ++x)
            ASSERT_NEAR(read.at(x, z), made.at(x, z), 300.0 / 65535);
}

TEST_F(GroundScript, ReshapesAndUndoes)
{
    const io::HeightMap before = ground();
    for (const char* line : {R"({"do":"resample","width":33})", R"({"do":"resample","metres_per_texel":0.5,"follow":false})", R"({"do":"crop","from":[-10,-10],"to":[12,8]})",
                             R"({"do":"crop","texels":true,"from":[0,0],"to":[20,20]})", R"({"do":"offset","by":[3,4],"edge":"wrap"})", R"({"do":"offset","raise":-2.5})"}) {
        EXPECT_TRUE(ok(line)) << line;
        EXPECT_NE(ground(), before) << line;
        EXPECT_TRUE(ok(R"({"do":"undo"})"));
        EXPECT_EQ(ground(), before) << line;
    }
}

TEST_F(GroundScript, TheGroundOfAnotherSceneStays)
{
    const std::filesystem::path project = document->project().folder;
    io::Complaints complaints;
    io::World world = *io::openWorld(project, {}, complaints);
    std::filesystem::copy_file(project / world.entry.file, project / "scenes/two.scene.json");
    world.project.scenes.push_back({"two", "scenes/two.scene.json"});
    ASSERT_TRUE(io::saveWorld(world));
    document = *Document::open(project);
    script = std::make_unique<Script>(*document, selection, picker, view);
    const std::string before = test::textOf(project / "terrain/ground.png");
    ASSERT_TRUE(ok(R"({"do":"resample","width":33})"));
    ASSERT_TRUE(ok(R"({"do":"save"})"));
    EXPECT_EQ(test::textOf(project / "terrain/ground.png"), before);
    EXPECT_EQ((*Document::open(project, "two"))->scene().heights()->size, glm::ivec2(65, 65));
    EXPECT_EQ((*Document::open(project, "main"))->scene().heights()->size, glm::ivec2(33, 33));
}

TEST_F(GroundScript, StampsByPicture)
{
    io::Image arrow{.size = {16, 16}, .channels = 1, .type = io::PixelType::U8};
    arrow.bytes.resize(256);
    for (int x = 8; x < 16; ++x) // the eastern half
        for (int z = 0; z < 16; ++z)
            arrow.row<std::uint8_t>(z)[x] = 255;
    std::filesystem::create_directories(document->project().folder / "textures");
    ASSERT_TRUE(io::writeImage(document->project().folder / "textures/half.png", arrow));
    const io::HeightMap before = ground();
    ASSERT_TRUE(ok(R"({"do":"sculpt","tool":"stamp","stamp":"textures/half.png","at":[10,10],"radius":10,"strength":3,"falloff":0})"));
    EXPECT_NEAR(*ground().height(14, 10) - *before.height(14, 10), 3, 1e-4);
    EXPECT_EQ(*ground().height(6, 10), *before.height(6, 10));
    ASSERT_TRUE(ok(R"({"do":"undo"})"));
    ASSERT_TRUE(ok(R"({"do":"sculpt","tool":"stamp","stamp":"textures/half.png","at":[10,10],"radius":10,"strength":3,"falloff":0,"rotation":90})"));
    EXPECT_EQ(*ground().height(10, 6), *before.height(10, 6));
    EXPECT_NEAR(*ground().height(10, 14) - *before.height(10, 14), 3, 1e-4);
}

TEST_F(GroundScript, WhatCannotBeDoneIsRefusedAndChangesNothing)
{
    const std::string before = test::text(document->scene());
    const io::HeightMap ground = this->ground();
    for (const char* line : {R"({"do":"generate","width":0})", R"({"do":"generate","width":100000})", R"({"do":"generate","depth":-3})", R"({"do":"generate","width":12.5})",
                             R"({"do":"generate","metres_per_texel":-1})", R"({"do":"generate","metres_per_texel":"wide"})", R"({"do":"generate","lowest":5,"highest":5})",
                             R"({"do":"generate","hills":1})", R"({"do":"generate","origin":[1]})", R"({"do":"resample"})", R"({"do":"resample","width":1})",
                             R"({"do":"resample","width":30,"metres_per_texel":2})", R"({"do":"resample","metres_per_texel":0.0011})", R"({"do":"crop"})",
                             R"({"do":"crop","from":[900,900],"to":[990,990]})", R"({"do":"offset"})", R"({"do":"offset","by":[1,2],"edge":"fold"})", R"({"do":"offset","raise":1e9})",
                             R"({"do":"sculpt","tool":"stamp","at":[0,0]})", R"({"do":"sculpt","tool":"stamp","at":[0,0],"stamp":"textures/none.png"})",
                             R"({"do":"sculpt","tool":"stamp","at":[0,0],"stamp":"../../etc/passwd"})"}) {
        const io::Value answer = run(line);
        ASSERT_TRUE(answer.find("ok")) << line;
        EXPECT_FALSE(*answer.find("ok")->asBool()) << line;
        EXPECT_TRUE(answer.find("error") && answer.find("error")->asString()->size() > 10) << line;
        EXPECT_EQ(this->ground(), ground) << line;
        EXPECT_EQ(document->history().position(), 0u) << line;
    }
    EXPECT_EQ(test::text(document->scene()), before);
}

} // namespace
