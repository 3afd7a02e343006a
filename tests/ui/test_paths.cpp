// Camera paths, as a person makes them in their panel and drags their keys in the view.
#include "tests/ui/support/rig.h"

#include <gtest/gtest.h>

using namespace test;
using editor::Key;

namespace {

struct CameraPaths : ::testing::Test {
    Rig rig{crates(3)};
    void SetUp() override
    {
        rig.editor->workspace().bringToFront("paths");
        rig.frame(3);
    }
    const io::CameraPath& path() { return rig.document().scene().paths().front(); }
    void look(const glm::dvec3& eye) { rig.editor->viewport().camera.setCamera({.eye = eye, .pitch = -10}); }
    // Keys at both, and the view far enough back to see them.
    void makeTwo()
    {
        look({-4, 3, 0});
        rig.click("Add path", "button");
        look({4, 3, 0});
        rig.frame(2);
        rig.click("Add the view as a key", "button");
        look({0, 6, 20});
        rig.frame(3);
    }
    std::vector<std::string> names() { return rig.document().history().names(); }
};

TEST_F(CameraPaths, AreMadeOfViews)
{
    makeTwo();
    ASSERT_EQ(rig.document().scene().paths().size(), 1u);
    ASSERT_EQ(path().keys.size(), 2u);
    EXPECT_EQ(path().keys[0].eye, glm::dvec3(-4, 3, 0));
    EXPECT_EQ(path().keys[1].eye, glm::dvec3(4, 3, 0));
    EXPECT_NEAR(io::duration(path()), 1, 1e-9); // 8 m at 8 m/s
    EXPECT_EQ(names(), (std::vector<std::string>{"Add camera path", "Add key"}));
    rig.click("Remove path Path");
    EXPECT_TRUE(rig.document().scene().paths().empty());
    rig.key(editor::ctrl(Key::Z));
    EXPECT_EQ(path().keys.size(), 2u);
}

TEST_F(CameraPaths, AreRenamedButNotToWhatIsTaken)
{
    makeTwo();
    rig.click("Name of the path", "text");
    rig.type("Flight");
    rig.key({.key = Key::Enter});
    rig.frame(2);
    EXPECT_EQ(path().name, "Flight");
    EXPECT_EQ(rig.editor->viewport().path.path, "Flight");
    rig.click("Add path", "button"); // "Path", and in hand
    rig.frame(2);
    rig.click("Name of the path", "text");
    rig.type("Flight");
    rig.key({.key = Key::Enter});
    rig.frame(2);
    EXPECT_EQ(rig.document().scene().paths().back().name, "Path");
}

TEST_F(CameraPaths, AKeyIsDraggedInTheViewAsOneStep)
{
    makeTwo();
    const ImVec2 from = rig.at("2", "path_key");
    rig.drag(from, {from.x + 60, from.y});
    EXPECT_GT(path().keys[1].eye.x, 4.5);
    EXPECT_NEAR(path().keys[1].eye.y, 3, 1e-6); // level with the view's right
    EXPECT_EQ(path().keys[0].eye, glm::dvec3(-4, 3, 0));
    EXPECT_EQ(names().size(), 3u);
    EXPECT_EQ(names().back(), "Move key");
    rig.key(editor::ctrl(Key::Z));
    EXPECT_EQ(path().keys[1].eye, glm::dvec3(4, 3, 0));

    rig.move(from); // and Escape takes back what is being dragged
    rig.press();
    rig.move({from.x - 50, from.y - 20});
    EXPECT_NE(path().keys[1].eye, glm::dvec3(4, 3, 0));
    rig.key({.key = Key::Escape});
    EXPECT_EQ(path().keys[1].eye, glm::dvec3(4, 3, 0));
    rig.release();
    EXPECT_EQ(names().size(), 3u); // the undone one is still there to redo
}

TEST_F(CameraPaths, AreFlownAlongAndTheViewComesBack)
{
    makeTwo();
    const io::Camera before = rig.editor->viewport().camera.camera();
    rig.click("Fly along it", "button");
    rig.pass(0.4);
    const double x = rig.editor->viewport().camera.camera().eye.x;
    EXPECT_GT(x, -4.01);
    EXPECT_LT(x, 4.01);
    EXPECT_NEAR(rig.editor->viewport().camera.camera().eye.y, 3, 1e-6);
    for (int i = 0; i < 20; ++i)
        rig.pass(0.1);
    EXPECT_EQ(rig.editor->viewport().camera.camera().eye, before.eye);
    EXPECT_FALSE(rig.editor->viewport().path.flying());
    EXPECT_EQ(names().size(), 2u); // looking changes nothing
}

TEST_F(CameraPaths, LookAtWhatIsSelected)
{
    makeTwo();
    rig.editor->selection().set(std::vector<io::ObjectId>{io::ObjectId{2}});
    rig.frame(2);
    rig.click("Always at one place");
    rig.click("At what is selected", "button");
    EXPECT_TRUE(path().lookAt);
    EXPECT_NEAR(path().target.x, 4, 1e-6);
    const io::Camera middle = io::sample(path(), 0.5);
    EXPECT_NEAR(glm::dot(io::forward(middle), glm::normalize(path().target - middle.eye)), 1, 1e-9);
}

} // namespace
