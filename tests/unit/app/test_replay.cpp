#include "app/pads.h"
#include "app/player.h"
#include "app/replay.h"

#include <gtest/gtest.h>

namespace app {
namespace {

std::vector<Step> stepsOf(std::string_view text)
{
    const auto steps = parseReplay(text, "r.jsonl");
    EXPECT_TRUE(steps) << (steps ? "" : steps.error().text());
    return steps ? *steps : std::vector<Step>{};
}

std::string faultOf(std::string_view text)
{
    const auto steps = parseReplay(text, "r.jsonl");
    return steps ? "" : steps.error().text();
}

// Plays into an ImGuiIO of its own and notes what a frame sees.
struct Seen {
    std::vector<std::string> frames;
};

Seen played(std::string_view text)
{
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    Seen seen;
    Player player{
        stepsOf(text),
        "r.jsonl",
        {.shot = [&](const auto& file) { return seen.frames.push_back("shot " + file.string()), io::Status{}; },
         .uiMap = [&](const auto&) { return io::Status{}; },
         .resize = [&](glm::ivec2) { seen.frames.push_back("resize"); }}};
    while (*player.feed(io)) {
        std::string frame;
        if (ImGui::IsMousePosValid(&io.MousePos))
            frame = std::to_string(int(io.MousePos.x)) + "," + std::to_string(int(io.MousePos.y));
        if (io.MouseDown[0]) frame += " L";
        if (io.MouseDown[1]) frame += " R";
        if (io.KeyCtrl) frame += " ctrl";
        if (io.KeysDown['S']) frame += " S";
        seen.frames.push_back(frame);
    }
    ImGui::DestroyContext();
    return seen;
}

TEST(Replay, aClickIsMovePressRelease)
{
    EXPECT_EQ(played(R"({"click": [10, 20]})").frames, (std::vector<std::string>{"10,20", "10,20 L", "10,20"}));
    EXPECT_EQ(played(R"({"click": [1, 2], "button": "right", "mods": ["ctrl"]})").frames,
              (std::vector<std::string>{"1,2", "1,2 ctrl", "1,2 R ctrl", "1,2 ctrl", "1,2"}));
}

TEST(Replay, aChordIsHeldKeyByKey)
{
    EXPECT_EQ(played("{\"move\": [5, 5]}\n{\"key\": \"Ctrl+S\"}").frames,
              (std::vector<std::string>{"5,5", "5,5 ctrl", "5,5 ctrl S", "5,5 ctrl", "5,5"}));
}

TEST(Replay, aDragGoesInSteps)
{
    EXPECT_EQ(played(R"({"drag": {"from": [0, 0], "to": [10, 20], "steps": 2}})").frames,
              (std::vector<std::string>{"0,0", "0,0 L", "5,10 L", "10,20 L", "10,20"}));
}

TEST(Replay, waitsCountFramesAndShotsTakeNone)
{
    EXPECT_EQ(played("{\"wait\": 2}\n{\"shot\": \"a.png\"}\n\n{\"size\": [64, 48]}").frames,
              (std::vector<std::string>{"", "", "shot a.png", "resize", ""}));
}

TEST(Replay, aMissingWidgetIsNamedWithItsLine)
{
    ImGui::CreateContext();
    Player player{
        stepsOf("{\"wait\": 1}\n{\"click\": {\"panel\": \"toolbar\", \"label\": \"Nowhere\"}}"), "r.jsonl", {}};
    std::optional<io::Error> fault;
    for (int i = 0; i < 1000 && !fault; ++i)
        if (const auto more = player.feed(ImGui::GetIO()); !more) fault = more.error();
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->where, "r.jsonl:2");
    EXPECT_NE(fault->what.find("Nowhere"), std::string::npos);
    ImGui::DestroyContext();
}

TEST(Replay, aBrokenLineIsNamed)
{
    EXPECT_TRUE(faultOf("{\"wait\": 1}\n{\"wait\": ").starts_with("r.jsonl:2: "));
    for (const char* line : {"[1,2]",
                             "{}",
                             "7",
                             R"({"jump": 1})",
                             R"({"move": [1]})",
                             R"({"move": ["a", 2]})",
                             R"({"wait": -1})",
                             R"({"wait": 1.5})",
                             R"({"wait": 1e9})",
                             R"({"key": "Hyper+S"})",
                             R"({"key": ""})",
                             R"({"press": "third"})",
                             R"({"click": [1,2], "colour": 3})",
                             R"({"click": {"wrong": "x"}})",
                             R"({"click": {}})",
                             R"({"drag": {"from": [0,0]}})",
                             R"({"drag": {"from": [0,0], "to": [1,1], "steps": 0}})",
                             R"({"size": [0, 10]})",
                             R"({"size": [1e9, 10]})",
                             R"({"shot": 3})",
                             R"({"mods": []})",
                             R"({"click": [1,2], "mods": ["hyper"]})",
                             R"({"click": [1,2], "mods": "ctrl"})"})
        EXPECT_TRUE(faultOf(line).starts_with("r.jsonl:1: ")) << line << " -> " << faultOf(line);
}

TEST(Replay, keysHaveNamesBothWays)
{
    for (const char* name : {"S", "7", "F1", "F12", "Delete", "Ctrl", "PageUp", "Space"}) {
        ASSERT_TRUE(keyNamed(name)) << name;
        EXPECT_EQ(nameOfKey(*keyNamed(name)), name);
    }
    EXPECT_EQ(keyNamed("ctrl"), keyNamed("Ctrl"));
    EXPECT_FALSE(keyNamed("F13"));
    EXPECT_FALSE(keyNamed(""));
}

TEST(Replay, PadsArePushedAndLetGo)
{
    const std::vector<Step> steps = stepsOf("{\"pad\": \"left -y\", \"to\": 0.5}\n{\"pad\": \"A\"}\n{\"pad\": \"A\", \"to\": 0}\n");
    ASSERT_EQ(steps.size(), 3u);
    const auto pad = [&](std::size_t i) { return std::get<step::Pad>(steps[i].action); };
    EXPECT_EQ(pad(0).name, "pad left -y");
    EXPECT_EQ(pad(0).share, 0.5);
    EXPECT_EQ(pad(1).share, 1);
    ReplayedPads pads;
    for (std::size_t i = 0; i < 2; ++i)
        pads.set(pad(i).name, pad(i).share);
    EXPECT_EQ(pads.held(), (play::Held{{"pad A", 1}, {"pad left -y", 0.5}}));
    pads.set(pad(2).name, pad(2).share);
    EXPECT_EQ(pads.held(), (play::Held{{"pad left -y", 0.5}}));
    EXPECT_NE(faultOf("{\"pad\": \"A\", \"to\": 2}").find("from 0 to 1"), std::string::npos);
    EXPECT_NE(faultOf("{\"key\": \"A\", \"to\": 1}").find("does not belong"), std::string::npos);
}

} // namespace
} // namespace app
