#include "io/files/image_file.h"
#include "tests/cli/wold.h"

#include <algorithm>

namespace test {
namespace {

using Commands = SmallWorld;

TEST_F(Commands, infoCountsAProject)
{
    const Ran ran = wold({"info", project, "--json", "-", "--quiet"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const io::Value facts = json(ran.out);
    EXPECT_EQ(number(facts, "objects"), 6);
    EXPECT_EQ(number(facts, "instances"), 6);
    EXPECT_EQ(number(facts, "triangles"), 5 * 12);
    EXPECT_EQ(number(facts, "templates"), 2);
    EXPECT_EQ(number(facts, "models"), 1);
    EXPECT_EQ(*facts.find("terrain")->find("size"), (io::Value::Array{65, 65}));
    EXPECT_EQ(*facts.find("terrain")->find("metres"), (io::Value::Array{64, 64}));
    EXPECT_FALSE(text(*facts.find("gl"), "renderer").empty());
}

TEST_F(Commands, infoNeedsNoProject)
{
    const Ran ran = wold({"info"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_NE(ran.out.find("wold"), std::string::npos);
}

TEST_F(Commands, renderWritesEachKindOfPicture)
{
    for (const char* name : {"a.png", "a.jpg", "a.exr"}) {
        const std::string file = folder / name;
        const Ran ran = wold({"render", project, "--out", file, "--size", "96x54", "--quiet"});
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.err, "");
        const auto image = io::readImage(file);
        ASSERT_TRUE(image) << image.error().text();
        EXPECT_EQ(image->size, glm::ivec2(96, 54));
        EXPECT_EQ(image->type == io::PixelType::F32 || image->type == io::PixelType::U8, true);
    }
}

TEST_F(Commands, renderAlongAPathNumbersItsPictures)
{
    const Ran ran =
        wold({"render", project, "--out", folder / "f.png", "--size", "32x18", "--frames", "0..2", "--path", "flight"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    for (const char* name : {"f0000.png", "f0001.png", "f0002.png"})
        EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
    EXPECT_EQ(wold({"render", project, "--out", folder / "c.png", "--size", "32x18", "--count", "2"}).code, 0);
    EXPECT_NE(textOf(folder / "c0000.png"), textOf(folder / "c0001.png"));
}

// So that many machines can share them out.
TEST_F(Commands, aPictureOfASequenceIsTheSameDrawnAlone)
{
    for (const char* quality : {"medium", "high"}) {
        const auto draw = [&](const char* frames, const char* file) {
            return wold({"render", project, "--out", folder / file, "--size", "96x54", "--frames", frames, "--path", "flight", "--quality", quality, "--set", "render.auto_exposure=on", "--set",
                         "environment.auto_exposure.on=true", "--quiet"});
        };
        const Ran all = draw("0..7", "all.png");
        ASSERT_EQ(all.code, 0) << all.err;
        ASSERT_EQ(draw("3..3", "one.png").code, 0);
        ASSERT_EQ(draw("5..7", "some.png").code, 0);
        EXPECT_EQ(textOf(folder / "all0003.png"), textOf(folder / "one0003.png")) << quality;
        EXPECT_EQ(textOf(folder / "all0007.png"), textOf(folder / "some0007.png")) << quality;
    }
}

TEST_F(Commands, theSameCallDrawsTheSamePicture)
{
    for (const char* name : {"one.png", "two.png"})
        ASSERT_EQ(wold({"render", project, "--out", folder / name, "--size", "96x54"}).code, 0);
    EXPECT_EQ(textOf(folder / "one.png"), textOf(folder / "two.png"));
}

TEST_F(Commands, setTimeAndQualityChangeThePicture)
{
    const auto draw = [&](const std::string& name, std::vector<std::string> more) {
        std::vector<std::string> words{"render", project, "--out", folder / name, "--size", "96x54", "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        const Ran ran = wold(words);
        EXPECT_EQ(ran.code, 0) << ran.err;
        return textOf(folder / name);
    };
    const std::string plain = draw("plain.png", {});
    EXPECT_NE(plain, draw("time.png", {"--time", "17"}));
    EXPECT_NE(plain, draw("sun.png", {"--set", "environment.sun.mode=manual", "--set", "environment.sun.azimuth=10"}));
    EXPECT_NE(plain, draw("shadows.png", {"--set", "render.shadows=off"}));
    EXPECT_NE(plain, draw("tone.png", {"--set", "render.tonemap=reinhard"}));
    EXPECT_NE(plain, draw("ao.png", {"--set", "render.ao=off"}));
    EXPECT_NE(plain, draw("look.png", {"--look", "dusk"}));
    EXPECT_EQ(plain, draw("high.png", {"--quality", "high"}));
}

TEST_F(Commands, pickAnswersALineForEachPoint)
{
    const std::string points =
        folder.write("points", "# the middle crate, the sky, the ground\n80 50\n80 2\n\n20 85\n");
    const Ran ran = wold({"pick", project, "--points", points, "--size", "160x90", "--json", folder / "figures.json"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const auto lines = linesOf(ran.out);
    ASSERT_EQ(lines.size(), 3u) << ran.out;
    const io::Value crate = json(lines[0]), sky = json(lines[1]), ground = json(lines[2]);
    EXPECT_EQ(text(crate, "surface"), "object");
    EXPECT_EQ(number(crate, "id"), 3);
    EXPECT_EQ(text(crate, "template"), "crate");
    EXPECT_NEAR(*(*crate.find("position")->asArray())[2].asNumber(), 1, 1e-3);
    EXPECT_NEAR(*(*crate.find("normal")->asArray())[2].asNumber(), 1, 1e-3);
    EXPECT_EQ(text(sky, "surface"), "none");
    EXPECT_EQ(text(ground, "surface"), "terrain");
    EXPECT_NEAR(*(*ground.find("position")->asArray())[1].asNumber(), 0, 1e-3);
    EXPECT_GT(number(json(textOf(folder / "figures.json")), "rays_per_second"), 0);
}

TEST_F(Commands, runAnswersEachLineAndSaves)
{
    const std::string script = R"({"do": "place", "template": "crate", "at": [0, 0, 6]}
{"do": "move", "ids": [1], "by": [0, 0, 1]}
{"do": "undo"}
{"do": "get", "key": "environment.time"}
{"do": "save"}
)";
    const Ran ran = wold({"run", project, "-", "--quiet"}, script);
    ASSERT_EQ(ran.code, 0) << ran.err;
    const auto answers = linesOf(ran.out);
    ASSERT_EQ(answers.size(), 5u) << ran.out;
    EXPECT_EQ(number(json(answers[0]), "id"), 7);
    for (const std::string& answer : answers)
        EXPECT_EQ(*json(answer).find("ok"), io::Value{true}) << answer;
    const auto lines = linesOf(textOf(project + "/scenes/main.scene.json"));
    EXPECT_EQ(std::ranges::count_if(lines, [](const std::string& line) { return line.find("\"id\":7,") != line.npos; }),
              1);
    EXPECT_EQ(number(json(wold({"info", project, "--json", "-"}).out), "objects"), 7);
}

TEST_F(Commands, aScriptWithAFailedCommandEndsWithOneAndNamesItsLine)
{
    const std::string script = folder.write("s.jsonl", "{\"do\": \"undo\"}\n{\"do\": \"place\", \"template\": "
                                                       "\"house\", \"at\": [0,0,0]}\nnot json\n{\"do\": \"stats\"}\n");
    const Ran ran = wold({"run", project, script});
    const auto answers = linesOf(ran.out);
    ASSERT_EQ(answers.size(), 4u) << ran.out;
    EXPECT_EQ(*json(answers[2]).find("ok"), io::Value{false});
    EXPECT_EQ(*json(answers[3]).find("ok"), io::Value{true});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(ran.lastError().starts_with("wold: " + script + ":")) << ran.err;
}

TEST_F(Commands, runDrawsPicturesAndSetsDrawing)
{
    const Ran ran =
        wold({"run", project, "-"}, R"({"do": "render", "out": ")" + folder / "s.png" + R"(", "size": [64, 36]}
{"do": "set", "key": "render.shadows", "value": "off"}
{"do": "get", "key": "render.shadows"}
)");
    EXPECT_EQ(ran.code, 0) << ran.err << ran.out;
    const auto image = io::readImage(folder / "s.png");
    ASSERT_TRUE(image);
    EXPECT_EQ(image->size, glm::ivec2(64, 36));
    EXPECT_EQ(*json(linesOf(ran.out)[2]).find("value"), io::Value{false});
}

TEST_F(Commands, benchReportsEveryFigure)
{
    const Ran ran =
        wold({"bench", project, "--frames", "5", "--warmup", "1", "--size", "64x36", "--json", "-", "--quiet"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const io::Value figures = json(ran.out);
    for (const char* key :
         {"median_ms", "p95_ms", "p99_ms", "load_ms", "first_frame_ms", "draw_calls", "triangles_submitted",
          "triangles_drawn", "instances", "instances_inside", "instances_large", "instances_hidden",
          "instances_drawn", "grass_blades", "peak_rss_mb", "processor_ms", "submit_ms"})
        EXPECT_GE(number(figures, key), 0) << key;
    EXPECT_EQ(figures.find("frames_ms")->asArray()->size(), 5u);
    EXPECT_EQ(number(figures, "instances"), 6);
    EXPECT_EQ(figures.find("triangles_of_level")->asArray()->size(), 8u);
    EXPECT_GT(number(figures, "peak_rss_mb"), 10);
    EXPECT_GT(number(figures, "first_frame_at_ms") + 10, number(figures, "load_ms") + number(figures, "first_frame_ms"));
    EXPECT_LT(number(figures, "first_frame_at_ms"), 300'000);
    for (const char* kind : {"objects", "geometry", "pictures", "heights", "gpu", "gpu_textures", "gpu_buffers", "gpu_shadow_maps",
                             "gpu_targets"})
        EXPECT_GE(number(*figures.find("memory_mb"), kind), 0) << kind;
    EXPECT_GT(number(*figures.find("memory_mb"), "geometry"), 0);
    EXPECT_GT(number(figures, "uploaded_bytes"), 1000) << "constants, at least";
    EXPECT_FALSE(figures.find("passes")->asArray()->empty());
    EXPECT_FALSE(text(figures, "gl_renderer").empty());
}

TEST_F(Commands, checkIsSilentOnASoundWorld)
{
    const Ran ran = wold({"check", project});
    EXPECT_EQ(ran.code, 0) << ran.err << ran.out;
}

TEST_F(Commands, newMakesAProjectThatOpens)
{
    const std::string made = folder / "made";
    ASSERT_EQ(wold({"new", made}).code, 0);
    const Ran info = wold({"info", made, "--json", "-", "--quiet"});
    EXPECT_EQ(info.code, 0) << info.err;
    EXPECT_EQ(text(json(info.out), "name"), "made");
    expectFault(wold({"new", made}), "made");
    expectMisuse(wold({"new", folder / "other", "--from", "nowhere"}), "nowhere");
}

TEST_F(Commands, progressIsALineAStepWhenPipedAndNothingWhenQuiet)
{
    const Ran piped = wold({"render", project, "--out", folder / "p.png", "--size", "32x18"});
    EXPECT_EQ(piped.err.find('\r'), std::string::npos);
    EXPECT_FALSE(piped.err.empty());
    EXPECT_EQ(wold({"render", project, "--out", folder / "p.png", "--size", "32x18", "--quiet"}).err, "");
}

} // namespace
} // namespace test
