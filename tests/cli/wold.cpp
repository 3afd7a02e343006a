#include "tests/cli/wold.h"

#include "io/files/json.h"

#include <cstdlib>

namespace test {

Ran wold(std::vector<std::string> words, std::string input,
         std::vector<std::pair<std::string, std::string>> environment)
{
    static const Folder home;
    words.insert(words.begin(), WOLD_PROGRAM);
    RunOptions options{.input = std::move(input),
                       .environment = {{"DISPLAY", ""},
                                       {"WAYLAND_DISPLAY", ""},
                                       {"HOME", home.path().string()},
                                       {"XDG_CONFIG_HOME", home / "config"},
                                       {"XDG_STATE_HOME", home / "state"}}};
    if (!std::getenv("XDG_CACHE_HOME")) options.environment.emplace_back("XDG_CACHE_HOME", home / "cache");
    options.environment.insert(options.environment.end(), environment.begin(), environment.end());
    return run(words, options);
}

io::Value json(const std::string& text)
{
    const auto value = io::parseJson(text, "stdout");
    EXPECT_TRUE(value) << text;
    return value ? *value : io::Value{};
}

double number(const io::Value& object, std::string_view key)
{
    const io::Value* value = object.find(key);
    EXPECT_TRUE(value && value->asNumber()) << key;
    return value && value->asNumber() ? *value->asNumber() : -1;
}

std::string text(const io::Value& object, std::string_view key)
{
    const io::Value* value = object.find(key);
    return value && value->asString() ? *value->asString() : "";
}

void expectFault(const Ran& ran, std::string_view named)
{
    EXPECT_EQ(ran.code, 1) << ran.err;
    EXPECT_EQ(ran.signal, 0) << ran.err;
    EXPECT_TRUE(ran.lastError().starts_with("wold: ")) << ran.err;
    EXPECT_NE(ran.lastError().find(named), std::string::npos) << ran.err;
}

void expectMisuse(const Ran& ran, std::string_view named)
{
    EXPECT_EQ(ran.code, 2) << ran.err;
    EXPECT_TRUE(ran.lastError().starts_with("wold: ")) << ran.err;
    EXPECT_NE(ran.lastError().find(named), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("Usage"), std::string::npos) << ran.err;
}

} // namespace test
