// The editor fed from a file: a person's clicks and keys, and what they leave on disk.
#include "io/files/image_file.h"
#include "tests/cli/wold.h"

namespace test {
namespace {

struct Replay : SmallWorld {
    Ran play(const std::string& events, std::vector<std::string> more = {})
    {
        std::vector<std::string> words{"edit", project, "--replay", folder.write("events.jsonl", events), "--size", "1280x720", "--quiet"};
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

TEST_F(Replay, aBrokenLineIsNamedBeforeAnythingIsOpened)
{
    expectFault(play("{\"wait\": 1}\n{\"click\": [1]}\n"), "events.jsonl:2");
    expectFault(play("{\"click\": {\"panel\": \"toolbar\", \"label\": \"Nowhere\"}}\n"), "events.jsonl:1");
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
