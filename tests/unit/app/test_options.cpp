#include "app/options.h"

#include <gtest/gtest.h>

namespace app {
namespace {

Options parsed(std::vector<std::string> words)
{
    const auto result = parseOptions(std::move(words));
    if (const auto* ending = std::get_if<Ending>(&result)) {
        ADD_FAILURE() << ending->text;
        return {};
    }
    return std::get<Options>(result);
}

Ending refused(std::vector<std::string> words)
{
    const auto result = parseOptions(std::move(words));
    if (const auto* ending = std::get_if<Ending>(&result)) return *ending;
    ADD_FAILURE() << "was accepted";
    return {};
}

std::string lastLine(const std::string& text)
{
    const std::size_t end = text.find_last_not_of('\n');
    const std::size_t start = text.rfind('\n', end);
    return text.substr(start + 1, end - start);
}

TEST(Options, aProjectAloneMeansEdit)
{
    EXPECT_EQ(parsed({}).command, Command::Edit);
    EXPECT_EQ(parsed({"worlds/valley"}).command, Command::Edit);
    EXPECT_EQ(parsed({"worlds/valley"}).project, "worlds/valley");
    EXPECT_EQ(parsed({"--size", "800x600", "valley"}).project, "valley");
    EXPECT_EQ(parsed({"edit"}).project, "");
}

TEST(Options, optionsMayStandBeforeTheCommand)
{
    const Options o = parsed({"--size", "320x200", "--quiet", "render", "valley", "--out", "a.png"});
    EXPECT_EQ(o.command, Command::Render);
    EXPECT_EQ(o.size, glm::ivec2(320, 200));
    EXPECT_TRUE(o.quiet);
    EXPECT_EQ(o.project, "valley");
}

TEST(Options, viewTakesNegativeNumbersAndAnOptionalFieldOfView)
{
    const Options o = parsed({"render", "p", "--out", "a.png", "--view", "-1.5,20,-3e2,-90,10"});
    ASSERT_TRUE(o.view);
    EXPECT_EQ(o.view->eye, glm::dvec3(-1.5, 20, -300));
    EXPECT_EQ(o.view->yaw, -90);
    EXPECT_EQ(o.view->fov, 60);
    EXPECT_EQ(parsed({"render", "p", "--out", "a.png", "--view=1,2,3,4,5,75"}).view->fov, 75);
}

TEST(Options, setKeepsItsOrderAndItsCommas)
{
    const Options o = parsed({"bench", "p", "--set", "environment.fog.tint=1,0.5,0", "--set", "render.fog=off"});
    ASSERT_EQ(o.sets.size(), 2u);
    EXPECT_EQ(o.sets[0], std::pair(std::string{"environment.fog.tint"}, std::string{"1,0.5,0"}));
    EXPECT_EQ(o.sets[1].second, "off");
}

TEST(Options, theLastOfARepeatedOptionCounts)
{
    EXPECT_EQ(parsed({"render", "p", "--out", "a.png", "--size", "1x1", "--size", "30x20"}).size, glm::ivec2(30, 20));
}

TEST(Options, framesAndShow)
{
    const Options o =
        parsed({"render", "p", "--out", "a.png", "--frames", "3..9", "--path", "flight", "--show", "depth", "--cull-from", "1,2,3,40,-5"});
    EXPECT_EQ(o.range->first, 3);
    EXPECT_EQ(o.range->last, 9);
    EXPECT_EQ(o.show, renderer::Show::Depth);
    ASSERT_TRUE(o.cullFrom);
    EXPECT_EQ(o.cullFrom->eye, glm::dvec3(1, 2, 3));
    EXPECT_EQ(o.cullFrom->yaw, 40);
    EXPECT_FALSE(parsed({"render", "p", "--out", "a.png"}).cullFrom);
}

TEST(Options, wrongWordsEndWithTwoAndSayWhat)
{
    const std::vector<std::vector<std::string>> calls{
        {"render", "p"}, // no --out
        {"render", "p", "--out", "a.png", "--size", "0x10"},
        {"render", "p", "--out", "a.png", "--size", "99999x99999"},
        {"render", "p", "--out", "a.png", "--size", "12"},
        {"render", "p", "--out", "a.png", "--view", "1,2,3"},
        {"render", "p", "--out", "a.png", "--view", "1,2,nan,0,0"},
        {"render", "p", "--out", "a.png", "--show", "everything"},
        {"render", "p", "--out", "a.png", "--time", "25"},
        {"render", "p", "--out", "a.png", "--frames", "9..3", "--path", "x"},
        {"render", "p", "--out", "a.png", "--set", "novalue"},
        {"render", "p", "--out", "a.png", "--quality", "best"},
        {"render", "p", "--out", "a.png", "--log", "loud"},
        {"render", "p", "q", "--out", "a.png"},
        {"render", "p", "--out", "a.png", "--nonsense"},
        {"pick", "p"},
        {"run", "p"},
        {"edit", "p", "--shot", "a.png"}, // without a replay
        {"bench", "p", "--frames", "-3"},
        {"new"},
    };
    for (const auto& words : calls) {
        const Ending ending = refused(words);
        EXPECT_EQ(ending.code, 2) << words.back();
        EXPECT_TRUE(lastLine(ending.text).starts_with("wold: ")) << ending.text;
        EXPECT_NE(ending.text.find("Usage: wold " + words.front()), std::string::npos) << ending.text;
    }
}

TEST(Options, whatComesLaterSaysSo)
{
    for (const char* command : {"merge"}) {
        const Ending ending = refused({command, "p", "--whatever"});
        EXPECT_EQ(ending.code, 2);
        EXPECT_NE(lastLine(ending.text).find("comes with a later release"), std::string::npos);
    }
}

TEST(Options, helpIsNoFault)
{
    EXPECT_EQ(refused({"--help"}).code, 0);
    EXPECT_EQ(refused({"render", "--help"}).code, 0);
    EXPECT_NE(refused({"render", "--help"}).text.find("--show"), std::string::npos);
    EXPECT_EQ(refused({"--version"}).code, 0);
}

} // namespace
} // namespace app
