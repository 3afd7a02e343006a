// The editor fed from a file: a person's clicks and keys, and what they leave on disk.
#include "io/files/image_file.h"
#include "tests/cli/wold.h"

#include <algorithm>
#include <fmt/format.h>

namespace test {
namespace {

struct Replay : SmallWorld {
    Ran play(const std::string& events, std::vector<std::string> more = {})
    {
        std::vector<std::string> words{"edit",   project,    "--replay", folder.write("events.jsonl", events),
                                       "--size", "1280x720", "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        return wold(words);
    }
    std::string scene() const { return textOf(project + "/scenes/main.scene.json"); }
};

TEST_F(Replay, takesPicturesAndTheUiMap)
{
    const Ran ran = play("{\"wait\": 3}\n", {"--shot", folder / "a.png", "--ui-map", folder / "map.json"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const auto image = io::readImage(folder / "a.png");
    ASSERT_TRUE(image);
    EXPECT_EQ(image->size, glm::ivec2(1280, 720));
    const io::Value map = json(textOf(folder / "map.json"));
    ASSERT_TRUE(map.asArray());
    EXPECT_GT(map.asArray()->size(), 20u);
}

TEST_F(Replay, isTheSameEveryTime)
{
    for (const char* name : {"a.png", "b.png"})
        ASSERT_EQ(play("{\"wait\": 20}\n", {"--shot", folder / name}).code, 0);
    EXPECT_EQ(textOf(folder / "a.png"), textOf(folder / "b.png"));
}

TEST_F(Replay, playingLeavesTheEditorAndTheFilesAsTheyWere)
{
    const std::string before = scene();
    const std::string walk = "{\"keydown\": \"F5\"}\n{\"keyup\": \"F5\"}\n{\"wait\": 20}\n{\"keydown\": \"W\"}\n{\"wait\": 40}\n{\"shot\": \"" + (folder / "playing.png") +
                             "\"}\n{\"keyup\": \"W\"}\n{\"keydown\": \"Escape\"}\n{\"keyup\": \"Escape\"}\n";
    ASSERT_EQ(play("{\"wait\": 90}\n", {"--shot", folder / "without.png"}).code, 0);
    const Ran ran = play("{\"wait\": 10}\n" + walk + "{\"wait\": 10}\n", {"--shot", folder / "after.png"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const auto playing = io::readImage(folder / "playing.png"), after = io::readImage(folder / "after.png"), without = io::readImage(folder / "without.png");
    ASSERT_TRUE(playing && after && without);
    EXPECT_TRUE(after->bytes == without->bytes);
    EXPECT_FALSE(after->bytes == playing->bytes);
    EXPECT_EQ(scene(), before);
}

TEST_F(Replay, aWalkIsTracedStepByStepAndTheSameEachTime)
{
    const auto walk = [&](const char* trace) {
        folder.write("walk.jsonl", "{\"move\": [100, 100]}\n{\"keydown\": \"W\"}\n{\"wait\": 30}\n{\"move\": [220, 90]}\n{\"keydown\": \"Space\"}\n{\"keyup\": \"Space\"}\n{\"wait\": 60}\n");
        return wold({"play", project, "--input", folder / "walk.jsonl", "--frames", "150", "--trace", folder / trace, "--view", "0,4,16,0,0", "--quiet"});
    };
    ASSERT_EQ(walk("one.jsonl").code, 0);
    ASSERT_EQ(walk("other.jsonl").code, 0);
    const std::string trace = textOf(folder / "one.jsonl");
    EXPECT_EQ(trace, textOf(folder / "other.jsonl")); // to the last bit
    EXPECT_EQ(std::ranges::count(trace, '\n'), 150);
    std::istringstream lines{trace};
    std::vector<io::Value> steps;
    for (std::string line; std::getline(lines, line);)
        steps.push_back(json(line));
    const auto at = [&](std::size_t step, std::size_t axis) { return *(*steps[step].find("position")->asArray())[axis].asNumber(); };
    EXPECT_LT(at(149, 2), at(0, 2) - 2) << "ahead, along -Z";
    EXPECT_GT(std::abs(at(149, 0) - at(40, 0)), 0.2) << "the mouse turned";
    bool jumped = false;
    for (const io::Value& step : steps) {
        for (const char* key : {"step", "position", "velocity", "grounded", "contacts", "sounds"})
            EXPECT_NE(step.find(key), nullptr) << key;
        jumped |= !*step.find("grounded")->asBool();
    }
    EXPECT_TRUE(jumped);
    folder.write("walk.jsonl", "{\"keydown\": \"Hyper\"}\n");
    expectFault(wold({"play", project, "--input", folder / "walk.jsonl", "--trace", folder / "one.jsonl"}), "walk.jsonl:1");
}

// A crate is pushed; the editor comes back with it where it stood, until that is ticked in the list of what changed.
TEST_F(Replay, aPushedCrateStaysWhereItStoodUnlessThatIsKept)
{
    const std::string file = project + "/templates/crate.json";
    std::string text = textOf(file);
    text.insert(text.find("\"model\""), "\"body\": {\"dynamic\": true, \"mass\": 25},\n  ");
    folder.write("world/templates/crate.json", text);
    ASSERT_EQ(textOf(file), text);
    std::string before = scene(), third = R"("template":"crate","position":[0,0,0])";
    before.replace(before.find(third), third.size(), R"("template":"crate","position":[0,0,11])"); // near the camera
    folder.write("world/scenes/main.scene.json", before);
    const std::string push = "{\"wait\": 3}\n{\"keydown\": \"F5\"}\n{\"keyup\": \"F5\"}\n{\"keydown\": \"Shift\"}\n{\"keydown\": \"W\"}\n{\"wait\": 90}\n{\"keyup\": \"W\"}\n"
                             "{\"keyup\": \"Shift\"}\n{\"keydown\": \"Escape\"}\n{\"keyup\": \"Escape\"}\n{\"wait\": 2}\n";
    const std::string keep = "{\"click\": {\"label\": \"Tools\"}}\n{\"click\": {\"label\": \"Keep changes from play…\"}}\n{\"click\": {\"label\": \"crate 3 Position\"}}\n"
                             "{\"click\": {\"panel\": \"dialog\", \"label\": \"Keep\"}}\n{\"wait\": 2}\n";
    const std::string save = "{\"key\": \"Ctrl+S\"}\n{\"wait\": 2}\n";
    const std::vector<std::string> small{"--size", "900x600", "--quality", "low"};
    Ran ran = play(push + keep + "{\"key\": \"Ctrl+Z\"}\n{\"wait\": 1}\n" + save, small);
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(scene(), before); // one undo step
    ran = play(push + keep + save, small);
    ASSERT_EQ(ran.code, 0) << ran.err;
    const std::string after = scene();
    const auto line = [](const std::string& all, const std::string& start) { return all.substr(all.find(start), all.find('\n', all.find(start)) - all.find(start)); };
    EXPECT_NE(after, before);
    EXPECT_NE(line(after, "{\"id\":3,"), line(before, "{\"id\":3,"));
    for (const char* other : {"{\"id\":1,", "{\"id\":2,", "{\"id\":4,", "{\"id\":5,"})
        EXPECT_EQ(line(after, other), line(before, other));
}

TEST_F(Replay, aBrokenLineIsNamedBeforeAnythingIsOpened)
{
    expectFault(play("{\"wait\": 1}\n{\"click\": [1]}\n"), "events.jsonl:2");
    expectFault(play("{\"click\": {\"panel\": \"toolbar\", \"label\": \"Nowhere\"}}\n", {"--size", "320x200"}),
                "events.jsonl:1");
}

// Where the camera of the small world sees a point of the ground, from the middle of the viewport.
std::string inView(double x, double y)
{
    return fmt::format(R"({{"panel": "viewport", "kind": "viewport", "offset": [{}, {}]}})", x, y);
}

TEST_F(Replay, selectsDragsPlacesUndoesAndSaves)
{
    const std::string before = scene();
    const std::string crate = inView(0, 13), handle = inView(60, 32), farther = inView(100, 32),
                      ground = inView(-200, 100);
    const Ran ran =
        play("{\"wait\": 2}\n{\"click\": " + crate + "}\n" + // the third crate
             "{\"drag\": {\"from\": " + handle + ", \"to\": " + farther + ", \"mods\": [\"ctrl\"]}}\n" + // snapped: 2 m
             "{\"click\": {\"panel\": \"templates\", \"label\": \"crate\", \"kind\": \"template\"}}\n" +
             "{\"click\": " + ground + "}\n{\"wait\": 2}\n{\"uimap\": \"" + folder / "placed.json" + "\"}\n" +
             "{\"key\": \"Ctrl+Z\"}\n{\"wait\": 1}\n{\"key\": \"Ctrl+S\"}\n{\"wait\": 2}\n");
    ASSERT_EQ(ran.code, 0) << ran.err;
    std::string expected = before;
    const std::string third = R"({"id":3,"template":"crate","position":[0,0,0]})";
    ASSERT_NE(expected.find(third), std::string::npos);
    expected.replace(expected.find(third), third.size(), R"({"id":3,"template":"crate","position":[2,0,0]})");
    EXPECT_EQ(scene(), expected);
    EXPECT_NE(textOf(folder / "placed.json").find("crate 7"), std::string::npos); // it was there before the undo
}

TEST_F(Replay, whatIsPlacedStandsWhereTheRayMeetsTheGround)
{
    const Ran ran =
        play("{\"wait\": 2}\n{\"uimap\": \"" + folder / "map.json" + "\"}\n" +
             "{\"click\": {\"panel\": \"templates\", \"label\": \"crate\", \"kind\": \"template\"}}\n" +
             "{\"click\": " + inView(-200, 100) + "}\n{\"wait\": 1}\n{\"key\": \"Ctrl+S\"}\n{\"wait\": 2}\n");
    ASSERT_EQ(ran.code, 0) << ran.err;
    const io::Value map = json(textOf(folder / "map.json"));
    const auto viewport =
        std::ranges::find_if(*map.asArray(), [](const io::Value& item) { return text(item, "kind") == "viewport"; });
    ASSERT_NE(viewport, map.asArray()->end());
    const auto side = [&](std::size_t i) { return int(*(*viewport->find("rect")->asArray())[i].asNumber()); };
    const std::string size = fmt::format("{}x{}", side(2), side(3));
    // The pointer is at whole pixels of the window; the viewport begins at one.
    const std::string points = folder.write("points", fmt::format("{}.0 {}.0\n", side(2) / 2 - 200, side(3) / 2 + 100));
    const Ran asked = wold({"run", project, "-", "--quiet"}, R"({"do": "object", "id": 7}
{"do": "select", "ids": [7]}
{"do": "delete"}
{"do": "save"}
)");
    ASSERT_EQ(asked.code, 0) << asked.err;
    const io::Value object = json(linesOf(asked.out).at(0)); // it is gone now, so that the ray meets the ground
    const io::Value hit = json(linesOf(wold({"pick", project, "--points", points, "--size", size}).out).at(0));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double there = *(*object.find("position")->asArray())[axis].asNumber();
        EXPECT_NEAR(there, *(*hit.find("position")->asArray())[axis].asNumber(), 0.05) << axis;
    }
}

// A whole spell of shaping: raised, smoothed with Shift, lowered with Ctrl, a hole cut. All undone, every file is as it was.
TEST_F(Replay, strokesShapeTheGroundAndUndoGivesItBack)
{
    const auto stroke = [](double x, double z, double toX, double toZ, const char* mods) {
        return "{\"drag\": {\"from\": " + inView(x, z) + ", \"to\": " + inView(toX, toZ) + ", \"steps\": 12, \"mods\": [" + mods + "]}}\n";
    };
    const std::string strokes = "{\"wait\": 2}\n{\"key\": \"B\"}\n{\"wait\": 2}\n" + stroke(-150, 60, 120, 90, "") + stroke(-100, 70, 60, 80, "\"shift\"") +
                                stroke(40, 100, 160, 70, "\"ctrl\"") + "{\"click\": {\"panel\": \"terrain\", \"label\": \"Hole\", \"kind\": \"button\"}}\n" +
                                stroke(-40, 90, 30, 95, "");
    const std::string undo = "{\"key\": \"Ctrl+Z\"}\n{\"wait\": 1}\n", save = "{\"key\": \"Ctrl+S\"}\n{\"wait\": 3}\n";
    const auto ground = [this] { return textOf(project + "/terrain/ground.png"); };
    const std::string heights = ground(), before = scene();
    Ran ran = play(strokes + undo + undo + undo + undo + save);
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ground(), heights);
    EXPECT_EQ(scene(), before);
    EXPECT_FALSE(std::filesystem::exists(project + "/terrain/ground_cover.png"));
    ran = play(strokes + save);
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_NE(ground(), heights);
    EXPECT_TRUE(std::filesystem::exists(project + "/terrain/ground_cover.png")); // the hole
}

TEST_F(Replay, changesNothingOnDiskWithoutASave)
{
    const std::string before = scene();
    const Ran ran = play("{\"wait\": 2}\n{\"key\": \"Ctrl+A\"}\n{\"key\": \"Delete\"}\n{\"wait\": 2}\n");
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(scene(), before);
}

} // namespace
} // namespace test
