#include "app/play/closest.h"
#include "io/base/random.h"

#include <gtest/gtest.h>

namespace play {
namespace {

glm::dvec3 anywhere(io::Random& random)
{
    return {random.signedUnit(), random.signedUnit(), random.signedUnit()};
}

TEST(Closest, NoPointsOfASegmentAndATriangleAreNearer)
{
    io::Random random{5};
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 a = anywhere(random), b = anywhere(random);
        const Triangle triangle{anywhere(random), anywhere(random), anywhere(random)};
        const double least = std::sqrt(nearestToTriangle(a, b, triangle).squared);
        for (int k = 0; k < 300; ++k) {
            double u = random.unit(), v = random.unit();
            if (u + v > 1) u = 1 - u, v = 1 - v;
            const glm::dvec3 on = triangle[0] + u * (triangle[1] - triangle[0]) + v * (triangle[2] - triangle[0]);
            EXPECT_LE(least, glm::length(glm::mix(a, b, double(random.unit())) - on) + 1e-9);
        }
    }
}

TEST(Closest, ATriangleWithoutAreaIsALine)
{
    const Triangle line{glm::dvec3{0}, {1, 0, 0}, {2, 0, 0}};
    EXPECT_NEAR(nearestToTriangle({1.5, 1, 0}, {1.5, 3, 0}, line).squared, 1, 1e-12);
    const Triangle dot{glm::dvec3{1}, glm::dvec3{1}, glm::dvec3{1}};
    EXPECT_NEAR(nearestToTriangle({1, 3, 1}, {1, 4, 1}, dot).squared, 4, 1e-12);
    EXPECT_EQ(faceNormal(dot), glm::dvec3{0});
}

} // namespace
} // namespace play
