#include "io/scene/scene.h"

#include <gtest/gtest.h>

namespace io {
namespace {

Object objectAt(double x)
{
    Object object;
    object.transform.position = {x, 0, 0};
    return object;
}

TEST(Scene, ExchangeGivesBackWhatItReplaced)
{
    Scene scene;
    EXPECT_EQ(scene.exchange(ObjectId{7}, objectAt(1)), std::nullopt);
    const std::optional<Object> before = scene.exchange(ObjectId{7}, objectAt(2));
    ASSERT_TRUE(before);
    EXPECT_EQ(before->transform.position.x, 1);
    EXPECT_EQ(scene.at(ObjectId{7}).transform.position.x, 2);
    EXPECT_EQ(scene.at(ObjectId{7}).id, ObjectId{7});
}

TEST(Scene, ExchangeWithItsAnswerIsTheInverse)
{
    Scene scene;
    for (std::uint32_t id = 1; id <= 5; ++id)
        scene.exchange(ObjectId{id}, objectAt(id));
    Scene before = scene;

    std::optional<Object> held = scene.exchange(ObjectId{2}, std::nullopt);
    EXPECT_EQ(scene.find(ObjectId{2}), nullptr);
    EXPECT_EQ(scene.objects().size(), 4u);
    EXPECT_FALSE(sameContent(scene, before));
    EXPECT_EQ(scene.exchange(ObjectId{2}, std::move(held)), std::nullopt);
    EXPECT_TRUE(sameContent(scene, before));
}

TEST(Scene, ObjectsStayDenseAndFindableWhenSomeGo)
{
    Scene scene;
    for (std::uint32_t id = 1; id <= 100; ++id)
        scene.exchange(ObjectId{id}, objectAt(id));
    for (std::uint32_t id = 1; id <= 100; id += 3)
        scene.exchange(ObjectId{id}, std::nullopt);
    EXPECT_EQ(scene.objects().size(), 66u);
    for (std::uint32_t id = 1; id <= 100; ++id) {
        const Object* object = scene.find(ObjectId{id});
        ASSERT_EQ(object == nullptr, id % 3 == 1);
        if (object) {
            EXPECT_EQ(object->transform.position.x, id);
        }
    }
}

TEST(Scene, IdsAreNeverUsedAgain)
{
    Scene scene;
    scene.exchange(ObjectId{41}, objectAt(0));
    EXPECT_EQ(scene.freshId(), ObjectId{42});
    scene.exchange(ObjectId{41}, std::nullopt);
    EXPECT_EQ(scene.freshId(), ObjectId{43});
}

TEST(Scene, SortedIdsRise)
{
    Scene scene;
    for (const std::uint32_t id : {9u, 3u, 12u, 1u})
        scene.exchange(ObjectId{id}, objectAt(0));
    EXPECT_EQ(scene.sortedIds(), (std::vector{ObjectId{1}, ObjectId{3}, ObjectId{9}, ObjectId{12}}));
}

TEST(Scene, TemplateSlotKeepsItsNameWhenItsTemplateGoes)
{
    Scene scene;
    const TemplateId oak = scene.templateSlot("oak");
    EXPECT_EQ(scene.templateSlot("oak"), oak);
    EXPECT_EQ(scene.find(oak), nullptr);
    scene.exchange(oak, Template{.name = "another", .category = "Trees"});
    EXPECT_EQ(scene.find(oak)->name, "oak");
    scene.exchange(oak, std::nullopt);
    EXPECT_EQ(scene.templateName(oak), "oak");
    EXPECT_EQ(scene.findTemplate("fir"), TemplateId::None);
}

TEST(Scene, SameContentComparesTemplatesByName)
{
    Scene a, b;
    b.templateSlot("spare");
    for (Scene* scene : {&a, &b}) {
        const TemplateId oak = scene->templateSlot("oak");
        scene->exchange(oak, Template{});
        Object object = objectAt(1);
        object.templateId = oak;
        scene->exchange(ObjectId{1}, object);
    }
    EXPECT_TRUE(sameContent(a, b));
    Template shadowless;
    shadowless.castShadow = false;
    b.exchange(b.findTemplate("oak"), shadowless);
    EXPECT_FALSE(sameContent(a, b));
}

TEST(SceneDeathTest, AnUnknownIdIsOurBug)
{
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    Scene scene;
    EXPECT_DEATH(scene.at(ObjectId{5}), "broken contract");
}

TEST(Extra, IsComparedByContentAndSharedByCopies)
{
    Extra a, b;
    a.add("x", "1");
    EXPECT_FALSE(a == b);
    b.add("x", "1");
    EXPECT_TRUE(a == b);
    Extra copy = a;
    copy.add("y", "2");
    EXPECT_EQ(a.keys().size(), 1u);
    EXPECT_EQ(copy.keys().size(), 2u);
}

} // namespace
} // namespace io
