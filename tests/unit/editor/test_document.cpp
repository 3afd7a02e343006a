#include "tests/unit/editor/worlds.h"

#include "editor/arrange.h"
#include "editor/document.h"
#include "io/files/documents.h"

#include <ctime>
#include <gtest/gtest.h>

using namespace editor;

namespace {

io::ObjectId anyObject(const Document& document, Random& random)
{
    const auto objects = document.scene().objects();
    return objects[std::size_t(random.unit() * double(objects.size()))].id;
}

// One random edit of any kind.
void editSomething(Document& document, Random& random)
{
    const io::ObjectId id = anyObject(document, random);
    const io::ObjectId other = anyObject(document, random);
    const io::ObjectId two[] = {id, other};
    switch (random.bits() % 10) {
    case 0:
        return moveBy(document, "Move", {&id, 1}, {random.in(-5, 5), 0, 1});
    case 1:
        return removeObjects(document, "Delete", {&id, 1});
    case 2:
        duplicate(document, two, {1, 2, 3});
        return;
    case 3:
        return edit(document, "Rename", {&id, 1}, [&](io::Object& o) { o.name = std::to_string(random.bits()); });
    case 4:
        group(document, two, "pair");
        return;
    case 5:
        ungroup(document, two);
        return;
    case 6: {
        io::Environment environment = document.scene().environment();
        environment.time = float(random.in(0, 24));
        return setEnvironment(document, "Time", environment);
    }
    case 7: {
        std::vector<io::Camera> cameras(document.scene().cameras().begin(), document.scene().cameras().end());
        cameras.push_back({.name = "camera " + std::to_string(random.bits())});
        return setCameras(document, "Add camera", cameras);
    }
    case 8: {
        io::Template changed = *document.scene().find(io::TemplateId{2});
        changed.sink = float(random.in(0, 2));
        return setTemplate(document, "Sink", io::TemplateId{2}, changed);
    }
    default:
        reparent(document, {&id, 1}, io::ObjectId::None);
        return edit(document, "Turn", {&id, 1}, [&](io::Object& o) { o.transform.rotation.y += 10; });
    }
}

std::string everything(const io::Scene& scene)
{
    std::string all = test::text(scene) + io::environmentText(scene.environment());
    for (const io::Scene::TemplateSlot& slot : scene.templates())
        if (slot.value) all += io::templateText(*slot.value);
    for (const io::Camera& camera : scene.cameras())
        all += camera.name;
    return all;
}

} // namespace

TEST(Document, UndoneEditsLeaveTheSameBytesAndRedoneOnesToo)
{
    const auto document = test::forest(200, 7);
    Random random{42};
    const io::Scene start = document->scene();
    const std::string startText = everything(start);
    for (int i = 0; i < 400; ++i)
        editSomething(*document, random);
    const io::Scene end = document->scene();
    const std::string endText = everything(end);
    ASSERT_NE(startText, endText);
    const std::size_t steps = document->history().position();
    EXPECT_GT(steps, 200u);

    document->goTo(0);
    EXPECT_TRUE(io::sameContent(document->scene(), start));
    EXPECT_EQ(everything(document->scene()), startText);
    EXPECT_FALSE(document->modified());
    document->goTo(steps);
    EXPECT_TRUE(io::sameContent(document->scene(), end));
    EXPECT_EQ(everything(document->scene()), endText);
    EXPECT_TRUE(document->modified());
}

TEST(Document, AGestureIsOneStepWithTheFirstAndTheLastValue)
{
    const auto document = test::forest(10, 1);
    const std::string before = test::text(document->scene());
    const io::ObjectId ids[] = {io::ObjectId{3}, io::ObjectId{4}};
    document->beginGesture("Drag");
    for (int frame = 0; frame < 50; ++frame) {
        moveBy(*document, "Move", {ids, frame < 25 ? 1u : 2u}, {0.1, 0, 0});
        io::Environment environment = document->scene().environment();
        environment.time = float(frame) * 0.1f;
        setEnvironment(*document, "Time", environment);
        EXPECT_TRUE(document->modified());
    }
    document->endGesture();
    EXPECT_EQ(document->history().names(), std::vector<std::string>{"Drag"});
    EXPECT_LT(document->history().bytes(), 4000u);
    const std::string after = test::text(document->scene());

    EXPECT_EQ(document->undo(), "Drag");
    EXPECT_EQ(test::text(document->scene()), before);
    EXPECT_EQ(document->redo(), "Drag");
    EXPECT_EQ(test::text(document->scene()), after);
    EXPECT_FLOAT_EQ(document->scene().environment().time, 4.9f);
}

TEST(Document, AGestureThatEndsWhereItBeganIsNoStep)
{
    const auto document = test::forest(10, 1);
    const io::ObjectId id{3};
    {
        const Gesture gesture{*document, "Drag"};
        moveBy(*document, "Move", {&id, 1}, {1, 0, 0});
        moveBy(*document, "Move", {&id, 1}, {-1, 0, 0});
    }
    EXPECT_FALSE(document->history().canUndo());
    EXPECT_FALSE(document->modified());
}

TEST(Document, ACancelledGestureLeavesTheWorldAsItWas)
{
    const auto document = test::forest(10, 1);
    const std::string before = test::text(document->scene());
    Gesture gesture{*document, "Drag"};
    for (int i = 0; i < 5; ++i)
        duplicate(*document, std::vector{io::ObjectId{1}}, {1, 0, 0});
    removeObjects(*document, "Delete", std::vector{io::ObjectId{1}});
    gesture.cancel();
    EXPECT_EQ(test::text(document->scene()), before);
    EXPECT_FALSE(document->history().canUndo());
}

TEST(Document, UndoInsideAGestureEndsItFirst)
{
    const auto document = test::forest(10, 1);
    const std::string before = test::text(document->scene());
    document->beginGesture("Drag");
    moveBy(*document, "Move", std::vector{io::ObjectId{1}}, {1, 0, 0});
    EXPECT_EQ(document->undo(), "Drag");
    document->endGesture();
    EXPECT_EQ(test::text(document->scene()), before);
}

TEST(Document, TheBudgetDropsTheOldestAndSaysSo)
{
    const auto document = test::forest(100, 1);
    const auto ids = document->scene().sortedIds();
    document->setUndoBudget(100'000);
    for (int i = 0; i < 50; ++i)
        moveBy(*document, "Move " + std::to_string(i), ids, {1, 0, 0});
    EXPECT_LE(document->history().bytes(), 100'000u);
    EXPECT_GT(document->history().dropped(), 0u);
    EXPECT_EQ(document->history().names().size() + document->history().dropped(), 50u);
    EXPECT_EQ(document->history().names().back(), "Move 49");
    while (document->history().canUndo())
        document->undo();
    EXPECT_TRUE(document->modified()); // the saved state can no longer be reached
}

TEST(Document, WhatChangesNothingIsNoStep)
{
    const auto document = test::forest(10, 1);
    moveBy(*document, "Move", std::vector{io::ObjectId{1}}, {0, 0, 0});
    setEnvironment(*document, "Same", document->scene().environment());
    removeObjects(*document, "Delete", std::vector{io::ObjectId{4711}});
    EXPECT_FALSE(document->history().canUndo());
}

TEST(Document, ANewEditForgetsWhatCouldBeRedone)
{
    const auto document = test::forest(10, 1);
    const std::vector one{io::ObjectId{1}};
    moveBy(*document, "A", one, {1, 0, 0});
    moveBy(*document, "B", one, {1, 0, 0});
    document->undo();
    moveBy(*document, "C", one, {0, 1, 0});
    EXPECT_EQ(document->history().names(), (std::vector<std::string>{"A", "C"}));
    EXPECT_FALSE(document->history().canRedo());
}

TEST(Document, ChangesNameEachThingOnceAndOnlyWhatChanged)
{
    const auto document = test::forest(10, 1);
    EXPECT_TRUE(document->takeChanges().everything);
    EXPECT_TRUE(document->takeChanges().none());
    const std::uint64_t revision = document->revision();
    for (int i = 0; i < 5; ++i)
        moveBy(*document, "Move", std::vector{io::ObjectId{3}}, {1, 0, 0});
    const io::Changes changes = document->takeChanges();
    EXPECT_EQ(changes.objects, std::vector{io::ObjectId{3}});
    EXPECT_FALSE(changes.environment || changes.cameras || changes.terrain || changes.everything);
    EXPECT_GT(document->revision(), revision);
}

// 20,000 edits and undos that each walked over the world would take minutes.
TEST(Document, AnEditCostsWhatItChangesNotWhatThereIs)
{
    const auto document = test::forest(200'000, 1, false);
    document->takeChanges();
    const std::clock_t begun = std::clock(); // of this process alone, however busy the machine is
    for (int i = 0; i < 10'000; ++i)
        moveBy(*document, "Move", std::vector{io::ObjectId(1 + std::uint32_t(i))}, {1, 0, 0});
    for (int i = 0; i < 10'000; ++i)
        document->undo();
    EXPECT_LT(double(std::clock() - begun) / CLOCKS_PER_SEC, 5);
    EXPECT_EQ(document->takeChanges().objects.size(), 10'000u);
    EXPECT_LT(document->history().bytes() / 10'000, 1000u);
}
