// When the window draws: while something happens or moves, and not otherwise.
#include "editor/arrange.h"
#include "tests/ui/support/rig.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace test;
using editor::Key;

namespace {

constexpr int kSecond = 60; // frames

bool rests(Rig& rig)
{
    return std::isinf(rig.editor->nextFrameIn());
}

TEST(Rest, ComesWhenNothingHappens)
{
    Rig rig;
    EXPECT_EQ(rig.editor->nextFrameIn(), 0); // a tooltip may be due
    rig.frame(kSecond);
    EXPECT_TRUE(rests(rig));
    rig.move(rig.onScreen({4, 0, 10}));
    EXPECT_EQ(rig.editor->nextFrameIn(), 0);
    rig.frame(kSecond);
    EXPECT_TRUE(rests(rig));
    rig.editor->wake();
    EXPECT_EQ(rig.editor->nextFrameIn(), 0);
}

TEST(Rest, AChangeFromElsewhereIsShown)
{
    Rig rig;
    rig.frame(kSecond);
    rig.editor->step("undo.duplicate", [](editor::Document& document) {
        const std::vector<io::ObjectId> ids{io::ObjectId{2}};
        editor::duplicate(document, ids, {1, 0, 1});
    });
    rig.frame();
    EXPECT_EQ(rig.editor->nextFrameIn(), 0);
}

TEST(Rest, CloudsAndPlantsMoveOnlyWhereThePersonWants)
{
    io::Value saved;
    {
        Rig rig;
        rig.frame(kSecond);
        EXPECT_EQ(rig.editor->time(), 0);
        rig.click("View", "menu");
        rig.click("Animate wind and clouds", "menu item");
        rig.frame(kSecond);
        EXPECT_NEAR(rig.editor->nextFrameIn(), 1 / 30.0, 1e-9);
        EXPECT_GT(rig.editor->time(), 0.9);
        rig.editor->renderSettings.clouds = false;
        EXPECT_TRUE(rests(rig)) << "crates do not sway";
        io::Template reed = *rig.document().scene().find(io::TemplateId{1});
        reed.wind = 1;
        rig.editor->step("undo.edit", [&](editor::Document& document) { editor::setTemplate(document, "reed", io::TemplateId{1}, reed); });
        rig.frame(kSecond);
        EXPECT_FALSE(rests(rig));
        rig.editor->renderSettings.wind = false;
        EXPECT_TRUE(rests(rig));
        rig.editor->saveLayout();
        saved = rig.host.saved;
    }
    Rig next{crates(1), saved};
    EXPECT_TRUE(next.editor->animates());
}

TEST(Rest, AMessageFadesInItsTime)
{
    Rig rig;
    rig.editor->toasts().add(io::log::Level::Info, "saved");
    rig.frame(kSecond);
    const double next = rig.editor->nextFrameIn();
    EXPECT_GT(next, 3);
    EXPECT_LT(next, 4);
    rig.editor->toasts().add(io::log::Level::Info, "again");
    rig.pass(next); // nothing was drawn meanwhile
    EXPECT_EQ(rig.editor->nextFrameIn(), 0);
    EXPECT_TRUE(rig.has("saved", "toast"));
    rig.frame(3 * kSecond);
    EXPECT_FALSE(rig.has("saved", "toast"));
}

TEST(Rest, ATextCursorOnlyBlinks)
{
    Rig rig;
    rig.editor->selection().set(io::ObjectId{2});
    rig.frame(2);
    rig.click("Search objects", "text");
    rig.frame(kSecond);
    EXPECT_TRUE(ImGui::GetIO().WantTextInput);
    EXPECT_GT(rig.editor->nextFrameIn(), 0.1);
    EXPECT_LT(rig.editor->nextFrameIn(), 1);
}

TEST(Rest, TheFirstFrameAfterItDoesNotJump)
{
    Rig rig;
    rig.frame(kSecond);
    rig.editor->wake();
    rig.pass(100); // a key, after a long while
    EXPECT_TRUE(rig.editor->rested());
    EXPECT_EQ(rig.editor->nextFrameIn(), 0); // still to be seen: what it does in the frames after
    rig.frame();
    EXPECT_FALSE(rig.editor->rested());
}

} // namespace
