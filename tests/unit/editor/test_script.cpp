#include "tests/unit/editor/worlds.h"

#include "editor/placement.h"
#include "editor/properties.h"
#include "editor/script.h"
#include "io/files/json.h"
#include "io/scene/shadow_ends.h"

#include <gtest/gtest.h>

using namespace editor;

namespace {

// A script on a small forest, fed with JSON text as `wold run` is.
struct Stage {
    std::unique_ptr<Document> document;
    Selection selection;
    Picker picker;
    View view{.camera = {.eye = {0, 60, 250}, .pitch = -12}, .size = {640, 360}};
    std::unique_ptr<Script> script;
    std::vector<std::string> rendered;

    explicit Stage(int objects = 60) : document{test::forest(objects, 21)}
    {
        ScriptHooks hooks;
        hooks.render = [this](const RenderRequest& request) -> io::Status {
            if (request.show == "nonsense") return io::Error{"show", "unknown"};
            rendered.push_back(request.out.string() + " " + std::to_string(request.view.size.x));
            return {};
        };
        hooks.stats = [] { return io::Value::Object{{"draw_calls", 7}}; };
        script = std::make_unique<Script>(*document, selection, picker, view, std::move(hooks));
    }

    io::Value run(const std::string& line)
    {
        const io::Result<io::Value> command = io::parseJson(line, "script");
        EXPECT_TRUE(command) << line;
        return script->execute(*command);
    }
    // One that must work.
    io::Value ok(const std::string& line)
    {
        io::Value answer = run(line);
        EXPECT_EQ(answer.find("ok")->asBool() && *answer.find("ok")->asBool(), true)
            << line << " -> " << io::writeJson(answer);
        return answer;
    }
    double number(const std::string& line, const char* key)
    {
        const io::Value answer = ok(line);
        const io::Value* found = answer.find(key);
        EXPECT_TRUE(found && found->asNumber()) << line << " lacks " << key;
        return found && found->asNumber() ? *found->asNumber() : -1;
    }
    const io::Object& object(double id) { return document->scene().at(io::ObjectId{std::uint32_t(id)}); }
};

std::string placeAt(double x, double z)
{
    return "{\"do\":\"place\",\"template\":\"marker\",\"at\":[" + std::to_string(x) + "," + std::to_string(z) + "]}";
}

} // namespace

TEST(Script, PlacesMovesTurnsAndScales)
{
    Stage stage;
    const double id = stage.number(R"({"do":"place","template":"blob","at":[5,30,-7],"yaw":30,"scale":2})", "id");
    EXPECT_EQ(stage.object(id).transform.rotation, (glm::vec3{0, 30, 0}));
    EXPECT_EQ(stage.object(id).transform.scale, glm::vec3{2});
    EXPECT_NEAR(boundsOf(*stage.document, std::vector{stage.object(id).id}).min.y, 30, 0.01);

    const std::string ids = ",\"ids\":[" + std::to_string(int(id)) + "]}";
    stage.ok(R"({"do":"move","to":[1,2,3])" + ids);
    EXPECT_EQ(stage.object(id).transform.position, (glm::dvec3{1, 2, 3}));
    stage.ok(R"({"do":"move","by":[1,0,0])" + ids);
    EXPECT_EQ(stage.object(id).transform.position, (glm::dvec3{2, 2, 3}));
    stage.ok(R"({"do":"rotate","to":[0,90,0])" + ids);
    EXPECT_EQ(stage.object(id).transform.rotation, (glm::vec3{0, 90, 0}));
    stage.ok(R"({"do":"move","by":[0,0,1],"space":"local")" + ids);
    EXPECT_LT(glm::distance(stage.object(id).transform.position, glm::dvec3{3, 2, 3}), 1e-9);
    stage.ok(R"({"do":"rotate","by":[0,15,0])" + ids);
    EXPECT_NEAR(stage.object(id).transform.rotation.y, 105, 1e-4);
    stage.ok(R"({"do":"scale","by":[1,2,1])" + ids);
    stage.ok(R"({"do":"scale","by":0.5)" + ids);
    EXPECT_EQ(stage.object(id).transform.scale, (glm::vec3{1, 2, 1}));
    stage.ok(R"({"do":"scale","to":3)" + ids);
    EXPECT_EQ(stage.object(id).transform.scale, glm::vec3{3});
}

TEST(Script, PlacesUnderAPixelAtTheCameraAndOnTheGround)
{
    Stage stage;
    const io::Value under = stage.ok(R"({"do":"pick","pixel":[320,300]})");
    const double id = stage.number(R"({"do":"place","template":"marker","pixel":[320,300],"yaw":0})", "id");
    EXPECT_NEAR(stage.object(id).transform.position.x, *under.find("position")->asArray()->at(0).asNumber(), 1e-6);
    const double atCamera = stage.number(R"({"do":"place","template":"marker","camera":true})", "id");
    EXPECT_EQ(stage.object(atCamera).transform.position, stage.view.camera.eye);
    const double onGround = stage.number(placeAt(12, -30), "id");
    EXPECT_NEAR(stage.object(onGround).transform.position.y, stage.number(R"({"do":"height","at":[12,-30]})", "height"),
                0.01);
}

TEST(Script, SelectsInEveryWay)
{
    Stage stage;
    EXPECT_EQ(stage.number(R"({"do":"select","ids":[1,2,3]})", "count"), 3);
    EXPECT_EQ(stage.number(R"({"do":"select","ids":[3,4],"mode":"add"})", "count"), 4);
    EXPECT_EQ(stage.number(R"({"do":"select","ids":[1],"mode":"remove"})", "count"), 3);
    EXPECT_EQ(stage.number(R"({"do":"selection"})", "primary"), 4);
    EXPECT_EQ(stage.number(R"({"do":"select","all":true})", "count"), 60);
    EXPECT_GT(stage.number(R"({"do":"select","template":"blob"})", "count"), 5);
    EXPECT_GT(stage.number(R"({"do":"select","box":[0,0,640,360]})", "count"), 20);
    EXPECT_EQ(stage.number(R"({"do":"select","ids":[]})", "count"), 0);
    EXPECT_EQ(stage.number(R"({"do":"select","pixel":[320,1]})", "count"), 0);
    const double id = stage.number(R"({"do":"place","template":"blob","at":[0,60,230],"yaw":0})", "id");
    stage.ok(R"({"do":"view","eye":[0,64,250],"yaw":0,"pitch":0})");
    EXPECT_EQ(stage.number(R"({"do":"select","pixel":[320,180]})", "count"), 1);
    EXPECT_EQ(io::number(stage.selection.primary()), id);
}

TEST(Script, GroupsDuplicatesAndDeletes)
{
    Stage stage;
    stage.ok(R"({"do":"select","ids":[1,2]})");
    stage.ok(R"({"do":"group","name":"pair"})");
    EXPECT_EQ(stage.number(R"({"do":"duplicate","by":[5,0,0]})", "count"), 1);
    EXPECT_EQ(stage.document->scene().objects().size(), 64u);
    EXPECT_EQ(stage.number(R"({"do":"ungroup"})", "count"), 2);
    EXPECT_EQ(stage.number(R"({"do":"delete"})", "count"), 2);
    EXPECT_TRUE(stage.selection.empty());
    EXPECT_EQ(stage.number(R"({"do":"delete","ids":[1]})", "count"), 1);
    stage.ok(R"({"do":"rename","id":3,"name":"Old oak"})");
    EXPECT_EQ(stage.object(3).name, "Old oak");
    stage.ok(R"({"do":"assign","id":3,"template":"leaf"})");
    EXPECT_EQ(stage.document->scene().templateName(stage.object(3).templateId), "leaf");
}

TEST(Script, DropsAlignsAndScatters)
{
    Stage stage;
    stage.ok(R"({"do":"move","ids":[5],"by":[0,70,0]})");
    stage.ok(R"({"do":"rotate","ids":[5],"to":[0,20,0]})");
    EXPECT_EQ(stage.number(R"({"do":"drop","ids":[5]})", "count"), 1);
    const glm::dvec3 at = stage.object(5).transform.position;
    EXPECT_LT(boundsOf(*stage.document, std::vector{io::ObjectId{5}}).min.y, 40);
    stage.ok(R"({"do":"align","ids":[5]})");
    const glm::dvec3 up = io::orientation(stage.object(5).transform.rotation) * glm::dvec3{0, 1, 0};
    EXPECT_LT(up.y, 0.99999);
    EXPECT_NEAR(stage.object(5).transform.position.x, at.x, 8);
    stage.ok(R"({"do":"align","ids":[1,2,3],"axis":"x","to":"primary"})");
    EXPECT_EQ(stage.object(1).transform.position.x, stage.object(3).transform.position.x);
    const double count = stage.number(
        R"({"do":"scatter","templates":["blob","leaf"],"center":[0,0],"radius":40,"density":0.02,"seed":3})", "count");
    EXPECT_NEAR(count, 0.02 * 3.14159 * 1600, 6);
}

TEST(Script, SetsAndGetsEveryKindOfKey)
{
    Stage stage;
    const auto roundTrip = [&](const std::string& key, const std::string& value) {
        stage.ok("{\"do\":\"set\",\"key\":\"" + key + "\",\"value\":" + value + "}");
        const io::Value got = stage.ok("{\"do\":\"get\",\"key\":\"" + key + "\"}");
        EXPECT_EQ(io::writeJson(*got.find("value")), value) << key;
    };
    roundTrip("environment.sun.azimuth", "120");
    roundTrip("environment.sun.mode", "\"manual\"");
    roundTrip("environment.time", "7.25");
    roundTrip("environment.shadows.cascades", "2");
    roundTrip("environment.fog.tint", "[1,0.5,0.25]");
    roundTrip("camera.Lookout.fov", "45");
    roundTrip("template.blob.sink", "0.5");
    roundTrip("template.blob.collision", "\"capsule\"");
    roundTrip("object.3.position", "[1,2.5,-3]");
    roundTrip("object.3.position.y", "9");
    roundTrip("object.3.name", "\"oak\"");
    roundTrip("object.3.template", "\"leaf\"");
    const std::size_t steps = stage.document->history().position();
    EXPECT_GE(steps, 11u);
    stage.document->goTo(0);
    EXPECT_EQ(test::text(stage.document->scene()), test::text(test::forest(60, 21)->scene()));
}

TEST(Script, WhatFailsSaysWhyAndChangesNothing)
{
    Stage stage;
    stage.ok(R"({"do":"group","ids":[1,2],"name":"pair"})"); // becomes 61
    stage.ok(R"({"do":"select","ids":[]})");
    const std::string before = test::text(stage.document->scene());
    const std::size_t steps = stage.document->history().position();
    for (const char* line : {R"({"do":"fly"})",
                             R"({"nothing":1})",
                             R"([1,2])",
                             R"("do")",
                             R"({"do":5})",
                             R"({"do":"sculpt","tool":"raise"})",
                             R"({"do":"paint"})",
                             R"({"do":"place"})",
                             R"({"do":"place","template":"nope","at":[0,0,0]})",
                             R"({"do":"place","template":"blob"})",
                             R"({"do":"place","template":"blob","at":[0,0,0],"pixel":[1,1]})",
                             R"({"do":"place","template":"blob","at":[0]})",
                             R"({"do":"place","template":"blob","at":[1e300,0,0]})",
                             R"({"do":"place","template":"blob","at":[9000,9000]})",
                             R"({"do":"place","template":"blob","pixel":[320,1]})",
                             R"({"do":"place","template":"blob","at":[0,0,0],"scale":0})",
                             R"({"do":"place","template":"blob","at":[0,0,0],"yawn":3})",
                             R"({"do":"place","template":"blob","at":"here"})",
                             R"({"do":"move","by":[1,0,0]})",
                             R"({"do":"move","by":[1,0,0],"ids":[4711]})",
                             R"({"do":"move","by":[1,0,0],"ids":[1.5]})",
                             R"({"do":"move","by":[1,0,0],"ids":["1"]})",
                             R"({"do":"move","ids":[1]})",
                             R"({"do":"move","ids":[1],"by":[1,0,0],"to":[1,0,0]})",
                             R"({"do":"move","ids":[1],"by":[1,0,0],"space":"sideways"})",
                             R"({"do":"move","ids":[1],"by":[9999999,9999999,0]})",
                             R"({"do":"scale","ids":[1],"by":0})",
                             R"({"do":"scale","ids":[1,2,3,4,5],"by":999999,"space":"local"})",
                             R"({"do":"scale","ids":[1],"by":[1,0,1]})",
                             R"({"do":"rotate","ids":[1],"by":"90"})",
                             R"({"do":"delete"})",
                             R"({"do":"ungroup","ids":[3]})",
                             R"({"do":"select"})",
                             R"({"do":"select","ids":[1],"mode":"maybe"})",
                             R"({"do":"select","box":[1,2,3]})",
                             R"({"do":"select","pixel":[1]})",
                             R"({"do":"rename","id":3})",
                             R"({"do":"assign","id":61,"template":"blob"})",
                             R"({"do":"align","ids":[1],"axis":"w"})",
                             R"({"do":"set","key":"environment.sun.azimuth","value":"east"})",
                             R"({"do":"set","key":"environment.sun.azimut","value":1})",
                             R"({"do":"set","key":"environment","value":1})",
                             R"({"do":"set","key":"moon.phase","value":1})",
                             R"({"do":"set","key":"","value":1})",
                             R"({"do":"set","key":"object.3.scale","value":[1,0,1]})",
                             R"({"do":"set","key":"object.3.parent","value":4})",
                             R"({"do":"set","key":"object.61.parent","value":61})",
                             R"({"do":"set","key":"object.3.template","value":"nope"})",
                             R"({"do":"set","key":"object.9999.name","value":"x"})",
                             R"({"do":"set","key":"camera.Nobody.fov","value":50})",
                             R"({"do":"set","key":"camera.Lookout.fov","value":500})",
                             R"({"do":"set","key":"camera.Lookout.name","value":""})",
                             R"({"do":"set","key":"render.fog","value":true})",
                             R"({"do":"get","key":"nothing.at.all"})",
                             R"({"do":"set","key":"environment.time"})",
                             R"({"do":"object","id":4711})",
                             R"({"do":"height","at":[99999,0]})",
                             R"({"do":"pick"})",
                             R"({"do":"redo"})",
                             R"({"do":"render"})",
                             R"({"do":"render","out":"a.png","show":"nonsense"})",
                             R"({"do":"render","out":"a.png","size":[0,4]})",
                             R"({"do":"view","pitch":200})",
                             R"({"do":"scatter","templates":["blob"]})",
                             R"({"do":"scatter","templates":[],"center":[0,0]})",
                             R"({"do":"scatter","templates":["blob"],"center":[0,0],"radius":10000,"density":100})",
                             R"({"do":"save_as","path":""})"}) {
        const io::Value answer = stage.run(line);
        ASSERT_TRUE(answer.find("ok") && answer.find("ok")->asBool()) << line;
        EXPECT_FALSE(*answer.find("ok")->asBool()) << line;
        const io::Value* error = answer.find("error");
        EXPECT_TRUE(error && error->asString() && !error->asString()->empty()) << line;
        EXPECT_EQ(test::text(stage.document->scene()), before) << line;
        EXPECT_EQ(stage.document->history().position(), steps) << line;
    }
    EXPECT_TRUE(stage.rendered.empty());
}

TEST(Script, UndoAndRedoGoByName)
{
    Stage stage;
    const std::string before = test::text(stage.document->scene());
    stage.ok(placeAt(3, 4));
    stage.ok(R"({"do":"rename","id":1,"name":"first"})");
    const io::Value undone = stage.ok(R"({"do":"undo"})");
    EXPECT_EQ(*undone.find("undone")->asString(), "Rename to first");
    EXPECT_EQ(*stage.ok(R"({"do":"undo"})").find("undone")->asString(), "Place marker");
    EXPECT_EQ(test::text(stage.document->scene()), before);
    stage.ok(R"({"do":"redo"})");
    const io::Value history = stage.ok(R"({"do":"history"})");
    EXPECT_EQ(history.find("steps")->asArray()->size(), 2u);
    EXPECT_EQ(*history.find("position")->asNumber(), 1);
}

TEST(Script, AnswersQuestions)
{
    Stage stage;
    EXPECT_EQ(stage.number(R"({"do":"objects"})", "count"), 60);
    EXPECT_EQ(stage.ok(R"({"do":"objects","limit":5})").find("objects")->asArray()->size(), 5u);
    const io::Value object = stage.ok(R"({"do":"object","id":3})");
    EXPECT_TRUE(object.find("position") && object.find("template")->asString() && object.find("bounds"));
    EXPECT_EQ(stage.number(R"({"do":"stats"})", "objects"), 60);
    EXPECT_EQ(stage.number(R"({"do":"stats"})", "draw_calls"), 7);
    EXPECT_EQ(*stage.ok(R"({"do":"pick","pixel":[320,1]})").find("surface")->asString(), "none");
    EXPECT_FALSE(stage.ok(R"({"do":"pick","pixel":[320,300],"all":true})").find("hits")->asArray()->empty());
    EXPECT_EQ(stage.number(R"({"do":"view","camera":"Lookout"})", "pitch"), -15);
    stage.ok(R"({"do":"render","out":"a.png","size":[320,200]})");
    EXPECT_EQ(stage.rendered, std::vector<std::string>{"a.png 320"});
}

TEST(Script, SeesWhatOthersChangedMeanwhile)
{
    Stage stage;
    removeObjects(*stage.document, "Delete", stage.document->scene().sortedIds());
    const io::Value answer = stage.ok(R"({"do":"pick","pixel":[320,300]})");
    EXPECT_EQ(*answer.find("surface")->asString(), "terrain");
}

TEST(Properties, TextAsTypedOnACommandLineIsUnderstood)
{
    const auto document = test::forest(1, 1);
    EXPECT_TRUE(setProperty(*document, "environment.sun.irradiance", valueFromText("1,0.5,2")));
    EXPECT_EQ(document->scene().environment().sun.irradiance, (glm::vec3{1, 0.5, 2}));
    EXPECT_TRUE(setProperty(*document, "environment.sun.irradiance", valueFromText("[3, 2, 1]")));
    EXPECT_EQ(document->scene().environment().sun.irradiance, (glm::vec3{3, 2, 1}));
    EXPECT_TRUE(setProperty(*document, "template.blob.cast_shadow", valueFromText("off")));
    EXPECT_FALSE(document->scene().find(io::TemplateId{2})->castShadow);
    EXPECT_TRUE(setProperty(*document, "environment.time", valueFromText("6.5")));
    EXPECT_EQ(document->scene().environment().time, 6.5f);
    EXPECT_TRUE(setProperty(*document, "environment.shadows.end_1", valueFromText("60"))); // it counts for nothing yet
    EXPECT_TRUE(setProperty(*document, "environment.shadows.splits", valueFromText("manual")));
    EXPECT_GT(document->scene().environment().shadows.end2, 60) << "the others make room";
    EXPECT_TRUE(setProperty(*document, "object.1.name", valueFromText("17")));
    EXPECT_EQ(document->scene().at(io::ObjectId{1}).name, "17");
}

TEST(Properties, EndsOfCascadesAreSetOneByOneInAnyOrder)
{
    const auto document = test::forest(1, 1);
    const auto shadows = [&]() -> const io::Shadows& { return document->scene().environment().shadows; };
    ASSERT_TRUE(setProperty(*document, "environment.shadows.splits", "manual"));
    ASSERT_TRUE(setProperty(*document, "environment.shadows.cascades", 6));
    EXPECT_FALSE(io::endFault(shadows()));
    ASSERT_TRUE(setProperty(*document, "environment.shadows.cascades", 4));
    for (const auto& [key, metres] : {std::pair{"end_1", 60}, {"end_3", 400}, {"end_2", 170}, {"distance", 900}})
        ASSERT_TRUE(setProperty(*document, "environment.shadows." + std::string{key}, metres)) << key;
    EXPECT_EQ(shadows().end1, 60);
    EXPECT_EQ(shadows().end2, 170);
    EXPECT_EQ(shadows().end3, 400);
    EXPECT_EQ(shadows().distance, 900);
}

TEST(Properties, SeveralOfOneCommandAreLookedAtTogether)
{
    const auto document = test::forest(1, 1);
    const std::string shadows = "environment.shadows.";
    const io::Status set = setProperties(*document, {{shadows + "end_1", "60"}, {shadows + "end_2", "170"}, {shadows + "end_3", "300"}, {shadows + "splits", "manual"}});
    ASSERT_TRUE(set) << set.error().text();
    EXPECT_EQ(document->scene().environment().shadows.end3, 300);
    const io::Environment before = document->scene().environment();
    const io::Status fault = setProperties(*document, {{"environment.time", "3"}, {shadows + "end_2", "200"}, {shadows + "end_3", "190"}});
    EXPECT_EQ(fault ? "" : fault.error().text(), shadows + "end_3: 190 m must be beyond end_2, 200 m");
    EXPECT_TRUE(document->scene().environment() == before);
}

TEST(Properties, LimitsOfTheExposureMakeRoomForEachOther)
{
    const auto document = test::forest(1, 1);
    ASSERT_TRUE(setProperty(*document, "environment.auto_exposure.lowest", 15));
    EXPECT_EQ(document->scene().environment().autoExposure.highest, 15);
    const std::string exposure = "environment.auto_exposure.";
    const io::Status fault = setProperties(*document, {{exposure + "highest", "1"}, {exposure + "lowest", "2"}});
    EXPECT_EQ(fault ? "" : fault.error().text(), exposure + "highest: 1 EV must not be below lowest, 2 EV");
    ASSERT_TRUE(setProperty(*document, "environment.sky.mie_extinction", 2));
    EXPECT_EQ(document->scene().environment().sky.mieScattering, 2);
    ASSERT_TRUE(setProperty(*document, "environment.sky.mie_scattering", 6));
    EXPECT_EQ(document->scene().environment().sky.mieExtinction, 6);
}

TEST(Script, DeletesATemplateWithItsObjectsOrRefuses)
{
    Stage stage;
    const std::string before = test::text(stage.document->scene());
    const io::Value refused = stage.run(R"({"do":"delete_template","template":"blob"})");
    EXPECT_NE(refused.find("error")->asString()->find("delete them too"), std::string::npos);
    EXPECT_EQ(test::text(stage.document->scene()), before);
    const double count = stage.number(R"({"do":"delete_template","template":"blob","objects":true})", "objects");
    EXPECT_GT(count, 0);
    EXPECT_EQ(double(stage.document->scene().objects().size()), 60 - count);
    EXPECT_FALSE(*stage.run(R"({"do":"place","template":"blob","at":[0,0]})").find("ok")->asBool());
    stage.ok(R"({"do":"undo"})");
    EXPECT_EQ(test::text(stage.document->scene()), before);
}
