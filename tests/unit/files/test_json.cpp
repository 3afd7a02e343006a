#include "io/files/json.h"
#include "io/files/text.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace io {
namespace {

std::string numberOf(double value)
{
    std::string out;
    appendNumber(out, value);
    return out;
}
std::string numberOf(float value)
{
    std::string out;
    appendNumber(out, value);
    return out;
}
std::string stringOf(std::string_view value)
{
    std::string out;
    appendString(out, value);
    return out;
}
std::string faultOf(std::string_view text)
{
    const Result<Value> value = parseJson(text, "a.json");
    return value ? "" : value.error().text();
}

TEST(JsonText, NumbersAreShort)
{
    EXPECT_EQ(numberOf(1.0), "1");
    EXPECT_EQ(numberOf(-0.0), "0");
    EXPECT_EQ(numberOf(100000.0), "100000");
    EXPECT_EQ(numberOf(0.1), "0.1");
    EXPECT_EQ(numberOf(0.1f), "0.1");
    EXPECT_EQ(numberOf(16777216.0f), "16777216");
    EXPECT_EQ(numberOf(1e-7), "1e-07");
    EXPECT_EQ(numberOf(1e300), "1e+300");
}

TEST(JsonText, FloatsReadBackExactlyThroughDoubles)
{
    const float twiceRounded = 7.038531e-26f; // as a double this decimal lies nearer to the next float
    EXPECT_EQ(float(*parseJson(numberOf(twiceRounded), "")->asNumber()), twiceRounded);
    std::mt19937 random{3};
    for (int i = 0; i < 50'000; ++i) {
        const std::uint32_t bits = random();
        float value = 0;
        std::memcpy(&value, &bits, sizeof value);
        if (!std::isfinite(value)) continue;
        const Result<Value> back = parseJson(numberOf(value), "");
        ASSERT_TRUE(back);
        ASSERT_EQ(float(*back->asNumber()), value);
    }
}

TEST(JsonText, NumbersDoNotDependOnTheLocale)
{
    const std::string before = std::setlocale(LC_ALL, nullptr);
    std::setlocale(LC_ALL, "de_DE.UTF-8"); // where it is installed
    EXPECT_EQ(numberOf(1.5), "1.5");
    EXPECT_EQ(*parseJson("1.5", "")->asNumber(), 1.5);
    std::setlocale(LC_ALL, before.c_str());
}

TEST(JsonText, StringsAreEscaped)
{
    EXPECT_EQ(stringOf("plain"), "\"plain\"");
    EXPECT_EQ(stringOf("a\"b\\c\n\t\x01"), "\"a\\\"b\\\\c\\n\\t\\u0001\"");
    EXPECT_EQ(stringOf("Kůň 名前 ❤"), "\"Kůň 名前 ❤\"");
    EXPECT_EQ(stringOf("a\xFF\xC0z"), "\"a\uFFFD\uFFFDz\"");
    EXPECT_EQ(stringOf("\xED\xA0\x80"), "\"\uFFFD\uFFFD\uFFFD\""); // a surrogate
    EXPECT_EQ(repairedUtf8("ok \xE2\x82"), "ok \uFFFD\uFFFD");
}

TEST(Json, ParsesWhatItWrites)
{
    const std::string text = R"({"a":[1,2.5,-3e+100,true,false,null],"b":{"c":"d\n"},"":[]})";
    const Result<Value> value = parseJson(text, "a.json");
    ASSERT_TRUE(value);
    EXPECT_EQ(writeJson(*value), text);
    EXPECT_EQ(*parseJson(writeJson(*value, 2), ""), *value);
}

TEST(Json, IndentedTextKeepsListsOfAtomsOnALine)
{
    const Value value =
        Value::Object{{"list", Value::Array{1, 2}}, {"empty", Value::Object{}}, {"deep", Value::Array{Value::Array{}}}};
    EXPECT_EQ(writeJson(value, 2), "{\n  \"list\": [1, 2],\n  \"empty\": {},\n  \"deep\": [\n    []\n  ]\n}");
}

TEST(Json, FaultsNameTheLine)
{
    EXPECT_EQ(faultOf("{\n\"a\": 1,\n\"a\": 2}"), "a.json:3: a: the key appears twice; remove one");
    EXPECT_TRUE(faultOf("{\n\"a\": 1\n\"b\": 2}").starts_with("a.json:3: not valid JSON:"))
        << faultOf("{\n\"a\": 1\n\"b\": 2}");
    EXPECT_TRUE(faultOf("").starts_with("a.json:1: "));
    EXPECT_TRUE(faultOf("[1,2").starts_with("a.json:1: "));
    EXPECT_TRUE(faultOf("\"\xFF\"").starts_with("a.json:1: "));
    EXPECT_TRUE(faultOf("[01]").starts_with("a.json:1: "));
    EXPECT_TRUE(faultOf("[NaN]").starts_with("a.json:1: "));
    EXPECT_TRUE(faultOf("[1e999]").starts_with("a.json:1: "));
    EXPECT_TRUE(faultOf("{} {}").starts_with("a.json:1: "));
}

TEST(Json, DeepNestingIsRefusedNotFollowed)
{
    EXPECT_EQ(faultOf(std::string(64, '[') + std::string(64, ']')), "");
    EXPECT_EQ(faultOf(std::string(65, '[') + std::string(65, ']')), "a.json:1: nested more than 64 deep; flatten it");
    EXPECT_NE(faultOf(std::string(2'000'000, '[')), "");
}

TEST(Json, ManyKeysAreNoSlowerThanTheyMustBe)
{
    std::string text = "{";
    for (int i = 0; i < 200'000; ++i)
        text += (i ? ",\"k" : "\"k") + std::to_string(i) + "\":0";
    EXPECT_EQ(faultOf(text + "}"), "");
}

TEST(Json, AMarkAtTheStartIsPassedOver)
{
    EXPECT_EQ(faultOf("\xEF\xBB\xBF{}"), "");
    EXPECT_EQ(faultOf("{\r\n\"a\": 1\r\n}"), "");
}

TEST(Json, TheFirstOfTwoKeysMayBeKept)
{
    const Result<Value> value = parseJson(R"({"a":1,"a":[2,{"a":3}],"b":4})", "", Duplicates::KeepFirst);
    ASSERT_TRUE(value);
    EXPECT_EQ(writeJson(*value), R"({"a":1,"b":4})");
}

TEST(Json, WhatIsNotFiniteIsNull)
{
    EXPECT_EQ(writeJson(Value{std::numeric_limits<double>::infinity()}), "null");
}

} // namespace
} // namespace io
