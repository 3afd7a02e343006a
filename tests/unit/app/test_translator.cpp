#include "app/translator.h"
#include "editor/text.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <unistd.h>

namespace app {
namespace {

namespace fs = std::filesystem;

struct Translator : testing::Test {
    fs::path folder = fs::temp_directory_path() / ("wold-lang-" + std::to_string(getpid()));
    fs::path english = folder / "app" / "lang" / "en.json", own = folder / "app" / "lang" / "own.json";

    Translator()
    {
        fs::create_directories(folder);
        setenv("WOLD_RESOURCES", folder.c_str(), 1);
    }
    ~Translator() override
    {
        unsetenv("WOLD_RESOURCES");
        fs::remove_all(folder);
    }
    static std::string text(const fs::path& from)
    {
        std::stringstream all;
        all << std::ifstream{from}.rdbuf();
        return all.str();
    }
};

TEST_F(Translator, AMissingEnglishIsWritten)
{
    ASSERT_TRUE(useLanguage("en"));
    EXPECT_STREQ(editor::tr("dialog.cancel"), "Cancel");
    unsetenv("WOLD_RESOURCES");
    EXPECT_EQ(text(english), kEnglish);
    EXPECT_EQ(text(english.parent_path() / "cs.json"), kCzech);
}

TEST_F(Translator, ABrokenEnglishIsLeftAloneAndTheTextsAreThere)
{
    fs::create_directories(english.parent_path());
    std::ofstream{english} << "{\"dialog\": {\"cancel\": ";
    EXPECT_TRUE(useLanguage("en"));
    EXPECT_STREQ(editor::tr("dialog.cancel"), "Cancel");
    EXPECT_EQ(text(english), "{\"dialog\": {\"cancel\": ");
}

TEST_F(Translator, WhatALanguageLacksIsEnglishAndWhatNobodyKnowsStays)
{
    fs::create_directories(own.parent_path());
    const std::string words = R"({"language": {"name": "Own"}, "dialog": {"cancel": "Zpet"}, "of another version": {"a": "b"}})";
    std::ofstream{own} << words;
    ASSERT_TRUE(useLanguage("own"));
    EXPECT_STREQ(editor::tr("dialog.cancel"), "Zpet");
    EXPECT_STREQ(editor::tr("dialog.save"), "Save");
    EXPECT_EQ(text(own), words);
    std::ofstream{own} << "[";
    const io::Status broken = useLanguage("own");
    ASSERT_FALSE(broken);
    EXPECT_NE(broken.error().text().find("own.json"), std::string::npos);
    EXPECT_STREQ(editor::tr("dialog.cancel"), "Zpet"); // as they were
}

} // namespace
} // namespace app
