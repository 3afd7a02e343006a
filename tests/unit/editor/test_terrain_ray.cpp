#include "tests/unit/editor/worlds.h"

#include "editor/terrain_ray.h"

#include <gtest/gtest.h>

using namespace editor;

namespace {

// Every triangle of the map, from above only (Möller and Trumbore 1997).
std::optional<double> bruteForce(const io::HeightMap& map, const io::Ray& ray)
{
    std::optional<double> best;
    const auto corner = [&](int x, int z) {
        return glm::dvec3{map.origin.x + x * map.metresPerTexel, map.at(x, z), map.origin.y + z * map.metresPerTexel};
    };
    const auto test = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const glm::dvec3 e1 = b - a, e2 = c - a;
        const glm::dvec3 p = glm::cross(ray.direction, e2);
        const double det = glm::dot(e1, p);
        if (std::abs(det) < 1e-14 || glm::dot(glm::cross(e1, e2), ray.direction) >= 0) return;
        const glm::dvec3 s = ray.origin - a;
        const double u = glm::dot(s, p) / det;
        const glm::dvec3 q = glm::cross(s, e1);
        const double v = glm::dot(ray.direction, q) / det;
        const double t = glm::dot(e2, q) / det;
        const double slack = 1e-10;
        if (u >= -slack && v >= -slack && u + v <= 1 + slack && t >= 0 && (!best || t < *best)) best = t;
    };
    for (int z = 0; z + 1 < map.size.y; ++z)
        for (int x = 0; x + 1 < map.size.x; ++x) {
            test(corner(x, z), corner(x, z + 1), corner(x + 1, z));
            test(corner(x + 1, z), corner(x, z + 1), corner(x + 1, z + 1));
        }
    return best;
}

void expectSame(const io::HeightMap& map, const TerrainRay& ground, const io::Ray& ray)
{
    const auto expected = bruteForce(map, ray);
    const auto found = ground.hit(ray);
    ASSERT_EQ(expected.has_value(), found.has_value())
        << ray.origin.x << ' ' << ray.origin.y << ' ' << ray.origin.z << " dir " << ray.direction.x << ' '
        << ray.direction.y << ' ' << ray.direction.z << (expected ? *expected : -1);
    if (!found) return;
    EXPECT_NEAR(found->distance, *expected, 1e-5);
    const auto height = map.height(found->position.x, found->position.z);
    EXPECT_NEAR(found->position.y, height.value_or(found->position.y), 1e-3);
    EXPECT_LT(glm::dot(found->normal, ray.direction), 0);
}

} // namespace

TEST(TerrainRay, IsWhatEveryTriangleTestedAloneSays)
{
    const auto map = test::hills(66, 1.7, 5); // not a power of two, and a last leaf that is cut short
    const TerrainRay ground{map};
    Random random{9};
    int hits = 0;
    for (int i = 0; i < 1500; ++i) {
        const glm::dvec3 origin{random.in(-70, 70), random.in(-5, 40), random.in(-70, 70)};
        const glm::dvec3 aim{random.in(-55, 55), random.in(-15, 15), random.in(-55, 55)};
        const io::Ray ray{.origin = origin, .direction = glm::normalize(aim - origin)};
        expectSame(*map, ground, ray);
        hits += ground.hit(ray).has_value();
    }
    EXPECT_GT(hits, 700);
}

TEST(TerrainRay, GrazingRaysAndRaysAlongTheGridAgreeToo)
{
    const auto map = test::hills(66, 1.7, 6);
    const TerrainRay ground{map};
    Random random{10};
    for (int i = 0; i < 500; ++i) {
        const double y = random.in(map->min, map->max);
        const double angle = random.in(0, 6.3);
        const glm::dvec3 out{std::cos(angle), random.in(-1e-3, 1e-3), std::sin(angle)};
        expectSame(*map, ground, {.origin = glm::dvec3{0, y, 0} - out * 80.0, .direction = glm::normalize(out)});
        // Exactly over a row of texels, and straight down onto one.
        const double row = map->origin.y + 1.7 * double(random.bits() % 65);
        expectSame(*map, ground, {.origin = {-80, y, row + 1e-7}, .direction = {1, 0, 0}});
    }
    for (int z = 0; z < 66; ++z)
        for (int x = 0; x < 66; ++x) {
            const glm::dvec3 above{map->origin.x + x * 1.7, 100, map->origin.y + z * 1.7};
            const auto down = ground.hit({.origin = above, .direction = {0, -1, 0}});
            ASSERT_TRUE(down.has_value()) << x << ' ' << z;
            EXPECT_NEAR(down->position.y, map->at(x, z), 1e-6);
        }
}

TEST(TerrainRay, ARidgeOfOneTexelStopsEveryRay)
{
    const io::HeightGrid ridge{.size = {1, 257}, .metres = std::vector<float>(257, 30)};
    const auto map = std::make_shared<const io::HeightMap>(test::flat(257, 0)->with(ridge, {131, 0}));
    const TerrainRay ground{map};
    Random random{3};
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 from{-120, random.in(1, 29), random.in(-100, 100)};
        const glm::dvec3 to{120, random.in(1, 29), from.z + random.in(-20, 20)};
        const auto hit = ground.hit({.origin = from, .direction = glm::normalize(to - from)});
        ASSERT_TRUE(hit.has_value());
        EXPECT_NEAR(hit->position.x, 3, 1.01);
    }
}

TEST(TerrainRay, FollowsAPartThatChanged)
{
    const auto before = test::hills(130, 1.3, 5);
    TerrainRay followed{before};
    io::HeightGrid part{.size = {31, 17}};
    for (int i = 0; i < 31 * 17; ++i)
        part.metres.push_back(float(30 + i % 7));
    const glm::ivec2 at{64, 99};
    const auto after = std::make_shared<const io::HeightMap>(before->with(part, at));
    followed.update(after, {at, at + part.size});
    const TerrainRay fresh{after};
    Random random{4};
    for (int i = 0; i < 4000; ++i) {
        const glm::dvec3 from{random.in(-90, 90), random.in(0, 60), random.in(-90, 90)};
        const io::Ray ray{.origin = from, .direction = glm::normalize(glm::dvec3{random.in(-1, 1), random.in(-1, 0.2), random.in(-1, 1)})};
        const auto a = followed.hit(ray), b = fresh.hit(ray);
        ASSERT_EQ(a.has_value(), b.has_value());
        ASSERT_EQ(a ? a->distance : 0, b ? b->distance : 0);
    }
}

TEST(TerrainRay, OddMapsAndRaysAreNoTrouble)
{
    EXPECT_FALSE(TerrainRay{nullptr}.hit({}).has_value());
    const auto tiny = test::flat(2, 5);
    const TerrainRay ground{tiny};
    EXPECT_TRUE(ground.hit({.origin = {0.1, 9, 0.1}, .direction = {0, -1, 0}}).has_value());
    EXPECT_FALSE(ground.hit({.origin = {0.1, 9, 0.1}, .direction = {0, 1, 0}}).has_value());
    EXPECT_FALSE(ground.hit({.origin = {0.1, 9, 0.1}, .direction = {0, -1, 0}}, 3.9).has_value());
    EXPECT_FALSE(ground.hit({.origin = {0.1, 1, 0.1}, .direction = {0, 1, 0}}).has_value()); // its underside
    EXPECT_FALSE(ground.hit({.origin = {NAN, 9, 0.1}, .direction = {0, -1, 0}}).has_value());
    EXPECT_FALSE(TerrainRay{test::flat(1, 5)}.hit({.origin = {0, 9, 0}, .direction = {0, -1, 0}}).has_value());
}
