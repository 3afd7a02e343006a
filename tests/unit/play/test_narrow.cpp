#include "stage.h"

#include "io/base/random.h"

#include <gtest/gtest.h>

namespace play {
namespace {

const Mover kPill{.radius = 0.3, .stem = 0.6}, kBox{.half = {0.3, 0.9, 0.3}};

// A sweep ends just where the two touch, from whichever side, for every kind of thing.
TEST(Narrow, ASweepEndsWhereTwoTouch)
{
    test::Stage stage;
    for (const io::Collision collision : {io::Collision::Box, io::Collision::Capsule, io::Collision::Hull, io::Collision::Mesh})
        stage.place(stage.addBox({1, 2, 1.5f}, collision), {double(collision) * 10, 0, 0}, {20, 40, -15}, {1.2f, 0.8f, -1});
    io::Random random{9};
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const Mover& mover = i % 2 ? kPill : kBox;
        const glm::dvec3 middle{(1 + i % 4) * 10.0, 0.8, 0};
        const glm::dvec3 from = middle + 5.0 * glm::dvec3{random.direction()}, motion = 2.0 * (middle + glm::dvec3{random.direction()} - from);
        std::optional<Hit> first;
        const auto things = stage.surroundings().find({glm::min(from, from + motion) - 1.0, glm::max(from, from + motion) + 1.0});
        for (const Thing& thing : things)
            if (const auto hit = sweep(mover, from, motion, thing); hit && (!first || hit->share < first->share)) first = hit;
        if (!first) continue;
        ++hits;
        double least = 1;
        for (const Thing& thing : things)
            if (const auto contact = contactOf(mover, from + motion * first->share, thing, 0.5)) least = std::min(least, contact->distance);
        EXPECT_NEAR(least, kTouch, 5e-4) << i;
        EXPECT_LT(glm::dot(first->contact.normal, motion), 0) << i;
    }
    EXPECT_GT(hits, 1000);
}

TEST(Narrow, NothingIsPassedThroughAtAnySpeed)
{
    test::Stage stage;
    stage.place(stage.addBox({4, 4, 0.01f}, io::Collision::Mesh), {0, -2, 0});
    for (const double far : {1.0, 10.0, 1000.0})
        for (const Mover& mover : {kPill, kBox}) {
            const glm::dvec3 from{0.1, 0, far}, motion{0, 0, -2 * far};
            bool hit = false;
            for (const Thing& thing : stage.surroundings().find({{-5, -5, -2 * far}, {5, 5, 2 * far}}))
                hit |= sweep(mover, from, motion, thing).has_value();
            EXPECT_TRUE(hit) << far;
        }
}

} // namespace
} // namespace play
