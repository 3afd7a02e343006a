#include "tests/unit/editor/worlds.h"

#include "editor/arrange.h"
#include "editor/placement.h"

#include <gtest/gtest.h>

using namespace editor;

namespace {

constexpr glm::dvec3 kUp{0, 1, 0};

// Where the ray from above meets the ground, as the cursor does.
PickHit groundAt(const Picker& picker, double x, double z)
{
    return picker.pick({.origin = {x, 1000, z}, .direction = {0, -1, 0}}, {.objects = false});
}

double angleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::degrees(std::acos(glm::clamp(glm::dot(a, b), -1.0, 1.0)));
}

} // namespace

TEST(Placement, StandsOnTheGroundWithinACentimetre)
{
    const auto document = test::forest(0, 1);
    Picker picker;
    test::followed(picker, *document);
    Random random{4};
    for (int i = 0; i < 200; ++i) {
        io::Template what = *document->scene().find(io::TemplateId(1 + i % 4));
        what.scale = {0.5f, 3.0f};
        what.yaw = {0, 360};
        what.sink = i % 2 ? 0.25f : 0.0f;
        const io::Box& bounds = document->assets().models[std::size_t(i % 4)]->bounds;
        const PickHit ground = groundAt(picker, random.in(-200, 200), random.in(-200, 200));
        ASSERT_TRUE(ground);
        const io::Transform placed = placedOn(what, bounds, ground.position, ground.normal, {.seed = random.bits()});
        const io::WorldBox box = io::transformed(bounds, io::worldFromModel(placed));
        EXPECT_NEAR(box.min.y, ground.position.y - what.sink, 0.01);
        EXPECT_GE(placed.scale.x, 0.5f);
        EXPECT_LE(placed.scale.x, 3.0f);
        EXPECT_EQ(placed.scale, glm::vec3{placed.scale.x});
        EXPECT_EQ(placed.rotation.x, 0);
    }
}

TEST(Placement, AlignedItsUpAxisIsTheNormalWithinADegree)
{
    const auto document = test::forest(0, 1);
    Picker picker;
    test::followed(picker, *document);
    Random random{4};
    io::Template what{.name = "rock", .alignToGround = true};
    const io::Box& bounds = document->assets().models[0]->bounds;
    for (int i = 0; i < 200; ++i) {
        const PickHit ground = groundAt(picker, random.in(-200, 200), random.in(-200, 200));
        const io::Transform placed = placedOn(what, bounds, ground.position, ground.normal, {.seed = random.bits()});
        const glm::dvec3 up = io::orientation(placed.rotation) * kUp;
        EXPECT_LT(angleBetween(up, ground.normal), 0.01);
        const glm::dvec3 foot = placed.position + up * double(bounds.min.y * placed.scale.y);
        EXPECT_LT(glm::distance(foot, ground.position), 0.01);
    }
    for (const glm::dvec3 normal : {glm::dvec3{0, -1, 0}, {1, 0, 0}, {0, 0, -1}}) {
        const io::Transform placed = placedOn(what, bounds, {}, normal, {.yaw = 30.0f});
        EXPECT_LT(angleBetween(io::orientation(placed.rotation) * kUp, normal), 0.01);
    }
}

TEST(Placement, TheSeedDecidesAndAGivenYawIsKeptAsTyped)
{
    const io::Template what{.name = "oak", .yaw = {0, 360}, .scale = {0.8f, 1.2f}, .tilt = 5};
    const io::Box bounds{{-1, 0, -1}, {1, 4, 1}};
    const auto with = [&](std::uint64_t seed) { return placedOn(what, bounds, {}, kUp, {.seed = seed}); };
    EXPECT_EQ(with(5), with(5));
    EXPECT_NE(with(5), with(6));
    for (std::uint64_t seed = 0; seed < 100; ++seed)
        EXPECT_LE(angleBetween(io::orientation(with(seed).rotation) * kUp, kUp), 5.001);
    const io::Template plain{.name = "hut"};
    EXPECT_EQ(placedOn(plain, bounds, {}, kUp, {.yaw = 30.0f, .scale = 2.0f}),
              (io::Transform{.rotation = {0, 30, 0}, .scale = glm::vec3{2}}));
}

TEST(Placement, DroppedThingsStandOnTheGroundOrOnWhatIsBelow)
{
    const auto document = test::forest(0, 1);
    const auto add = [&](glm::dvec3 at, float yaw) {
        const io::ObjectId id = document->freshId();
        addObjects(
            *document, "Add",
            {{.id = id, .templateId = io::TemplateId{4}, .transform = {.position = at, .rotation = {0, yaw, 0}}}});
        return id;
    };
    const std::vector ids{add({10, 70, 10}, 30), add({-40, -60, 20}, 0), add({10, 90, 10.2}, 45),
                          add({5000, 80, 0}, 0)};
    Picker picker;
    test::followed(picker, *document);
    const auto dropped = dropToGround(*document, picker, std::vector{ids[0], ids[1], ids[3]});
    EXPECT_EQ(dropped, (std::vector{ids[0], ids[1]})); // there is no ground under the last
    for (const io::ObjectId id : dropped) {
        const io::Transform& t = document->scene().at(id).transform;
        EXPECT_NEAR(t.position.y, *document->scene().heights()->height(t.position.x, t.position.z), 0.01);
    }
    EXPECT_EQ(document->scene().at(ids[0]).transform.rotation, (glm::vec3{0, 30, 0}));
    EXPECT_EQ(document->scene().at(ids[0]).transform.position.x, 10);

    test::followed(picker, *document);
    dropToGround(*document, picker, std::vector{ids[2]}); // onto the first one
    EXPECT_NEAR(document->scene().at(ids[2]).transform.position.y,
                document->scene().at(ids[0]).transform.position.y + 2, 0.01);
    document->undo();
    document->undo();
    EXPECT_EQ(document->scene().at(ids[1]).transform.position, (glm::dvec3{-40, -60, 20}));
}

TEST(Placement, DroppedAndAlignedItStandsUprightOnTheSlope)
{
    const auto document = test::forest(0, 1);
    const io::ObjectId id = document->freshId();
    addObjects(
        *document, "Add",
        {{.id = id, .templateId = io::TemplateId{4}, .transform = {.position = {31, 50, 17}, .rotation = {0, 70, 0}}}});
    Picker picker;
    test::followed(picker, *document);
    dropToGround(*document, picker, std::vector{id}, DropTurn::Align);
    const io::Transform& t = document->scene().at(id).transform;
    const PickHit ground = groundAt(picker, 31, 17);
    EXPECT_LT(angleBetween(io::orientation(t.rotation) * kUp, ground.normal), 1);
    EXPECT_LT(glm::distance(t.position, ground.position), 0.01);
}

TEST(Placement, AGroupDropsAsOnePiece)
{
    const auto document = test::forest(0, 1);
    std::vector<io::ObjectId> ids;
    for (int i = 0; i < 3; ++i) {
        ids.push_back(document->freshId());
        addObjects(
            *document, "Add",
            {{.id = ids.back(), .templateId = io::TemplateId{4}, .transform = {.position = {i * 3.0, 60.0 + i, 0}}}});
    }
    const io::ObjectId holder = group(*document, ids);
    Picker picker;
    test::followed(picker, *document);
    dropToGround(*document, picker, std::vector{holder});
    for (int i = 1; i < 3; ++i)
        EXPECT_NEAR(document->scene().at(ids[std::size_t(i)]).transform.position.y -
                        document->scene().at(ids[0]).transform.position.y,
                    i, 1e-9);
    EXPECT_NEAR(boundsOf(*document, ids).min.y, *document->scene().heights()->height(3, 0), 0.01);
}

TEST(Placement, LinesUpAlongAnAxis)
{
    const auto document = test::forest(20, 1);
    const auto ids = document->scene().sortedIds();
    const io::WorldBox before = boundsOf(*document, ids);
    alignAlong(*document, ids, 0, AlignTo::Min);
    for (const io::ObjectId id : ids)
        EXPECT_NEAR(boundsOf(*document, std::vector{id}).min.x, before.min.x, 1e-6);
    alignAlong(*document, ids, 2, AlignTo::Primary);
    for (const io::ObjectId id : ids)
        EXPECT_DOUBLE_EQ(document->scene().at(id).transform.position.z,
                         document->scene().at(ids.back()).transform.position.z);
}
