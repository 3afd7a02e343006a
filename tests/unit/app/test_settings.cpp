#include "app/settings.h"

#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <unistd.h>

namespace app {
namespace {

namespace fs = std::filesystem;

struct SettingsTest : testing::Test {
    fs::path folder = fs::temp_directory_path() / ("wold-settings-" + std::to_string(getpid()));
    fs::path file = folder / "sub" / "settings.json";

    SettingsTest() { fs::create_directories(folder); }
    ~SettingsTest() override { fs::remove_all(folder); }
    void write(const std::string& text)
    {
        fs::create_directories(file.parent_path());
        std::ofstream{file} << text;
    }
    std::string text(const fs::path& from) const
    {
        std::stringstream all;
        all << std::ifstream{from}.rdbuf();
        return all.str();
    }
};

TEST_F(SettingsTest, areMadeWhenMissing)
{
    const Settings settings = Settings::load(file);
    EXPECT_TRUE(fs::exists(file));
    EXPECT_EQ(settings.language(), "en");
    EXPECT_EQ(settings.quality(), Quality::Auto);
}

TEST_F(SettingsTest, aBrokenFileIsKeptAsideAndDefaultsHold)
{
    for (const char* broken : {"{ not json", "[1, 2]", ""}) {
        write(broken);
        EXPECT_EQ(Settings::load(file).language(), "en");
        EXPECT_EQ(text(file.string() + ".bad"), broken);
        EXPECT_NE(text(file), broken);
    }
}

TEST_F(SettingsTest, valuesOfTheWrongTypeFallBack)
{
    write(R"({"language": 7, "quality": "splendid", "recent": "x"})");
    const Settings settings = Settings::load(file);
    EXPECT_EQ(settings.language(), "en");
    EXPECT_EQ(settings.quality(), Quality::Auto);
    EXPECT_TRUE(settings.recentProjects().empty());
}

TEST_F(SettingsTest, valuesThatAreNotUsedAreNamed)
{
    write(R"({"language": 7, "quality": "best", "ui": {"scale": "big", "frame_rate": 30}, "recent": []})");
    testing::internal::CaptureStderr();
    (void)Settings::load(file);
    const std::string said = testing::internal::GetCapturedStderr();
    for (const char* key : {"settings.json: language: ", "settings.json: quality: ", "settings.json: ui.scale: "})
        EXPECT_NE(said.find(key), said.npos) << key << said;
    EXPECT_EQ(said.find("frame_rate"), said.npos) << said;
    EXPECT_EQ(said.find("recent"), said.npos) << said;
}

TEST_F(SettingsTest, unknownKeysSurvive)
{
    write(R"({"language": "en", "keys_of_tomorrow": {"save": "Ctrl+S"}})");
    Settings settings = Settings::load(file);
    settings.setLanguage("cs");
    settings.save();
    EXPECT_NE(text(file).find("keys_of_tomorrow"), std::string::npos);
    EXPECT_EQ(Settings::load(file).language(), "cs");
}

TEST_F(SettingsTest, recentProjectsAreNewestFirstAndOnce)
{
    Settings settings = Settings::load(file);
    for (int i = 0; i < 20; ++i)
        settings.addRecentProject(folder / std::to_string(i));
    settings.addRecentProject(folder / "15");
    const auto recent = settings.recentProjects();
    EXPECT_EQ(recent.size(), 12u);
    EXPECT_EQ(recent[0], folder / "15");
    EXPECT_EQ(recent[1], folder / "19");
    EXPECT_EQ(std::ranges::count(recent, folder / "15"), 1);
}

TEST_F(SettingsTest, theScaleOfTheWindowStaysUsable)
{
    write(R"({"ui": 7})");
    Settings settings = Settings::load(file);
    EXPECT_EQ(settings.uiScale(), 1);
    settings.setUiScale(1.25f);
    settings.save();
    EXPECT_NE(text(file).find("\"scale\": 1.25"), std::string::npos);
    EXPECT_EQ(Settings::load(file).uiScale(), 1.25f);
    write(R"({"ui": {"scale": 90}})");
    EXPECT_EQ(Settings::load(file).uiScale(), 3);
    write(R"({"ui": {"scale": 0}})");
    EXPECT_EQ(Settings::load(file).uiScale(), 0.5f);
}

TEST_F(SettingsTest, theFrameRateOfAMovingPicture)
{
    Settings settings;
    EXPECT_EQ(settings.frameRate(), 30);
    write(R"({"ui": {"scale": 2, "frame_rate": 1}})");
    settings = Settings::load(file);
    EXPECT_EQ(settings.frameRate(), 5);
    settings.setFrameRate(60);
    settings.save();
    EXPECT_EQ(Settings::load(file).frameRate(), 60);
    EXPECT_EQ(Settings::load(file).uiScale(), 2);
}

TEST_F(SettingsTest, withoutAFileNothingIsWritten)
{
    Settings settings;
    settings.setLanguage("cs");
    settings.addRecentProject(folder);
    settings.save();
    EXPECT_TRUE(fs::is_empty(folder));
}

} // namespace
} // namespace app
