// The window around the panels: tabs, menus, keys, languages, dialogs.
#include "editor/layout.h"
#include "editor/text.h"
#include "editor/ui_map.h"
#include "tests/ui/support/rig.h"

#include <gtest/gtest.h>
#include <set>

using namespace test;
using editor::Key;
using editor::Region;

namespace {

TEST(Window, ATabIsDraggedToAnotherRegion)
{
    Rig rig;
    const ImVec2 hierarchy = rig.at("Hierarchy", "tab");
    rig.drag(rig.at("Console", "tab"), {hierarchy.x + 100, hierarchy.y});
    EXPECT_EQ(rig.editor->workspace().layout().at(Region::Left).panels,
              (std::vector<std::string>{"hierarchy", "console"}));
    EXPECT_EQ(rig.editor->workspace().layout().at(Region::Left).front, "console");
}

TEST(Window, APanelIsHiddenAndBroughtBack)
{
    Rig rig;
    rig.click("Hide Hierarchy", "button");
    EXPECT_FALSE(rig.editor->workspace().shows("hierarchy"));
    EXPECT_FALSE(rig.has("Hierarchy", "tab"));
    rig.click("View", "menu");
    rig.move(rig.at("Panels", "menu"));
    rig.frame(30);
    rig.click("Hierarchy", "menu item");
    EXPECT_TRUE(rig.has("Hierarchy", "tab"));
}

TEST(Window, ASplitterResizes)
{
    Rig rig;
    const float before = rig.editor->workspace().layout().at(Region::Left).size;
    const ImVec2 grip = rig.at("left", "splitter");
    rig.drag(grip, {grip.x + 64, grip.y});
    EXPECT_NEAR(rig.editor->workspace().layout().at(Region::Left).size, before + 64, 2);
}

TEST(Window, TheLayoutIsRemembered)
{
    io::Value saved;
    {
        Rig rig;
        rig.click("History", "tab");
        rig.click("Hide History", "button");
        rig.editor->saveLayout();
        saved = rig.host.saved;
    }
    Rig rig{crates(1), saved};
    EXPECT_FALSE(rig.editor->workspace().shows("history"));
}

TEST(Window, TheBrushIsRemembered)
{
    io::Value saved;
    {
        Rig rig;
        rig.editor->viewport().brush.radius = 55;
        rig.editor->viewport().brush.tool = editor::BrushTool::Noise;
        rig.editor->viewport().brush.stampFile = "textures/crater.png";
        rig.editor->viewport().objectsFollow = false;
        rig.editor->saveLayout();
        saved = rig.host.saved;
    }
    Rig rig{crates(1), saved};
    EXPECT_EQ(rig.editor->viewport().brush.radius, 55);
    EXPECT_EQ(rig.editor->viewport().brush.tool, editor::BrushTool::Noise);
    EXPECT_EQ(rig.editor->viewport().brush.stampFile, "textures/crater.png");
    EXPECT_FALSE(rig.editor->viewport().objectsFollow);
}

TEST(Window, LanguageIsSwitchedWhileItRuns)
{
    Rig rig;
    rig.click("View", "menu");
    rig.move(rig.at("Language", "menu"));
    rig.frame(30);
    rig.click("Čeština", "menu item");
    EXPECT_TRUE(rig.has("Hierarchie", "tab"));
    EXPECT_TRUE(rig.has("Úpravy", "menu"));
    EXPECT_TRUE(editor::missingTexts().empty());
}

TEST(Window, NothingShownLacksItsText)
{
    for (const char* language : {"en", "cs"}) {
        Rig rig;
        rig.host.setLanguage(language);
        rig.editor->selection().set(io::ObjectId{2});
        for (const editor::Panel* panel : rig.editor->workspace().panels()) {
            rig.editor->workspace().bringToFront(panel->id());
            rig.frame(2);
        }
        for (const char* menu : {"menu.file", "menu.edit", "menu.view", "menu.tools", "menu.help"}) {
            rig.click(editor::tr(menu), "menu");
            rig.key({.key = Key::Escape});
        }
        editor::Dialogs& dialogs = rig.editor->dialogs();
        const std::function<void()> shows[] = {[&] { dialogs.showOpen(*rig.editor); }, [&] { dialogs.showNew(); },
                                               [&] { dialogs.showSaveAs(*rig.editor); }, [&] { dialogs.showKeys(); }};
        for (const auto& show : shows) {
            show();
            rig.frame(3);
            EXPECT_TRUE(dialogs.any());
            rig.key({.key = Key::Escape});
            EXPECT_FALSE(dialogs.any());
        }
        for (const char* action : {"generate_ground", "reshape_ground"}) {
            rig.editor->actions().run(action);
            rig.frame(3);
            EXPECT_TRUE(rig.editor->groundDialogs().any());
            rig.key({.key = Key::Escape});
            EXPECT_FALSE(rig.editor->groundDialogs().any());
        }
        EXPECT_EQ(editor::missingTexts(), std::vector<std::string>{});
    }
}

TEST(Window, KeysRunActions)
{
    Rig rig;
    rig.key({.key = Key::R});
    EXPECT_EQ(rig.editor->viewport().gizmo.mode, editor::GizmoMode::Scale);
    rig.key({.key = Key::Digit2});
    EXPECT_EQ(rig.editor->viewport().gizmo.mode, editor::GizmoMode::Rotate);
    rig.key(editor::ctrl(Key::A));
    EXPECT_EQ(rig.editor->selection().size(), 5u);
    rig.key({.key = Key::Delete});
    EXPECT_TRUE(rig.document().scene().objects().empty());
    rig.key(editor::ctrl(Key::Z));
    EXPECT_EQ(rig.document().scene().objects().size(), 5u);
}

TEST(Window, KeysAreTextWhileTextIsTyped)
{
    Rig rig;
    rig.click("Search objects", "text");
    rig.key({.key = Key::R});
    rig.key(editor::ctrl(Key::A));
    EXPECT_EQ(rig.editor->viewport().gizmo.mode, editor::GizmoMode::Translate);
    EXPECT_TRUE(rig.editor->selection().empty());
}

TEST(Window, EveryActionHasATextAndRuns)
{
    Rig rig;
    for (const editor::Action& action : rig.editor->actions().all()) {
        EXPECT_TRUE(editor::hasText("action." + std::string{action.id})) << action.id;
        EXPECT_TRUE(action.run) << action.id;
    }
}

TEST(Window, ToolbarButtonAndMenuAreOneAction)
{
    Rig rig;
    rig.click("Snap", "button", "toolbar");
    EXPECT_TRUE(rig.editor->viewport().snapping);
    rig.click("Tools", "menu");
    EXPECT_EQ(rig.value("Snap", "menu item"), io::Value{true});
    rig.click("Snap", "menu item");
    EXPECT_FALSE(rig.editor->viewport().snapping);
}

TEST(Window, ClosingAsksWhenThereAreChanges)
{
    Rig rig;
    editor::edit(rig.document(), "Move", std::vector{io::ObjectId{1}},
                 [](io::Object& o) { o.transform.position.y = 3; });
    rig.frame();
    EXPECT_NE(rig.editor->title().find('*'), std::string::npos);
    rig.editor->requestClose();
    rig.frame(3);
    EXPECT_FALSE(rig.editor->wantsClose());
    rig.click("Cancel", "button", "dialog");
    EXPECT_FALSE(rig.editor->wantsClose());
    rig.editor->requestClose();
    rig.frame(3);
    rig.click("Discard changes", "button", "dialog");
    EXPECT_TRUE(rig.editor->wantsClose());
}

TEST(Window, ClosingWithoutChangesDoesNotAsk)
{
    Rig rig;
    rig.editor->requestClose();
    EXPECT_TRUE(rig.editor->wantsClose());
}

TEST(Window, AProjectThatCannotBeOpenedIsAMessage)
{
    Rig rig;
    EXPECT_FALSE(rig.editor->open("/nowhere/at/all"));
    rig.frame(3);
    EXPECT_TRUE(rig.has("OK", "button", "dialog"));
    EXPECT_EQ(rig.document().scene().objects().size(), 5u); // what was open stays open
    rig.click("OK", "button", "dialog");
    EXPECT_FALSE(rig.editor->dialogs().any());
}

TEST(Window, TheStartPageOffersWhatWasOpened)
{
    Rig rig{nullptr};
    rig.host.recent = {"/home/anna/alps"};
    rig.editor->listProjects(); // as the start view does when it comes to the front
    rig.frame(2);
    EXPECT_TRUE(rig.has("alps", "project", "start"));
    EXPECT_TRUE(rig.has("New project", "button", "start"));
}

TEST(Window, EveryWidgetIsOnTheMapOnceAndInTheWindow)
{
    Rig rig;
    rig.editor->selection().set(io::ObjectId{2});
    rig.frame(3);
    const io::Value map = editor::uiMap();
    ASSERT_GT(map.asArray()->size(), 40u);
    for (const io::Value& item : *map.asArray()) {
        EXPECT_FALSE(item.find("label")->asString()->empty()) << *item.find("kind")->asString();
        const io::Value::Array& rect = *item.find("rect")->asArray();
        EXPECT_GE(*rect[0].asNumber(), 0);
        EXPECT_GE(*rect[1].asNumber(), 0);
        EXPECT_LE(*rect[0].asNumber() + *rect[2].asNumber(), 1280.5);
        EXPECT_LE(*rect[1].asNumber() + *rect[3].asNumber(), 720.5);
    }
}

TEST(Layout, BrokenValuesFallBackToHome)
{
    editor::Layout home;
    home.at(Region::Left) = {{"a", "b"}, "a", 200};
    home.at(Region::Centre) = {{"v"}, "v", 0};
    home.hidden = {"c"};
    EXPECT_EQ(layoutFrom(toValue(home), home), home);
    EXPECT_EQ(layoutFrom({}, home), home);
    EXPECT_EQ(layoutFrom("nonsense", home), home);

    io::Value broken;
    broken["left"]["tabs"] = io::Value::Array{"nosuch", 7, "c", "c", nullptr};
    broken["left"]["size"] = 1e99;
    broken["left"]["front"] = "nosuch";
    broken["bottom"] = 3;
    broken["hidden"] = io::Value::Array{"b", "nosuch"};
    const editor::Layout mended = layoutFrom(broken, home);
    EXPECT_EQ(mended.at(Region::Left).panels, (std::vector<std::string>{"a", "c"}));
    EXPECT_EQ(mended.at(Region::Left).front, "a");
    EXPECT_LE(mended.at(Region::Left).size, 4000);
    EXPECT_EQ(mended.hidden, (std::vector<std::string>{"b"}));
}

} // namespace
