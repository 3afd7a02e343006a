// What a template triggers and how far it sounds: the lists in the Inspector, and the handles in the viewport.
#include "io/scene/falloff.h"
#include "tests/ui/support/rig.h"

#include <gtest/gtest.h>

using namespace test;

namespace {

constexpr io::TemplateId kCrate{1};

// A crate that makes a sound and is a trigger; its template is shown.
struct Template : testing::Test {
    Rig rig;

    Template()
    {
        io::Template value = now();
        value.sound = {.file = "sounds/hum.ogg", .radius = 6};
        value.trigger.shape = io::TriggerShape::Box;
        setTemplate(rig.document(), "sound", kCrate, value);
        rig.editor->chosenTemplate = kCrate;
        rig.editor->inspectTemplate = true;
        rig.frame(3);
    }
    const io::Template& now() { return *rig.document().scene().find(kCrate); }
    std::size_t steps() { return rig.document().history().position(); }

    // The Inspector is long: turns the wheel over it until the widget is there.
    void scrollTo(std::string_view label, std::string_view kind)
    {
        for (int i = 0; i < 80 && !rig.has(label, kind); ++i) {
            rig.move({ImGui::GetIO().DisplaySize.x - 60, 400});
            ImGui::GetIO().MouseWheel = i < 30 ? -3 : 3; // down, and up again
            rig.frame(2);
        }
        rig.frame(2);
    }
    void choose(std::string_view combo, std::string_view option)
    {
        rig.click(combo, "combo");
        rig.frame(2);
        rig.click(option, "option");
        rig.frame(2);
    }
};

TEST_F(Template, ActionsOfATriggerAreAddedChosenMovedAndRemoved)
{
    io::Object named = rig.document().scene().objects()[0];
    editor::edit(rig.document(), "name", {{named.id}}, [](io::Object& o) { o.name = "door"; });
    const std::size_t before = steps();
    scrollTo("Add an action", "button");
    rig.click("Add an action", "button");
    ASSERT_EQ(now().trigger.actions.size(), 1u);
    EXPECT_EQ(steps(), before + 1);
    scrollTo("Action", "combo");
    choose("Action", "Move the player to a camera");
    EXPECT_EQ(now().trigger.actions[0].action, io::TriggerDo::Teleport);
    choose("What", "view");
    EXPECT_EQ(now().trigger.actions[0].what, "view");
    choose("Action", "Hide");
    EXPECT_EQ(now().trigger.actions[0].what, "") << "a camera is no object";
    choose("What", "door");
    EXPECT_EQ(now().trigger.actions[0].what, "door");
    EXPECT_EQ(steps(), before + 5);
    scrollTo("Add an action", "button");
    rig.click("Add an action", "button");
    ASSERT_EQ(now().trigger.actions.size(), 2u);
    scrollTo("Later", "button");
    rig.click("Later", "button");
    EXPECT_EQ(now().trigger.actions[1].action, io::TriggerDo::Hide);
    rig.click("Remove this action", "button");
    ASSERT_EQ(now().trigger.actions.size(), 1u);
    EXPECT_EQ(now().trigger.actions[0].action, io::TriggerDo::Hide);
    rig.document().undo();
    EXPECT_EQ(now().trigger.actions.size(), 2u);
}

TEST_F(Template, AMessageIsTypedInOneStep)
{
    io::Template value = now();
    value.trigger.actions = {{.action = io::TriggerDo::Message}};
    setTemplate(rig.document(), "message", kCrate, value);
    rig.frame(2);
    const std::size_t before = steps();
    scrollTo("Message", "text");
    rig.click("Message", "text");
    rig.type("Welcome");
    rig.key({.key = editor::Key::Enter});
    rig.frame(2);
    EXPECT_EQ(now().trigger.actions[0].what, "Welcome");
    EXPECT_EQ(steps(), before + 1);
}

TEST_F(Template, PointsOfTheCurveAreAddedDraggedAndRemoved)
{
    scrollTo("Softer with distance", "curve");
    ImGui::GetIO().MouseWheel = -2; // all of it
    rig.frame(3);
    const std::size_t before = steps();
    const ImVec2 middle = rig.at("Softer with distance", "curve");
    rig.doubleClick(middle);
    ASSERT_EQ(now().sound.falloff.size(), 3u); // with the ends
    EXPECT_NEAR(now().sound.falloff[1].at, 0.5, 0.05);
    EXPECT_EQ(steps(), before + 1);
    rig.drag(rig.at("2", "falloff key"), {middle.x + 30, middle.y + 20});
    EXPECT_GT(now().sound.falloff[1].at, 0.52);
    EXPECT_LT(now().sound.falloff[1].level, 0.45);
    EXPECT_EQ(steps(), before + 2);
    rig.drag(rig.at("2", "falloff key"), {middle.x + 900, middle.y}); // not past its neighbour
    EXPECT_EQ(now().sound.falloff[1].at, 1);
    rig.document().undo();
    rig.frame(2);
    rig.click(rig.at("2", "falloff key"), 1);
    EXPECT_EQ(now().sound.falloff.size(), 2u);
    rig.document().undo();
    rig.frame(2);
    EXPECT_EQ(now().sound.falloff.size(), 3u);
    rig.click("Usual curve", "button");
    EXPECT_TRUE(now().sound.falloff.empty());
}

TEST_F(Template, TheRadiusIsDraggedInTheViewport)
{
    rig.editor->inspectTemplate = false;
    rig.editor->selection().set(io::ObjectId{3});
    rig.frame(3);
    const std::size_t before = steps();
    const ImVec2 from = rig.at("radius", "sound handle");
    const ImVec2 middle = rig.onScreen(rig.position(3));
    rig.drag(from, {middle.x + (from.x - middle.x) / 2, from.y});
    EXPECT_NEAR(now().sound.radius, 3, 0.3);
    EXPECT_EQ(rig.position(3), glm::dvec3(8, 0, 0));
    EXPECT_EQ(steps(), before + 1);
    rig.document().undo();
    EXPECT_EQ(now().sound.radius, 6);
}

TEST_F(Template, KeysOfTheCurveAreDraggedInTheViewport)
{
    io::Template value = now();
    value.sound.falloff = {{0, 1}, {0.5f, 0.5f}, {1, 0}};
    setTemplate(rig.document(), "curve", kCrate, value);
    rig.editor->inspectTemplate = false;
    rig.editor->selection().set(io::ObjectId{3});
    rig.frame(3);
    const std::size_t before = steps();
    const ImVec2 from = rig.at("key 2", "sound handle");
    rig.drag(from, {from.x + 15, from.y - 12});
    EXPECT_GT(now().sound.falloff[1].at, 0.5);
    EXPECT_GT(now().sound.falloff[1].level, 0.5);
    EXPECT_EQ(now().sound.radius, 6);
    EXPECT_EQ(steps(), before + 1);
}

TEST_F(Template, EscapeLeavesTheRadiusAsItWas)
{
    rig.editor->inspectTemplate = false;
    rig.editor->selection().set(io::ObjectId{3});
    rig.frame(3);
    const std::size_t before = steps();
    const ImVec2 from = rig.at("radius", "sound handle");
    rig.move(from);
    rig.press();
    rig.move({from.x - 40, from.y});
    EXPECT_LT(now().sound.radius, 6);
    rig.key({.key = editor::Key::Escape});
    rig.release();
    EXPECT_EQ(now().sound.radius, 6);
    EXPECT_EQ(steps(), before);
}

TEST(Hearing, IsToggledAndKeptForThePerson)
{
    io::Value saved;
    {
        Rig rig;
        EXPECT_FALSE(rig.editor->sound.hear);
        rig.key({.key = editor::Key::M});
        EXPECT_TRUE(rig.editor->sound.hear);
        rig.editor->workspace().bringToFront("sound");
        rig.frame(3);
        rig.click("Mute", "checkbox", "sound");
        EXPECT_TRUE(rig.editor->sound.muted);
        rig.editor->sound.groups[2] = 0.25f;
        rig.editor->saveLayout();
        saved = rig.host.saved;
    }
    Rig again{crates(1), saved};
    EXPECT_TRUE(again.editor->sound.hear);
    EXPECT_TRUE(again.editor->sound.muted);
    EXPECT_EQ(again.editor->sound.groups[2], 0.25f);
    EXPECT_EQ(again.editor->sound.master, 1);
}

TEST(Hearing, VolumesAreDragged)
{
    Rig rig;
    rig.editor->workspace().bringToFront("sound");
    rig.frame(3);
    const ImVec2 at = rig.at("Music", "number", "sound");
    rig.drag(at, {at.x - 60, at.y});
    EXPECT_LT(rig.editor->sound.groups[2], 1);
    EXPECT_EQ(rig.editor->sound.groups[1], 1);
    EXPECT_FALSE(rig.document().modified()); // they are no part of the world
}

} // namespace
