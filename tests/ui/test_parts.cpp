// The parts beneath the panels: scalars of fields lists, rows of the tree, searching, numbers as text.
#include "editor/arrange.h"
#include "editor/numbers_text.h"
#include "editor/panels/tree_rows.h"
#include "editor/scalars.h"
#include "editor/search_text.h"
#include "editor/text.h"
#include "editor/typed_number.h"
#include "tests/ui/support/rig.h"

#include <gtest/gtest.h>

namespace {

using editor::Scalar;

TEST(Scalars, ReadInOrderAndWrittenByPlace)
{
    io::Transform transform{.position = {1, 2, 3}, .rotation = {4, 5, 6}, .scale = {7, 8, 9}};
    const std::vector<Scalar> all = editor::scalarsOf(transform);
    ASSERT_EQ(all.size(), 9u);
    EXPECT_EQ(all[4], Scalar{5.0});
    editor::applyChanges(transform,
                         {{.place = 1, .value = 20.0}, {.place = 8, .value = 0.0, .relative = true, .delta = 0.5}});
    EXPECT_EQ(transform.position, (glm::dvec3{1, 20, 3}));
    EXPECT_EQ(transform.scale, (glm::vec3{7, 8, 9.5f}));
}

TEST(Scalars, StayWithinTheirBounds)
{
    io::Environment environment;
    editor::applyChanges(environment, {{.place = 0, .value = 99.0}});
    EXPECT_EQ(environment.time, 24);
}

TEST(TreeRows, GroupsTemplatesAndSearch)
{
    const auto document = test::crates(4);
    const io::ObjectId pile = editor::group(*document, std::vector{io::ObjectId{1}, io::ObjectId{2}}, "Pile");
    editor::TreeRows rows;
    rows.follow(*document, document->takeChanges());
    rows.update(*document);
    ASSERT_EQ(rows.rows().size(), 2u); // the group, and the heading of the crates
    EXPECT_EQ(rows.rows()[0].id, pile);
    EXPECT_EQ(rows.rows()[1].count, 2u);

    rows.reveal(*document, io::ObjectId{2});
    rows.update(*document);
    EXPECT_EQ(rows.rows().size(), 4u);
    EXPECT_EQ(rows.find(io::ObjectId{2}), 2u);

    rows.setFilter("CRATE 1");
    rows.update(*document);
    ASSERT_EQ(rows.rows().size(), 2u); // the group around it, and it
    EXPECT_EQ(rows.rows()[1].id, io::ObjectId{1});
}

TEST(TreeRows, MovingMakesNothingNew)
{
    const auto document = test::crates(4);
    editor::TreeRows rows;
    rows.follow(*document, document->takeChanges());
    rows.setByTemplate(false);
    rows.update(*document);
    const editor::TreeRow* first = rows.rows().data();
    editor::edit(*document, "Move", std::vector{io::ObjectId{1}}, [](io::Object& o) { o.transform.position.x = 9; });
    rows.follow(*document, document->takeChanges());
    rows.update(*document);
    EXPECT_EQ(rows.rows().data(), first);
    editor::removeObjects(*document, "Delete", std::vector{io::ObjectId{1}});
    rows.follow(*document, document->takeChanges());
    rows.update(*document);
    EXPECT_EQ(rows.rows().size(), 3u);
}

TEST(TypedNumber, IsANumberOrAChange)
{
    EXPECT_EQ(editor::typedNumber(" 2.5 ")->of(9), 2.5);
    EXPECT_EQ(editor::typedNumber("-1,5")->of(9), -1.5);
    EXPECT_EQ(editor::typedNumber("10:30")->of(9), 10.5);
    EXPECT_EQ(editor::typedNumber("+=2")->of(9), 11);
    EXPECT_EQ(editor::typedNumber("-= 2")->of(9), 7);
    EXPECT_EQ(editor::typedNumber("*=2")->of(9), 18);
    EXPECT_EQ(editor::typedNumber("/=2")->of(9), 4.5);
    for (const char* text : {"", "nan", "inf", "1e999", "2x", "+=", "/=0", "1:75", "--2", "=", "\xc5\xa1"})
        EXPECT_FALSE(editor::typedNumber(text)) << text;
}

TEST(Search, AccentsAndCaseDoNotMatter)
{
    EXPECT_TRUE(editor::holds("Žlutý kůň", editor::lowerCase("KUN")));
    EXPECT_TRUE(editor::holds("anything", ""));
    EXPECT_FALSE(editor::holds("oak", "oaks"));
}

TEST(NumbersText, AreGrouped)
{
    io::Value texts;
    texts["unit"]["thousands"] = ",";
    texts["unit"]["megabytes"] = "MB";
    texts["unit"]["bytes"] = "B";
    editor::setTexts(texts);
    EXPECT_EQ(editor::grouped(7), "7");
    EXPECT_EQ(editor::grouped(1081274), "1,081,274");
    EXPECT_EQ(editor::byteText(12'400'000), "12.4 MB");
    EXPECT_EQ(editor::byteText(0), "0 B");
}

TEST(Search, EachWordIsSomewhere)
{
    EXPECT_TRUE(editor::holdsWords("Moon Phase moon.phase", "phase moon"));
    EXPECT_TRUE(editor::holdsWords("anything", " "));
    EXPECT_FALSE(editor::holdsWords("Moon Phase", "moon size"));
}

TEST(NumbersText, ShowWhatTheyAre)
{
    EXPECT_EQ(editor::numberShown(0.085, 2), "0.085");
    EXPECT_EQ(editor::numberShown(4, 1), "4.0");
    EXPECT_EQ(editor::numberShown(0.45, 3), "0.450");
    EXPECT_EQ(editor::numberShown(11000, 2, true), "11000");
    EXPECT_EQ(editor::numberShown(0.00023, 2, true), "0.00023");
    EXPECT_EQ(editor::numberShown(0, 2, true), "0");
    EXPECT_EQ(editor::clockShown(24), "24:00");
    EXPECT_EQ(editor::clockShown(6.0833), "6:05");
    EXPECT_EQ(editor::clockShown(-5.5), "-5:30");
}

} // namespace
