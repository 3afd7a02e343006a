#include "tests/unit/editor/worlds.h"

#include "editor/arrange.h"
#include "editor/placement.h"

#include <gtest/gtest.h>
#include <numbers>

using namespace editor;

TEST(Arrange, DuplicatesKeepTheirGroupsAndAreOneStep)
{
    const auto document = test::forest(10, 1);
    const std::string before = test::text(document->scene());
    const io::ObjectId holder = group(*document, std::vector{io::ObjectId{1}, io::ObjectId{2}}, "pair");
    const auto copies = duplicate(*document, std::vector{holder, io::ObjectId{1}, io::ObjectId{5}}, {10, 0, 0});
    ASSERT_EQ(copies.size(), 2u);
    EXPECT_EQ(document->scene().at(copies[0]).name, "pair");
    const auto members = document->hierarchy().children(copies[0]);
    ASSERT_EQ(members.size(), 2u);
    EXPECT_EQ(document->scene().at(members[0]).transform.position,
              document->scene().at(io::ObjectId{1}).transform.position + (glm::dvec3{10, 0, 0}));
    EXPECT_EQ(document->scene().objects().size(), 15u);
    document->undo();
    document->undo();
    EXPECT_EQ(test::text(document->scene()), before);
}

TEST(Arrange, CopiedTextComesBackAsTheSameThings)
{
    const auto document = test::forest(10, 1);
    edit(*document, "Rename", std::vector{io::ObjectId{2}}, [](io::Object& o) { o.name = "st\"range\n \xC4\x8D"; });
    const io::ObjectId holder = group(*document, std::vector{io::ObjectId{1}, io::ObjectId{2}});
    const std::vector ids{holder, io::ObjectId{7}};
    const std::string text = copyAsText(*document, ids);
    EXPECT_TRUE(holdsObjects(text));

    const glm::dvec3 at{100, 5, -30};
    const auto pasted = paste(*document, text, at);
    ASSERT_TRUE(pasted) << pasted.error().text();
    ASSERT_EQ(pasted->size(), 2u);
    const auto before = document->hierarchy().withMembers(ids), after = document->hierarchy().withMembers(*pasted);
    ASSERT_EQ(before.size(), after.size());
    const glm::dvec3 delta =
        document->scene().at(after[0]).transform.position - document->scene().at(before[0]).transform.position;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const io::Object &a = document->scene().at(before[i]), &b = document->scene().at(after[i]);
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.templateId, b.templateId);
        EXPECT_EQ(a.transform.rotation, b.transform.rotation);
        EXPECT_EQ(a.transform.scale, b.transform.scale);
        EXPECT_LT(glm::distance(b.transform.position - a.transform.position, delta), 1e-9);
    }
    const io::WorldBox box = boundsOf(*document, *pasted);
    EXPECT_NEAR(box.min.y, at.y, 1e-6);
    EXPECT_NEAR(box.centre().x, at.x, 1e-6);
    document->undo();
    EXPECT_EQ(document->scene().objects().size(), 11u);
}

TEST(Arrange, TextThatIsNoCopyIsRefusedAndChangesNothing)
{
    const auto document = test::forest(3, 1);
    const std::string before = test::text(document->scene());
    const std::string good = copyAsText(*document, std::vector{io::ObjectId{1}});
    std::string unknownTemplate = good;
    unknownTemplate.replace(unknownTemplate.find("\"template\":\"") + 12, 2, "Zz");
    for (const std::string& text :
         {std::string{}, std::string{"hello"}, std::string{"{\"wold_objects\":1}\n"},
          std::string{"{\"wold_objects\":99}\n{}\n"}, std::string{"{\"wold_objects\":1}\n{]\n"},
          std::string{"{\"wold_objects\":1}\n[1,2]\n"}, unknownTemplate, good.substr(0, good.size() - 5),
          good + "{\"template\":\"blob\",\"scale\":[1,2]}\n"}) {
        const auto pasted = paste(*document, text, {});
        EXPECT_FALSE(pasted) << text;
    }
    EXPECT_EQ(test::text(document->scene()), before);
    EXPECT_FALSE(document->history().canUndo());
}

TEST(Arrange, GroupsDissolveAndNestAndNeverHoldThemselves)
{
    const auto document = test::forest(6, 1);
    const std::vector pair{io::ObjectId{1}, io::ObjectId{2}};
    const io::ObjectId inner = group(*document, pair);
    const io::ObjectId outer = group(*document, std::vector{inner, io::ObjectId{3}});
    EXPECT_EQ(document->scene().at(inner).parent, outer);
    EXPECT_FALSE(reparent(*document, std::vector{outer}, inner));
    EXPECT_FALSE(reparent(*document, std::vector{outer}, outer));
    EXPECT_FALSE(reparent(*document, std::vector{io::ObjectId{4}}, io::ObjectId{5})); // no group
    EXPECT_TRUE(reparent(*document, std::vector{io::ObjectId{4}}, inner));
    EXPECT_EQ(document->hierarchy().children(inner).size(), 3u);
    EXPECT_EQ(ungroup(*document, std::vector{inner}).size(), 3u);
    EXPECT_EQ(document->scene().at(io::ObjectId{1}).parent, outer);
    EXPECT_EQ(document->scene().find(inner), nullptr);
    removeObjects(*document, "Delete", std::vector{outer});
    EXPECT_EQ(document->scene().objects().size(), 2u);
    EXPECT_EQ(group(*document, {}), io::ObjectId::None);
}

TEST(Arrange, AMovedGroupTakesItsMembersAlong)
{
    const auto document = test::forest(3, 1);
    const io::ObjectId holder = group(*document, std::vector{io::ObjectId{1}, io::ObjectId{2}});
    const glm::dvec3 before = document->scene().at(io::ObjectId{2}).transform.position;
    moveBy(*document, "Move", std::vector{holder, io::ObjectId{2}}, {0, 0, 4});
    EXPECT_EQ(document->scene().at(io::ObjectId{2}).transform.position, before + (glm::dvec3{0, 0, 4}));
}
