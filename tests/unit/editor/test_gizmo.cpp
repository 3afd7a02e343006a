#include "tests/unit/editor/worlds.h"

#include "editor/gizmo.h"

#include <gtest/gtest.h>
#include <set>

using namespace editor;

namespace {

const View kView{.camera = {.eye = {6, 7, 12}, .yaw = 25, .pitch = -25}, .size = {1280, 720}};

std::vector<io::Transform> some()
{
    return {{.position = {1, 2, 3}, .rotation = {10, 20, 30}},
            {.position = {-2, 0.5, 1}, .scale = {1, 2, -3}},
            {.position = {0.25, 1, -1}, .rotation = {0, 45, 0}, .scale = glm::vec3{0.5f}}};
}

glm::dvec2 pixelOf(const View& view, const glm::dvec3& world)
{
    return project(view, world).value_or(glm::dvec2{0});
}

bool sound(const std::vector<io::Transform>& transforms)
{
    for (const io::Transform& t : transforms)
        for (int axis = 0; axis < 3; ++axis)
            if (!std::isfinite(t.position[axis]) || !std::isfinite(t.rotation[axis]) || !std::isfinite(t.scale[axis]) ||
                t.scale[axis] == 0)
                return false;
    return true;
}

// Metres of a handle at the pivot.
double handleLength(const View& view, const glm::dvec3& pivot)
{
    const double depth = glm::dot(pivot - view.camera.eye, io::forward(view.camera));
    return Gizmo::kLength * 2 * depth * std::tan(glm::radians(view.camera.fov / 2.0)) / view.size.y;
}

} // namespace

TEST(Gizmo, ThreeGridStepsAlongXMoveEveryObjectExactlyThree)
{
    Gizmo gizmo;
    const auto start = some();
    const GizmoFrame frame = *gizmo.frame(start);
    const double length = handleLength(kView, frame.pivot);
    const glm::dvec3 held = frame.pivot + glm::dvec3{length, 0, 0};
    ASSERT_EQ(gizmo.hit(kView, frame, pixelOf(kView, held)), GizmoHandle::X);
    ASSERT_TRUE(gizmo.begin(kView, GizmoHandle::X, pixelOf(kView, held), start));
    std::vector<io::Transform> moved;
    for (const double x : {0.4, 1.2, 2.2, 3.4, 2.7, 3.2})
        moved = gizmo.update(kView, pixelOf(kView, held + glm::dvec3{x, 0, 0}), true);
    gizmo.end();
    for (std::size_t i = 0; i < start.size(); ++i) {
        EXPECT_EQ(moved[i].position, start[i].position + (glm::dvec3{3, 0, 0}));
        EXPECT_EQ(moved[i].rotation, start[i].rotation);
        EXPECT_EQ(moved[i].scale, start[i].scale);
    }
}

TEST(Gizmo, WhatIsGrabbedStaysUnderTheCursor)
{
    Gizmo gizmo;
    const auto start = some();
    const GizmoFrame frame = *gizmo.frame(start);
    const double length = handleLength(kView, frame.pivot);
    const auto follows = [&](GizmoHandle handle, glm::dvec3 from, glm::dvec3 to) {
        ASSERT_TRUE(gizmo.begin(kView, handle, pixelOf(kView, frame.pivot + from), start));
        const auto moved = gizmo.update(kView, pixelOf(kView, frame.pivot + to), false);
        for (std::size_t i = 0; i < start.size(); ++i)
            EXPECT_LT(glm::distance(moved[i].position - start[i].position, to - from), 1e-6);
        EXPECT_LT(glm::distance(gizmo.activeFrame().pivot - frame.pivot, to - from), 1e-6);
        gizmo.end();
    };
    follows(GizmoHandle::X, {length, 0, 0}, {length + 2.5, 0, 0});
    follows(GizmoHandle::Y, {0, length, 0}, {0, length - 1.5, 0});
    follows(GizmoHandle::Z, {0, 0, length}, {0, 0, length - 3.25});
    follows(GizmoHandle::ZX, {0.4 * length, 0, 0.4 * length}, {2, 0, -1});
    follows(GizmoHandle::XY, {0.4 * length, 0.4 * length, 0}, {-1, 2, 0});
    follows(GizmoHandle::Centre, {0, 0, 0}, {0, 0, 0});
}

TEST(Gizmo, LocalAxesAreThoseOfThePrimary)
{
    Gizmo gizmo;
    gizmo.space = GizmoSpace::Local;
    gizmo.pivot = GizmoPivot::Primary;
    const auto start = some();
    const GizmoFrame frame = *gizmo.frame(start);
    EXPECT_EQ(frame.pivot, start.back().position);
    const glm::dvec3 along = io::orientation(start.back().rotation) * glm::dvec3{1, 0, 0};
    const double length = handleLength(kView, frame.pivot);
    ASSERT_TRUE(gizmo.begin(kView, GizmoHandle::X, pixelOf(kView, frame.pivot + along * length), start));
    const auto moved = gizmo.update(kView, pixelOf(kView, frame.pivot + along * (length + 2)), true);
    for (std::size_t i = 0; i < start.size(); ++i)
        EXPECT_LT(glm::distance(moved[i].position - start[i].position, along * 2.0), 1e-9);
}

TEST(Gizmo, TheHandlesKeepTheirSizeOnTheScreen)
{
    Gizmo gizmo;
    for (const double distance : {0.5, 5.0, 500.0, 50'000.0}) {
        View view = kView;
        const GizmoFrame frame{.pivot = {3, 4, 5}};
        view.camera.eye = frame.pivot - io::forward(view.camera) * distance;
        double longest = 0;
        for (const GizmoShape& shape : gizmo.shapes(view, frame))
            for (const glm::dvec2 point : shape.points)
                longest = std::max(longest, glm::distance(point, pixelOf(view, frame.pivot)));
        EXPECT_NEAR(longest, Gizmo::kLength + 10, 25);
    }
    View behind = kView;
    behind.camera.yaw += 180;
    EXPECT_TRUE(gizmo.shapes(behind, {}).empty());
    EXPECT_EQ(gizmo.hit(behind, {}, {640, 360}), GizmoHandle::None);
}

TEST(Gizmo, EachHandleIsHitWhereItIsDrawn)
{
    for (const GizmoMode mode : {GizmoMode::Translate, GizmoMode::Rotate, GizmoMode::Scale}) {
        Gizmo gizmo;
        gizmo.mode = mode;
        const GizmoFrame frame{.pivot = {0, 1, 0}};
        std::set<GizmoHandle> hit;
        for (const GizmoShape& shape : gizmo.shapes(kView, frame)) {
            glm::dvec2 middle{0};
            for (const glm::dvec2 point : shape.points)
                middle += point / double(shape.points.size());
            hit.insert(gizmo.hit(kView, frame, shape.filled ? middle : shape.points[shape.points.size() / 3]));
        }
        EXPECT_EQ(hit.size(), mode == GizmoMode::Rotate ? 4u : 7u);
        EXPECT_EQ(gizmo.hit(kView, frame, {5, 5}), GizmoHandle::None);
    }
}

TEST(Gizmo, ARingTurnsAboutItsAxisAndThePivot)
{
    Gizmo gizmo;
    gizmo.mode = GizmoMode::Rotate;
    const auto start = some();
    const GizmoFrame frame = *gizmo.frame(start);
    const double r = handleLength(kView, frame.pivot);
    const auto onRing = [&](double degrees) {
        const double a = glm::radians(degrees);
        return pixelOf(kView, frame.pivot + r * glm::dvec3{std::sin(a), 0, std::cos(a)});
    };
    ASSERT_TRUE(gizmo.begin(kView, GizmoHandle::Y, onRing(0), start));
    std::vector<io::Transform> turned;
    for (int degrees = 5; degrees <= 62; degrees += 3)
        turned = gizmo.update(kView, onRing(degrees), false);
    EXPECT_NEAR(gizmo.amount().x, 62, 0.01);
    turned = gizmo.update(kView, onRing(63), true);
    EXPECT_DOUBLE_EQ(gizmo.amount().x, 60);
    const glm::dquat turn = glm::angleAxis(glm::radians(60.0), glm::dvec3{0, 1, 0});
    for (std::size_t i = 0; i < start.size(); ++i) {
        EXPECT_LT(glm::distance(turned[i].position, frame.pivot + turn * (start[i].position - frame.pivot)), 1e-9);
        const glm::dvec3 before = io::orientation(start[i].rotation) * glm::dvec3{1, 2, 3};
        EXPECT_LT(glm::distance(io::orientation(turned[i].rotation) * glm::dvec3{1, 2, 3}, turn * before), 1e-4);
    }
    for (int degrees = 63; degrees <= 800; degrees += 5)
        turned = gizmo.update(kView, onRing(degrees), false);
    EXPECT_NEAR(gizmo.amount().x, 798, 1); // past full turns
}

TEST(Gizmo, ScalingGrowsByTheWayAlongTheHandle)
{
    Gizmo gizmo;
    gizmo.mode = GizmoMode::Scale;
    const std::vector<io::Transform> one{{.position = {0, 1, 0}, .rotation = {0, 30, 0}, .scale = {1, -2, 3}}};
    const GizmoFrame frame = *gizmo.frame(one);
    const double length = handleLength(kView, frame.pivot);
    const glm::dvec3 along = frame.axes * glm::dvec3{1, 0, 0};
    ASSERT_TRUE(gizmo.begin(kView, GizmoHandle::X, pixelOf(kView, frame.pivot + along * length), one));
    auto scaled = gizmo.update(kView, pixelOf(kView, frame.pivot + along * length * 1.5), false);
    EXPECT_NEAR(scaled[0].scale.x, 1.5, 1e-4);
    EXPECT_EQ(scaled[0].scale.y, -2);
    EXPECT_EQ(scaled[0].position, one[0].position);
    scaled = gizmo.update(kView, pixelOf(kView, frame.pivot + along * length * 1.52), true);
    EXPECT_FLOAT_EQ(scaled[0].scale.x, 1.5f);
    scaled = gizmo.update(kView, pixelOf(kView, frame.pivot - along * length * 5.0), false);
    EXPECT_GT(scaled[0].scale.x, 0); // never through zero
    gizmo.end();
    ASSERT_TRUE(gizmo.begin(kView, GizmoHandle::Centre, {400, 300}, one));
    scaled = gizmo.update(kView, {400 + Gizmo::kLength / 2, 300}, false);
    EXPECT_FLOAT_EQ(scaled[0].scale.y, -3);
    EXPECT_FLOAT_EQ(scaled[0].scale.z, 4.5f);
}

TEST(Gizmo, NothingIsDraggedOutOfTheWorld)
{
    Gizmo gizmo;
    const std::vector<io::Transform> one{{.position = {9'999'995, 0, 0}}};
    const View view{.camera = {.eye = {9'999'995, 0, 20}}, .size = {1280, 720}};
    const double length = handleLength(view, one[0].position);
    ASSERT_TRUE(gizmo.begin(view, GizmoHandle::X, pixelOf(view, one[0].position + glm::dvec3{length, 0, 0}), one));
    EXPECT_NEAR(gizmo.update(view, pixelOf(view, one[0].position + glm::dvec3{length + 3, 0, 0}), false)[0].position.x,
                9'999'998, 0.01);
    EXPECT_EQ(gizmo.update(view, pixelOf(view, one[0].position + glm::dvec3{length + 9, 0, 0}), false)[0], one[0]);
}

TEST(Gizmo, StaysSoundWhateverTheViewAndTheMouseDo)
{
    Random random{17};
    for (int round = 0; round < 400; ++round) {
        Gizmo gizmo;
        gizmo.mode = GizmoMode(random.bits() % 3);
        gizmo.space = GizmoSpace(random.bits() % 2);
        std::vector<io::Transform> start{test::randomTransform(random, 10), test::randomTransform(random, 10)};
        View view = kView;
        view.camera.eye = {random.in(-20, 20), random.in(-20, 20), random.in(-20, 20)};
        // Often exactly along an axis, or standing in the pivot.
        if (round % 4 == 0) {
            start.resize(1);
            start[0].rotation = glm::vec3{0};
            view.camera.eye = start[0].position + glm::dvec3{0, 0, 10};
            view.camera.yaw = view.camera.pitch = 0;
        } else if (round % 4 == 1) {
            start.resize(1);
            view.camera.eye = start[0].position + glm::dvec3{0, round % 8 == 1 ? 0.0 : 10.0, 0};
            view.camera.pitch = -90;
        }
        for (const GizmoShape& shape : gizmo.shapes(view, *gizmo.frame(start)))
            for (const glm::dvec2 point : shape.points)
                ASSERT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
        if (!gizmo.begin(view, GizmoHandle(1 + random.bits() % 8), {random.in(0, 1280), random.in(0, 720)}, start))
            continue;
        for (int i = 0; i < 20; ++i) {
            const auto result = gizmo.update(view, {random.in(-500, 1800), random.in(-500, 1200)}, random.bits() % 2);
            ASSERT_EQ(result.size(), start.size());
            ASSERT_TRUE(sound(result)) << "round " << round;
        }
    }
}
