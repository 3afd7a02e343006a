#include "tests/unit/editor/worlds.h"

#include "editor/arrange.h"
#include "editor/selection.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace editor;

namespace {

std::vector<io::ObjectId> ids(std::initializer_list<std::uint32_t> numbers)
{
    std::vector<io::ObjectId> result;
    for (const std::uint32_t number : numbers)
        result.push_back(io::ObjectId{number});
    return result;
}
std::vector<io::ObjectId> ids(const Selection& selection)
{
    return {selection.ids().begin(), selection.ids().end()};
}

} // namespace

TEST(Selection, KeepsTheOrderAndTheLastIsThePrimary)
{
    Selection selection;
    selection.set(ids({3, 1, 2}));
    EXPECT_EQ(selection.primary(), io::ObjectId{2});
    selection.apply(SelectMode::Add, ids({5, 3}));
    EXPECT_EQ(ids(selection), ids({1, 2, 5, 3}));
    selection.toggle(io::ObjectId{2});
    selection.toggle(io::ObjectId{9});
    EXPECT_EQ(ids(selection), ids({1, 5, 3, 9}));
    selection.apply(SelectMode::Remove, ids({5, 77}));
    EXPECT_EQ(ids(selection), ids({1, 3, 9}));
    selection.apply(SelectMode::Add, selection.ids());
    EXPECT_EQ(ids(selection), ids({1, 3, 9}));
    selection.set(ids({4, 4, 0}));
    EXPECT_EQ(ids(selection), ids({4}));
}

TEST(Selection, TellsWhenItChanged)
{
    Selection selection;
    selection.set(ids({1}));
    const std::uint64_t revision = selection.revision();
    selection.set(ids({1}));
    EXPECT_EQ(selection.revision(), revision);
    selection.clear();
    EXPECT_GT(selection.revision(), revision);
}

TEST(Selection, DropsWhatIsGone)
{
    const auto document = test::forest(10, 1);
    Selection selection;
    selection.set(ids({1, 2, 3}));
    document->takeChanges();
    removeObjects(*document, "Delete", ids({2}));
    selection.follow(document->scene(), document->takeChanges());
    EXPECT_EQ(ids(selection), ids({1, 3}));
    removeObjects(*document, "Delete", ids({1, 3}));
    selection.follow(document->scene(), {.everything = true});
    EXPECT_TRUE(selection.empty());
}

TEST(Selection, AClickOnAMemberMeansTheOutermostGroup)
{
    const auto document = test::forest(10, 1);
    const io::ObjectId inner = group(*document, ids({1, 2}));
    const io::ObjectId outer = group(*document, std::vector{inner, io::ObjectId{3}});
    EXPECT_EQ(wholeGroups(document->hierarchy(), ids({1, 3, 4})), (std::vector{outer, io::ObjectId{4}}));
    EXPECT_EQ(document->hierarchy().withMembers(std::vector{outer}).size(), 5u);
    EXPECT_EQ(document->hierarchy().outermost(std::vector{io::ObjectId{1}, outer, io::ObjectId{4}}),
              (std::vector{outer, io::ObjectId{4}}));
    document->undo();
    document->undo();
    EXPECT_EQ(wholeGroups(document->hierarchy(), ids({1})), ids({1}));
    EXPECT_FALSE(document->hierarchy().holdsAny(outer));
}

TEST(Selection, AllInvertedAndTheSameTemplate)
{
    const auto document = test::forest(40, 1);
    const io::ObjectId holder = group(*document, ids({1, 2}));
    const auto all = allObjects(document->scene(), document->hierarchy());
    EXPECT_EQ(all.size(), 39u);
    Selection selection;
    selection.set(ids({5, 6}));
    EXPECT_EQ(inverted(document->scene(), document->hierarchy(), selection).size(), 37u);
    selection.set(ids({1})); // a member: its group counts as selected
    for (const io::ObjectId id : inverted(document->scene(), document->hierarchy(), selection))
        EXPECT_NE(id, holder);

    const io::TemplateId what = document->scene().at(io::ObjectId{5}).templateId;
    const auto same = sameTemplate(document->scene(), ids({5}));
    for (const io::Object& object : document->scene().objects())
        EXPECT_EQ(object.templateId == what, std::ranges::binary_search(same, object.id));
}

TEST(Hierarchy, ARingOfGroupsIsNoTrap)
{
    io::Scene scene;
    for (std::uint32_t id = 1; id <= 3; ++id) // 1 in 2 in 3 in 1
        scene.exchange(io::ObjectId{id}, io::Object{.parent = io::ObjectId{id % 3 + 1}});
    Hierarchy hierarchy;
    hierarchy.update(scene, {.everything = true});
    const auto all = ids({1, 2, 3});
    EXPECT_EQ(hierarchy.outermost(all).size(), 1u);
    EXPECT_EQ(hierarchy.withMembers(hierarchy.outermost(all)).size(), 3u);
    EXPECT_EQ(hierarchy.topmost(io::ObjectId{1}), hierarchy.topmost(io::ObjectId{2}));
}

TEST(Hierarchy, GroupsMayChangePlacesInOneStep)
{
    const auto document = test::forest(4, 1);
    const io::ObjectId inner = group(*document, ids({1}));
    const io::ObjectId outer = group(*document, std::vector{inner});
    std::vector<SwapObjects::Slot> slots;
    for (const auto& [id, parent] : {std::pair{inner, io::ObjectId::None}, std::pair{outer, inner}}) {
        io::Object object = document->scene().at(id);
        object.parent = parent;
        slots.emplace_back(id, object);
    }
    std::ranges::reverse(slots);
    document->run(std::make_unique<SwapObjects>("Swap", std::move(slots)));
    EXPECT_EQ(document->hierarchy().topmost(outer), inner);
    document->undo();
    EXPECT_EQ(document->hierarchy().topmost(inner), outer);
    EXPECT_EQ(document->hierarchy().topmost(io::ObjectId{1}), outer);
}
