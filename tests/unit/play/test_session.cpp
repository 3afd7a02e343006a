#include "stage.h"

#include "app/play/session.h"
#include "app/play/step_clock.h"
#include "io/base/random.h"
#include "io/scene/instances.h"

#include <gtest/gtest.h>

namespace play {
namespace {

io::Camera above(double x, double z)
{
    return {.eye = {x, 3, z}};
}

test::Stage world()
{
    test::Stage stage;
    stage.setGround([](double x, double) { return x * 0.05; });
    const io::TemplateId box = stage.addBox({1, 2, 1});
    for (int i = 0; i < 5; ++i)
        stage.place(box, {i * 3.0 - 6, 0, -6});
    return stage;
}

std::string traceOf(Session& session, int steps)
{
    io::Random random{3};
    std::string trace;
    for (int i = 0; i < steps; ++i) {
        session.step({.move = {random.signedUnit(), 1}, .yaw = random.range(-3, 3), .run = true, .jump = random.chance(0.05f)});
        trace += traceLine(session);
    }
    return trace;
}

TEST(Session, TheSameInputIsTheSameToTheLastBit)
{
    const test::Stage stage = world();
    Session one{stage.scene, stage.assets, above(0, 0)}, other{stage.scene, stage.assets, above(0, 0)};
    EXPECT_EQ(traceOf(one, 600), traceOf(other, 600));
}

// The mouse goes on evenly and is told in each frame; whatever the length of a frame, a step gets as much of it.
TEST(Session, TheWalkIsTheSameAtAnyFrameRate)
{
    const test::Stage stage = world();
    const auto endOf = [&](int framesInASecond, double& yaw) {
        Session session{stage.scene, stage.assets, above(0, 0)};
        StepClock clock;
        for (int i = 0; i < 3 * framesInASecond; ++i)
            clock.pass(1.0 / framesInASecond, glm::dvec2{180.0 / framesInASecond, 0}, [&](const glm::dvec2& turned) {
                yaw += turned.x;
                session.step({.move = {0, 1}, .run = true});
            });
        EXPECT_NEAR(double(session.steps()), 180, 1) << framesInASecond;
        while (session.steps() < 181)
            session.step({.move = {0, 1}, .run = true});
        return session.walker().feet();
    };
    double yaw = 0;
    const glm::dvec3 wanted = endOf(60, yaw);
    for (const int rate : {10, 24, 144, 200, 1000}) {
        yaw = 0;
        EXPECT_EQ(endOf(rate, yaw), wanted) << rate;
        EXPECT_NEAR(yaw, 540, 180.0 / 60 + 180.0 / rate) << rate; // all of it, but for what the last step has not had
    }
}

TEST(Session, TheThirdPersonsCameraKeepsBeforeWalls)
{
    test::Stage stage;
    stage.setGround([](double, double) { return 0.0; });
    const io::TemplateId wall = stage.addBox({20, 10, 0.2});
    stage.place(wall, {0, 0, 1.5}); // behind the back of one who looks along -Z
    Session session{stage.scene, stage.assets, above(0, 0)};
    session.step({}, true);
    for (int i = 0; i < 120; ++i)
        session.step({});
    EXPECT_LT(session.camera().eye.z, 1.4);
    EXPECT_GT(session.camera().eye.z, 0.9);
    for (int i = 0; i < 240; ++i)
        session.step({.move = {0, 1}}); // away from it: the camera comes back to its place
    EXPECT_NEAR(glm::distance(session.camera().eye, session.walker().eye()), double(session.walker().likes().behind), 0.05);
}

TEST(Session, BeginsAtTheMarkerEvenUnderTheGround)
{
    test::Stage stage = world();
    const io::TemplateId start = stage.addBox({1, 1, 1}, io::Collision::None);
    io::Template value = *stage.scene.find(start);
    value.player = {.start = true, .walk = 3};
    stage.scene.exchange(start, value);
    stage.place(start, {10, -40, 10}, {0, 90, 0});
    Session session{stage.scene, stage.assets, above(0, 0)};
    EXPECT_NEAR(session.walker().feet().x, 10, 0.5);
    EXPECT_GE(session.walker().feet().y, 0.5);
    EXPECT_EQ(session.walker().yaw(), 90);
    EXPECT_EQ(session.walker().likes().walk, 3);
}

TEST(Session, TriggersDoWhatTheySayAndTheDocumentStaysAsItWas)
{
    test::Stage stage = world();
    io::Object named = stage.scene.objects()[2];
    const io::ObjectId outer = stage.place(io::TemplateId::None, {0, 0, 0}), inner = stage.place(io::TemplateId::None, {0, 0, 0});
    for (const auto& [id, parent, name] : {std::tuple{outer, io::ObjectId::None, "door"}, std::tuple{inner, outer, "wing"}}) {
        io::Object group = stage.scene.at(id);
        group.parent = parent;
        group.name = name;
        stage.scene.exchange(id, group);
    }
    named.parent = inner; // in a group in the group that is meant
    stage.scene.exchange(named.id, named);
    const io::TemplateId place = stage.addBox({1, 1, 1}, io::Collision::None);
    io::Template value = *stage.scene.find(place);
    value.trigger = {.shape = io::TriggerShape::Sphere, .size = {4, 4, 4}, .once = true,
                     .actions = {{.action = io::TriggerDo::Hide, .what = "door"}, {.action = io::TriggerDo::Message, .what = "open"}}};
    stage.scene.exchange(place, value);
    stage.place(place, {0, 0, -4});
    const io::Scene before = stage.scene;
    Session session{stage.scene, stage.assets, above(0, 0)};
    int messages = 0;
    for (int i = 0; i < 300; ++i) {
        session.step({.move = {0, 1}});
        messages += int(session.events().size());
    }
    EXPECT_EQ(messages, 1);
    EXPECT_EQ(session.scene().find(named.id), nullptr);
    EXPECT_LT(session.walker().feet().z, -7); // through where the door was
    EXPECT_TRUE(io::sameContent(before, stage.scene));
    EXPECT_EQ(session.differences().objects, std::vector{named.id});
}

TEST(Session, PlantedTriggersActToo)
{
    test::Stage stage = world();
    const io::TemplateId bell = stage.addBox({1, 1, 1}, io::Collision::None);
    io::Template value = *stage.scene.find(bell);
    value.name = "bell";
    value.trigger = {.shape = io::TriggerShape::Box, .size = {2, 4, 2}, .once = true, .actions = {{.action = io::TriggerDo::Message, .what = "ding"}}};
    stage.scene.exchange(stage.scene.templateSlot("bell"), value);
    const io::ScatterId layer = stage.scene.freshScatterId();
    stage.scene.exchange(std::vector<io::ScatterLayer>{{.id = layer, .name = "bells", .species = {{.templateName = "bell"}}}});
    const io::PlacedInstance near = io::instanceAt({.position = {0, 0, -3}}, 0), far = io::instanceAt({.position = {20, 0, 20}}, 0);
    for (const io::PlacedInstance& placed : {near, far})
        stage.scene.exchange(io::LayerTile{layer, placed.tile}, std::make_shared<const io::InstanceTile>(io::InstanceTile{.instances = {placed.instance}}));
    Session session{stage.scene, stage.assets, above(0, 0)};
    int heard = 0;
    for (int i = 0; i < 240; ++i) {
        session.step({.move = {0, 1}});
        for (const Event& event : session.events())
            heard += event.what == "ding";
    }
    EXPECT_EQ(heard, 1);
}

TEST(Session, WhatAppearsAroundThePlayerPushesItOut)
{
    for (const io::Collision collision : {io::Collision::Mesh, io::Collision::Box, io::Collision::Hull}) {
        test::Stage stage;
        stage.setGround([](double, double) { return 0.0; });
        const io::ObjectId block = stage.place(stage.addBox({6, 5, 6}, collision), {0, 0, -10});
        io::Object named = stage.scene.at(block);
        named.name = "block";
        stage.scene.exchange(block, named);
        const auto trigger = [&](const char* name, io::TriggerDo what, double z) {
            const io::TemplateId id = stage.scene.templateSlot(name);
            stage.scene.exchange(id, io::Template{.name = name, .trigger = {.shape = io::TriggerShape::Sphere, .size = glm::vec3{2}, .actions = {{.action = what, .what = "block"}}}});
            stage.place(id, {0, 1, z});
        };
        trigger("away", io::TriggerDo::Hide, -1);
        trigger("back", io::TriggerDo::Show, -10);
        Session session{stage.scene, stage.assets, above(0, 2)};
        bool within = false;
        for (int i = 0; i < 300; ++i) {
            session.step({.move = {0, 1}, .run = true});
            within |= session.walker().feet().z < -7;
            if (session.scene().find(block) && within) {
                ASSERT_LT(session.walker().depth(session.surroundings()), 0.01) << int(collision) << " " << i;
                ASSERT_FALSE(session.surroundings().buried(session.walker().centre())) << int(collision) << " " << i;
            }
        }
        EXPECT_TRUE(within && session.scene().find(block)) << int(collision);
        EXPECT_FALSE(session.changed(block)) << "it stands again where it stood";
    }
}

TEST(Session, ATriggerThinnerThanAStepIsLongIsMet)
{
    test::Stage stage;
    stage.setGround([](double, double) { return 0.0; });
    for (const io::TriggerShape shape : {io::TriggerShape::Box, io::TriggerShape::Sphere}) {
        const io::TemplateId id = stage.scene.templateSlot("thin");
        stage.scene.exchange(id, io::Template{.name = "thin", .trigger = {.shape = shape, .size = {shape == io::TriggerShape::Box ? 20.0f : 0.6f, 4, 0.05f}, .actions = {{.what = "met"}}}});
        const io::ObjectId gate = stage.place(id, {0, 3, 0}, {0, 0, 0});
        int met = 0;
        Session session{stage.scene, stage.assets, {.eye = {0.1, 3.9, 20}}, false};
        for (int i = 0; i < 30; ++i) { // flying, 64 m/s: more than a metre a step
            session.step({.move = {0, 1}, .run = true, .fly = i == 0});
            met += int(session.events().size());
        }
        EXPECT_LT(session.walker().feet().z, -5) << "it flew through";
        EXPECT_EQ(met, 1);
        stage.scene.exchange(gate, std::nullopt);
    }
}

TEST(Session, TheCameraIsFixedToAPointOfThePlayerAndKeepsOutOfWalls)
{
    test::Stage stage;
    stage.setGround([](double, double) { return 0.0; });
    const io::TemplateId start = stage.scene.templateSlot("start");
    stage.scene.exchange(start, io::Template{.name = "start", .player = {.start = true, .camera = {0.6f, 0.2f, -0.3f}}});
    stage.place(start, {0, 0, 0}, {0, 90, 0}); // looks along -X: its right is -Z, behind it +X
    Session session{stage.scene, stage.assets, above(0, 0)};
    session.step({});
    const glm::dvec3 from = session.camera().eye - session.walker().eye();
    EXPECT_NEAR(from.x, 0.3, 1e-5);
    EXPECT_NEAR(from.y, 0.2, 1e-5);
    EXPECT_NEAR(from.z, -0.6, 1e-5);
    stage.place(stage.addBox({4, 4, 0.1f}), {0, 0, -0.7});
    Session beside{stage.scene, stage.assets, above(0, 0)};
    beside.step({});
    EXPECT_GT(beside.camera().eye.z, -0.5);
}

TEST(Session, StepsSoundAsTheGroundThatShows)
{
    test::Stage stage;
    stage.setGround([](double, double) { return 0; });
    stage.scene.exchange(io::Terrain{.origin = {-32, -32}, .layers = {{.name = "grass", .steps = "sounds/grass.ogg"}}});
    Session session{stage.scene, stage.assets, above(0, 0)};
    std::string trace;
    for (int i = 0; i < 180; ++i) {
        session.step({.move = {0, 1}});
        trace += traceLine(session);
    }
    EXPECT_NE(trace.find("\"sounds\":[\"sounds/grass.ogg\"]"), std::string::npos) << trace.substr(0, 400);
}

TEST(Controls, AnActionThatWasTakenAwayHasNone)
{
    const io::Control bindings[]{{"jump", ""}};
    Controls controls{bindings};
    EXPECT_FALSE(controls.wish({{"Space", 1}, {"", 1}}, {}).jump);
}

TEST(Controls, AProjectsBindingsReplaceTheUsualOnes)
{
    const io::Control bindings[]{{"jump", "mouse 1"}};
    Controls controls{bindings};
    EXPECT_FALSE(controls.wish({{"Space", 1}}, {}).jump);
    EXPECT_TRUE(controls.wish({{"mouse 1", 1}}, {}).jump);
    EXPECT_EQ(controls.wish({{"W", 1}, {"pad left +x", 0.5}}, {}).move, glm::dvec2(0.5, 1));
    EXPECT_TRUE(controls.wish({{"F", 1}}, {}).fly);
    EXPECT_FALSE(controls.wish({{"F", 1}}, {}).fly); // held on is no second press
}

} // namespace
} // namespace play
