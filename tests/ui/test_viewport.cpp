// What the mouse does in the viewport.
#include "tests/ui/support/rig.h"

#include <gtest/gtest.h>

using namespace test;
using editor::Key;

namespace {

std::vector<std::uint32_t> selected(Rig& rig)
{
    std::vector<std::uint32_t> ids;
    for (const io::ObjectId id : rig.editor->selection().ids())
        ids.push_back(io::number(id));
    std::sort(ids.begin(), ids.end());
    return ids;
}

using Ids = std::vector<std::uint32_t>;

TEST(Viewport, ClickSelectsAndCtrlToggles)
{
    Rig rig;
    rig.click(rig.onScreen({4, 1, 0}));
    EXPECT_EQ(selected(rig), (Ids{2}));
    rig.hold(true);
    rig.click(rig.onScreen({12, 1, 0}));
    EXPECT_EQ(selected(rig), (Ids{2, 4}));
    rig.click(rig.onScreen({4, 1, 0}));
    EXPECT_EQ(selected(rig), (Ids{4}));
    rig.hold(false);
    rig.click(rig.onScreen({8, 0, 12})); // ground
    EXPECT_TRUE(selected(rig).empty());
}

TEST(Viewport, BoxSelectsWhatItHolds)
{
    Rig rig;
    const ImVec2 a = rig.onScreen({2, 3, 0}), b = rig.onScreen({10, -1, 0});
    rig.drag(a, b);
    EXPECT_EQ(selected(rig), (Ids{2, 3}));
    rig.hold(false, true);
    rig.drag(rig.onScreen({-2, 3, 0}), rig.onScreen({2, -1, 0}));
    EXPECT_EQ(selected(rig), (Ids{1, 2, 3}));
}

TEST(Viewport, GizmoDragIsOneStep)
{
    Rig rig;
    rig.click(rig.onScreen({8, 1, 0}));
    const ImVec2 handle = rig.at("x", "gizmo");
    rig.drag(handle, {handle.x + 120, handle.y});
    EXPECT_GT(rig.position(3).x, 9);
    EXPECT_NEAR(rig.position(3).y, 0, 1e-9);
    EXPECT_EQ(rig.document().history().names().size(), 1u);
    rig.key(editor::ctrl(Key::Z));
    EXPECT_EQ(rig.position(3), (glm::dvec3{8, 0, 0}));
}

TEST(Viewport, EscapeCancelsAGizmoDrag)
{
    Rig rig;
    rig.click(rig.onScreen({8, 1, 0}));
    const ImVec2 handle = rig.at("x", "gizmo");
    rig.move(handle);
    rig.press();
    rig.move({handle.x + 60, handle.y});
    EXPECT_GT(rig.position(3).x, 8);
    rig.key({.key = Key::Escape});
    EXPECT_EQ(rig.position(3), (glm::dvec3{8, 0, 0}));
    rig.move({handle.x + 90, handle.y});
    rig.release();
    EXPECT_EQ(rig.position(3), (glm::dvec3{8, 0, 0}));
    EXPECT_TRUE(rig.document().history().names().empty());
}

TEST(Viewport, PlacingPlacesOneOrMany)
{
    Rig rig;
    rig.click("crate", "template");
    EXPECT_NE(rig.editor->viewport().placing(), io::TemplateId::None);
    rig.hold(false, true);
    rig.click(rig.onScreen({4, 0, 10}));
    rig.click(rig.onScreen({8, 0, 10}));
    EXPECT_NE(rig.editor->viewport().placing(), io::TemplateId::None);
    rig.hold(false);
    rig.click(rig.onScreen({12, 0, 10}));
    EXPECT_EQ(rig.editor->viewport().placing(), io::TemplateId::None);
    EXPECT_EQ(rig.document().scene().objects().size(), 8u);
    EXPECT_EQ(rig.document().history().names().size(), 3u);
    const glm::dvec3 last = rig.position(io::number(rig.editor->selection().primary()));
    EXPECT_NEAR(last.x, 12, 0.2);
    EXPECT_NEAR(last.y, 0, 0.01);
    EXPECT_NEAR(last.z, 10, 0.2);
}

TEST(Viewport, EscapeLeavesPlacing)
{
    Rig rig;
    rig.click("crate", "template");
    rig.move(rig.onScreen({4, 0, 10}));
    rig.key({.key = Key::Escape});
    rig.click(rig.onScreen({4, 0, 10}));
    EXPECT_EQ(rig.document().scene().objects().size(), 5u);
}

TEST(Viewport, ATemplateIsDraggedIn)
{
    Rig rig;
    rig.drag(rig.at("crate", "template"), rig.onScreen({8, 0, 10}));
    ASSERT_EQ(rig.document().scene().objects().size(), 6u);
    EXPECT_NEAR(rig.position(6).z, 10, 0.2);
}

TEST(Viewport, RightButtonLooksAndFlies)
{
    Rig rig;
    const io::Camera before = rig.editor->viewport().camera.camera();
    const ImVec2 at = rig.onScreen({8, 0, 10});
    rig.move(at);
    rig.press(1);
    EXPECT_TRUE(rig.editor->pointerHidden());
    rig.move({at.x + 50, at.y});
    ImGui::GetIO().KeysDown[int(Key::W)] = true;
    rig.frame(20);
    ImGui::GetIO().KeysDown[int(Key::W)] = false;
    rig.release(1);
    EXPECT_FALSE(rig.editor->pointerHidden());
    const io::Camera after = rig.editor->viewport().camera.camera();
    EXPECT_NE(after.yaw, before.yaw);
    EXPECT_LT(after.eye.z, before.eye.z - 0.2);
    EXPECT_EQ(rig.editor->viewport().gizmo.mode, editor::GizmoMode::Translate); // W flew, it was no shortcut
}

TEST(Viewport, OnlyAClickOfTheRightButtonOpensTheMenu)
{
    Rig rig;
    const ImVec2 at = rig.onScreen({8, 0, 10});
    rig.click(at, 1);
    EXPECT_TRUE(rig.has("Paste", "menu item", "popup"));
    rig.key({.key = Key::Escape});
    rig.move(at);
    rig.press(1);
    ImGui::GetIO().KeysDown[int(Key::W)] = true;
    rig.frame(5);
    ImGui::GetIO().KeysDown[int(Key::W)] = false;
    rig.release(1); // flown, with the mouse at rest
    EXPECT_FALSE(rig.has("Paste", "menu item", "popup"));
}

TEST(Viewport, TheWayToAPressDoesNotTurnTheView)
{
    Rig rig;
    const io::Camera before = rig.editor->viewport().camera.camera();
    rig.move(rig.onScreen({0, 0, 10}));
    ImGui::GetIO().MousePos = rig.onScreen({12, 0, 10}); // within the frame that sees the press: a slow one
    rig.press(1);
    EXPECT_EQ(rig.editor->viewport().camera.camera().yaw, before.yaw);
    rig.release(1);
}

} // namespace
