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

TEST_F(ScatterScript, PlantsFollowWhenAllOfTheGroundChanges)
{
    ok(R"({"do":"scatter_layer","name":"low","species":["blob"],"density":0.05,"rule":true,"slope":[0,90]})");
    ok(R"({"do":"scatter_layer","name":"hand","species":["leaf"],"density":0.05,"slope":[0,90]})");
    ASSERT_GT(number(R"({"do":"evaluate","layer":"low"})", "count"), 100);
    ASSERT_GT(number(R"({"do":"plant","layer":"hand","at":[0,0],"radius":20})", "count"), 10);
    const auto height = [&] { // of one planted by hand
        const io::Scene& scene = document->scene();
        const auto& [place, tile] = *scene.instances(scene.findScatterLayer("hand")->id).begin();
        return io::transformOf(place, tile->instances.front()).position.y;
    };
    const double before = height();
    const std::string hash = *ok(R"({"do":"plants","layer":"low","everywhere":true})").find("hash")->asString();
    ok(R"({"do":"scatter_layer","name":"low","altitude":[-1000,200]})");
    ok(R"({"do":"offset","raise":500})");
    EXPECT_NEAR(height(), before + 500, 0.01);
    EXPECT_EQ(number(R"({"do":"plants","layer":"low","everywhere":true})", "count"), 0);
    ok(R"({"do":"undo"})");
    EXPECT_NEAR(height(), before, 1e-9);
    EXPECT_EQ(*ok(R"({"do":"plants","layer":"low","everywhere":true})").find("hash")->asString(), hash);
}

TEST_F(ScatterScript, AnotherListOfSpeciesKeepsThoseThatStand)
{
    ok(R"({"do":"scatter_layer","name":"wood","species":["blob","leaf"],"density":0.05,"spacing":2,"slope":[0,90]})");
    ok(R"({"do":"plant","layer":"wood","at":[0,0],"radius":50})");
    const auto counts = [&] { // by template
        std::map<std::string, int> all;
        const io::ScatterLayer& layer = *document->scene().findScatterLayer("wood");
        for (const auto& [place, tile] : document->scene().instances(layer.id))
            for (const io::Instance& instance : tile->instances)
                ++all[layer.species.at(instance.species).templateName];
        return all;
    };
    const auto before = counts();
    ok(R"({"do":"scatter_layer","name":"wood","species":["leaf","blob"]})");
    EXPECT_EQ(counts(), before);
    ok(R"({"do":"scatter_layer","name":"wood","species":["blob"]})");
    EXPECT_EQ(counts(), (std::map<std::string, int>{{"blob", before.at("blob")}}));
    ok(R"({"do":"undo"})");
    EXPECT_EQ(counts(), before);
    EXPECT_EQ(number(R"({"do":"replace_plants","layer":"wood","everywhere":true,"from":"blob","to":"leaf"})", "changed"), before.at("blob"));
}

TEST_F(ScatterScript, ErasingByRuleTakesNothingBeyondTheBrushLater)
{
    ok(R"({"do":"scatter_layer","name":"low","species":["blob"],"density":1,"spacing":0.3,"rule":true,"slope":[0,90]})");
    ok(R"({"do":"evaluate","layer":"low"})");
    ok(R"({"do":"erase_plants","layer":"low","at":[0,0],"radius":20})");
    const double left = number(R"({"do":"plants","layer":"low","at":[0,0],"radius":22})", "count");
    ASSERT_GT(left, 50);
    ok(R"({"do":"evaluate","layer":"low"})");
    EXPECT_EQ(number(R"({"do":"plants","layer":"low","at":[0,0],"radius":22})", "count"), left);
}

TEST_F(ScatterScript, ClearanceIsKeptFromPlantsOfOtherLayers)
{
    ok(R"({"do":"scatter_layer","name":"stones","species":["blob"],"density":0.01,"spacing":6,"slope":[0,90]})");
    ok(R"({"do":"plant","layer":"stones","at":[0,0],"radius":60})");
    ok(R"({"do":"scatter_layer","name":"wood","species":["leaf"],"density":0.3,"spacing":1,"clearance":3,"slope":[0,90]})");
    ok(R"({"do":"plant","layer":"wood","at":[0,0],"radius":60})");
    const auto places = [&](const char* name) {
        std::vector<glm::dvec2> all;
        for (const auto& [place, tile] : document->scene().instances(document->scene().findScatterLayer(name)->id))
            for (const io::Instance& instance : tile->instances) {
                const glm::dvec3 at = io::transformOf(place, instance).position;
                all.emplace_back(at.x, at.z);
            }
        return all;
    };
    const auto stones = places("stones"), wood = places("wood");
    ASSERT_GT(stones.size(), 30u);
    ASSERT_GT(wood.size(), 300u);
    double nearest = 1e9;
    for (const glm::dvec2& a : stones)
        for (const glm::dvec2& b : wood)
            nearest = std::min(nearest, glm::distance(a, b));
    EXPECT_GE(nearest, 3 - 0.01);
}

} // namespace
