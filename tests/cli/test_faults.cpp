#include "tests/cli/wold.h"

#include <algorithm>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

namespace test {
namespace {

namespace fs = std::filesystem;
using Faults = SmallWorld;

TEST_F(Faults, wrongWordsEndWithTwo)
{
    expectMisuse(wold({"render", project}), "--out");
    expectMisuse(wold({"render", project, "--out", folder / "a.gif"}), ".png");
    expectMisuse(wold({"render", project, "--out", folder / "a.png", "--nonsense"}), "nonsense");
    expectMisuse(wold({"render", project, "--out", folder / "a.png", "--set", "environment.fog.densitty=1"}),
                 "densitty");
    expectMisuse(wold({"render", project, "--out", folder / "a.png", "--set", "environment.time=noon"}), "noon");
    expectMisuse(wold({"render", project, "--out", folder / "a.png", "--set", "colour=red"}), "colour");
    expectMisuse(wold({"render", project, "--out", folder / "a.png", "--look", "tuesday"}), "golden-hour");
    for (const char* wrong : {"sky.planet_radius=0", "fog.density=-1", "sky.mie_scattering=nan", "shadows.filter=pcf9", "clouds.coverage=2"})
        expectMisuse(wold({"render", project, "--out", folder / "a.png", "--set", std::string{"environment."} + wrong}),
                     std::string{wrong}.substr(0, std::string_view{wrong}.find('=')));
    expectMisuse(wold({"edit", project, "--headless"}), "--replay");
    EXPECT_FALSE(fs::exists(folder / "a.png"));
}

TEST_F(Faults, aMissingProjectIsNamed)
{
    for (const char* command : {"info", "check", "bench"})
        expectFault(wold({command, folder / "nowhere"}), "nowhere");
    expectFault(wold({"play", project, "--headless"}), "--input");
    expectFault(wold({"render", folder / "nowhere", "--out", folder / "a.png"}), "nowhere");
    expectFault(wold({"render", project, "--out", folder / "a.png", "--scene", "night"}), "night");
    expectFault(wold({"render", project, "--out", folder / "a.png", "--camera", "roof"}),
                "front"); // and says what there is
    expectFault(wold({"render", project, "--out", folder / "a.png", "--frames", "0..1", "--path", "roof"}), "flight");
    expectFault(wold({"pick", project, "--points", folder / "nothing"}), "nothing");
    expectFault(wold({"run", project, folder / "nothing.jsonl"}), "nothing.jsonl");
    expectFault(wold({"run", project, folder.path().string()}), folder.path().string());
    expectFault(wold({"edit", project, "--replay", folder / "nothing.jsonl"}), "nothing.jsonl");
    expectFault(wold({"edit", project}), "DISPLAY");
}

TEST_F(Faults, brokenJsonIsNamedWithItsLine)
{
    std::ofstream{project + "/project.json"} << "{\n  \"format\": \"wold-project\",\n  oops\n}\n";
    expectFault(wold({"info", project}), "project.json:3");
    expectFault(wold({"check", project}), "project.json:3");
}

TEST_F(Faults, aTruncatedSceneIsAnErrorAndIsLeftAlone)
{
    const std::string file = project + "/scenes/main.scene.json";
    const std::string whole = textOf(file);
    std::ofstream{file} << whole.substr(0, whole.size() / 2);
    expectFault(wold({"info", project}), "main.scene.json");
    EXPECT_EQ(textOf(file), whole.substr(0, whole.size() / 2));
}

TEST_F(Faults, aTruncatedModelIsReplacedInAPictureAndAnErrorForCheck)
{
    const std::string file = project + "/models/crate.glb";
    std::ofstream{file, std::ios::binary} << textOf(file).substr(0, 100);
    const Ran drawn = wold({"render", project, "--out", folder / "a.png", "--size", "32x18"});
    EXPECT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_NE(drawn.err.find("crate.glb"), std::string::npos) << drawn.err;
    const Ran checked = wold({"check", project});
    expectFault(checked, "crate.glb");
    EXPECT_NE(checked.out.find("error"), std::string::npos);
}

TEST_F(Faults, aSoundThatIsNoneIsAnErrorAtTheLineThatNamesIt)
{
    std::filesystem::create_directories(project + "/sounds");
    std::ofstream{project + "/sounds/text.ogg"} << "not a sound";
    const std::string file = project + "/templates/crate.json";
    std::string text = textOf(file);
    text.insert(text.rfind('}'), ",\n  \"steps\": \"sounds/text.ogg\"\n");
    std::ofstream{file} << text;
    const Ran checked = wold({"check", project});
    expectFault(checked, "steps: sounds/text.ogg");
    const auto line = std::count(text.begin(), text.begin() + std::ptrdiff_t(text.find("\"steps\"")), '\n') + 1;
    EXPECT_NE(checked.out.find("crate.json:" + std::to_string(line) + ": error: steps: "), std::string::npos) << checked.out;
}

TEST_F(Faults, whatNobodyCouldPlayIsAWarningAtItsLine)
{
    const std::string file = project + "/templates/crate.json";
    std::string text = textOf(file);
    text.insert(text.rfind('}'), R"(,
  "trigger": {"shape": "box", "size": [4, 4, 4], "once": false, "actions": [
    {"action": "teleport", "what": "nowhere", "seconds": 0},
    {"action": "show", "what": "nobody", "seconds": 0},
    {"action": "come_to_look", "what": "doomsday", "seconds": 0},
    {"action": "come_to_look", "what": "dawn", "seconds": 0}]},
  "player": {"start": true}
)");
    std::ofstream{file} << text;
    std::string own = textOf(project + "/project.json");
    own.insert(own.rfind('}'), R"(,
  "controls": [{"action": "moonwalk", "by": "W"}, {"action": "jump", "by": "Hyper"}, {"action": "jump", "by": "pad A"}, {"action": "run", "by": "mouse 2"}]
)");
    std::ofstream{project + "/project.json"} << own;
    std::string scene = textOf(project + "/scenes/main.scene.json");
    const std::string crate = R"("position":[0,0,0])";
    ASSERT_NE(scene.find(crate), scene.npos);
    scene.replace(scene.find(crate), crate.size(), R"("position":[9000,0,0])");
    std::ofstream{project + "/scenes/main.scene.json"} << scene;
    const Ran ran = wold({"check", project});
    EXPECT_EQ(ran.code, 0) << ran.err;
    const auto lineOf = [](const std::string& all, const char* word) { return std::to_string(std::count(all.begin(), all.begin() + std::ptrdiff_t(all.find(word)), '\n') + 1); };
    for (const char* word : {"nowhere", "nobody", "doomsday"})
        EXPECT_NE(ran.out.find("crate.json:" + lineOf(text, word) + ": warning: trigger.actions: "), std::string::npos) << word << ran.out;
    for (const char* word : {"moonwalk", "Hyper"})
        EXPECT_NE(ran.out.find("project.json:" + lineOf(own, word) + ": warning: controls: "), std::string::npos) << word << ran.out;
    EXPECT_NE(ran.out.find("beside the ground"), std::string::npos) << ran.out;
    std::size_t warnings = 0;
    for (std::size_t at = 0; (at = ran.out.find(": warning: ", at)) != ran.out.npos; ++at)
        ++warnings;
    EXPECT_EQ(warnings, 6u) << ran.out; // and of nothing else
}

TEST_F(Faults, imagesThatAreNoHeightMaps)
{
    const std::string file = project + "/terrain/ground.png";
    const std::string tiny = "\x89PNG\r\n\x1a\n";
    for (const std::string& bytes : {std::string{}, tiny, std::string(100'000, 'x')}) {
        std::ofstream{file, std::ios::binary | std::ios::trunc} << bytes;
        expectFault(wold({"check", project}), "ground.png");
        const Ran drawn = wold({"render", project, "--out", folder / "a.png", "--size", "32x18"});
        EXPECT_EQ(drawn.code, 0) << drawn.err;
        EXPECT_NE(drawn.err.find("ground.png"), std::string::npos) << drawn.err;
    }
}

TEST_F(Faults, aHugeHeaderIsRefusedWithoutReadingIt)
{
    // A PNG of 60000 x 60000 pixels by its header, with nothing behind it.
    const unsigned char png[] = {0x89, 'P',  'N',  'G', '\r', '\n', 0x1a, '\n', 0, 0, 0, 13, 'I',  'H',  'D',  'R', 0,
                                 0,    0xea, 0x60, 0,   0,    0xea, 0x60, 16,   0, 0, 0, 0,  0x8a, 0x9c, 0x6f, 0x5b};
    std::ofstream{project + "/terrain/ground.png", std::ios::binary | std::ios::trunc}.write(
        reinterpret_cast<const char*>(png), sizeof png);
    expectFault(wold({"check", project}), "ground.png");
}

TEST_F(Faults, outputThatCannotBeWrittenIsNamed)
{
    expectFault(wold({"render", project, "--size", "32x18", "--out", folder.write("file", "") + "/a.png"}), "file");
    expectFault(wold({"info", project, "--json", folder.write("file", "") + "/a.json"}), "file");
    // By the name that was given, not by that of a temporary beside it.
    expectFault(wold({"info", project, "--json", "/proc/a.json"}), "/proc/a.json: ");
}

TEST_F(Faults, aPictureOfOnePixel)
{
    const Ran ran = wold({"render", project, "--size", "1x1", "--out", folder / "a.png", "--quiet"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
}

TEST_F(Faults, tooLittleMemoryIsSaid)
{
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the address sanitizer reserves terabytes of addresses";
#endif
    const Ran ran = run({"prlimit", "--as=1500000000", WOLD_PROGRAM, "render", project, "--headless", "--size",
                         "8000x8000", "--out", folder / "a.png", "--quiet", "--log", "off"});
    expectFault(ran, "memory");
}

TEST_F(Faults, pointsAreCheckedLineByLine)
{
    for (const char* line : {"12", "a b", "1 2 3", "nan 1", "1e999 1"})
        expectFault(wold({"pick", project, "--points", folder.write("points", std::string{"1 1\n"} + line + "\n")}),
                    "points:2");
}

TEST_F(Faults, foldersPipesAndBinariesAreNoProjects)
{
    mkfifo((folder / "pipe").c_str(), 0600);
    expectFault(wold({"info", folder / "pipe"}), "pipe");
    expectFault(wold({"info", "/dev/null"}), "/dev/null");
    expectFault(wold({"info", WOLD_PROGRAM}), "");
    expectFault(wold({"info", folder.path().string()}), "");
    expectFault(wold({"pick", project, "--points", folder / "pipe"}), "pipe");
}

TEST_F(Faults, brokenSettingsAreReportedAndSetAside)
{
    const std::string settings = folder.write("settings.json", "{ broken");
    const std::string events = folder.write("events.jsonl", "{\"wait\": 1}\n");
    const Ran ran = wold({"edit", project, "--replay", events, "--config", settings, "--size", "640x360"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_NE(ran.err.find("settings.json"), std::string::npos) << ran.err;
    EXPECT_EQ(textOf(settings + ".bad"), "{ broken");
}

TEST_F(Faults, withoutOpenGl45TheMachineIsNamed)
{
    const Ran ran =
        test::wold({"render", project, "--out", folder / "a.png"}, "", {{"MESA_GL_VERSION_OVERRIDE", "3.3"}});
    expectFault(ran, "OpenGL 4.5");
}

} // namespace
} // namespace test
