// What scripts do to scatter layers.
#include "editor/script.h"
#include "io/files/json.h"
#include "tests/unit/editor/worlds.h"

#include <gtest/gtest.h>

using namespace editor;

namespace {

struct ScatterScript : ::testing::Test {
    std::unique_ptr<Document> document = test::forest(10, 1);
    Selection selection;
    Picker picker;
    View view;
    Script script{*document, selection, picker, view};

    io::Value run(const std::string& line)
    {
        const io::Result<io::Value> command = io::parseJson(line, "script");
        EXPECT_TRUE(command) << line;
        return script.execute(*command);
    }
    io::Value ok(const std::string& line)
    {
        const io::Value answer = run(line);
        EXPECT_TRUE(*answer.find("ok")->asBool()) << line << " " << io::writeJson(answer);
        return answer;
    }
    double number(const std::string& line, const char* key) { return *ok(line).find(key)->asNumber(); }
    bool refused(const std::string& line) { return !*run(line).find("ok")->asBool(); }
};

TEST_F(ScatterScript, LayersComeChangeAndGo)
{
    const double id = number(R"({"do":"scatter_layer","name":"wood","species":["blob",{"template":"leaf","weight":3}],"density":0.05,"spacing":2,"slope":[0,60]})", "id");
    EXPECT_EQ(number(R"({"do":"scatter_layer","name":"wood","density":0.1,"rename":"forest"})", "id"), id);
    const io::ScatterLayer& layer = document->scene().scatterLayers().front();
    EXPECT_EQ(layer.name, "forest");
    EXPECT_FLOAT_EQ(layer.density, 0.1f);
    EXPECT_EQ(layer.species.at(1).weight, 3);
    EXPECT_TRUE(refused(R"({"do":"scatter_layer","name":"other","species":["no such"]})"));
    EXPECT_TRUE(refused(R"({"do":"scatter_layer","name":"other","densty":1})"));
    EXPECT_TRUE(refused(R"({"do":"scatter_layer","name":"other","density":-1})"));
    ok(R"({"do":"scatter_layer","name":"forest","remove":true})");
    EXPECT_TRUE(document->scene().scatterLayers().empty());
    EXPECT_EQ(document->history().position(), 3u);
}

TEST_F(ScatterScript, PlantsErasesThinsAndConverts)
{
    ok(R"({"do":"scatter_layer","name":"wood","species":["blob","leaf"],"density":0.05,"spacing":2,"slope":[0,90]})");
    const double all = number(R"({"do":"plant","layer":"wood","at":[0,0],"radius":50})", "count");
    EXPECT_NEAR(all, 0.05 * 3.14159 * 2500, 20);
    EXPECT_EQ(number(R"({"do":"plant","layer":"wood","at":[0,0],"radius":50})", "changed"), 0);
    EXPECT_EQ(number(R"({"do":"plants","layer":"wood","everywhere":true})", "count"), all);
    EXPECT_NEAR(number(R"({"do":"thin","layer":"wood","everywhere":true,"share":0.5})", "count"), all / 2, all / 10);
    ok(R"({"do":"erase_plants","layer":"wood","everywhere":true,"species":"leaf"})");
    const double blobs = number(R"({"do":"replace_plants","layer":"wood","everywhere":true,"from":"blob","to":"leaf"})", "count");
    EXPECT_GT(blobs, 50);
    EXPECT_EQ(number(R"({"do":"plants_to_objects","layer":"wood","everywhere":true})", "count"), blobs);
    EXPECT_EQ(number(R"({"do":"plants","layer":"wood","everywhere":true})", "count"), 0);
    EXPECT_EQ(document->scene().objects().size(), 10 + std::size_t(blobs));
    ok(R"({"do":"select","template":"leaf"})");
    ok(R"({"do":"demote","layer":"wood"})");
    EXPECT_GE(number(R"({"do":"plants","layer":"wood","everywhere":true})", "count"), blobs);
    EXPECT_LE(document->scene().objects().size(), 10u);
    EXPECT_TRUE(refused(R"({"do":"plant","layer":"wood","at":[0,0],"everywhere":true})"));
    EXPECT_TRUE(refused(R"({"do":"plant","layer":"none","everywhere":true})"));
    EXPECT_TRUE(refused(R"({"do":"plant","layer":"wood","polygon":[[0,0],[1,0]]})"));
    EXPECT_TRUE(refused(R"({"do":"evaluate","layer":"wood"})")); // it has no rules
}

TEST_F(ScatterScript, RulesFollowTheGroundInTheStepThatShapedIt)
{
    ok(R"({"do":"scatter_layer","name":"low","species":["blob"],"density":0.05,"rule":true,"slope":[0,90]})");
    const double all = number(R"({"do":"evaluate","layer":"low"})", "count");
    ASSERT_GT(all, 100);
    const std::string before = *ok(R"({"do":"plants","layer":"low","everywhere":true})").find("hash")->asString();
    ok(R"({"do":"scatter_layer","name":"low","altitude":[-1000,200]})");
    ok(R"({"do":"sculpt","tool":"raise","at":[0,0],"radius":60,"strength":500})");
    EXPECT_LT(number(R"({"do":"plants","layer":"low","at":[0,0],"radius":20})", "count"), 5);
    ok(R"({"do":"undo"})");
    EXPECT_EQ(*ok(R"({"do":"plants","layer":"low","everywhere":true})").find("hash")->asString(), before);
}

} // namespace
