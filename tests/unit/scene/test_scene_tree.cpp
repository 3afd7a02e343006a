#include "io/scene/scene_tree.h"

#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>

using namespace io;

namespace {

using Tree = SceneTree<std::uint32_t>;
using Everything = std::map<std::uint32_t, WorldBox>;

class Dice {
public:
    explicit Dice(unsigned seed) : m_engine{seed} {}
    std::uint32_t below(std::uint32_t count) { return std::uint32_t(m_engine() % count); }
    double in(double low, double high) { return low + (high - low) * double(m_engine()) / 4294967295.0; }

private:
    std::mt19937 m_engine;
};

WorldBox boxAt(const glm::dvec3& at, const glm::dvec3& half)
{
    return {at - half, at + half};
}

// Forests, towers, a far island, heaps at one place, big and flat things, points.
WorldBox randomBox(Dice& dice)
{
    switch (dice.below(9)) {
    case 0: // a tower of small things
        return boxAt({500 + dice.in(-3, 3), dice.in(0, 4000), -700 + dice.in(-3, 3)}, glm::dvec3{dice.in(0, 1)});
    case 1: // far away
        return boxAt({-90'000 + dice.in(-50, 50), dice.in(0, 5), 80'000 + dice.in(-50, 50)}, {1, 1, 1});
    case 2: // a heap
        return boxAt({12.25, 3, -40.5}, {0.5, 0.5, 0.5});
    case 3: // large
        return boxAt({dice.in(-3000, 3000), 0, dice.in(-3000, 3000)}, {dice.in(10, 2000), 1, dice.in(10, 2000)});
    case 4: // masts
        return boxAt({dice.in(-300, 300), 50, dice.in(-300, 300)}, {0.2, 50, 0.2});
    case 5: // points
        return boxAt({dice.in(-20, 20), dice.in(-20, 20), dice.in(-20, 20)}, {0, 0, 0});
    default:
        return boxAt({dice.in(-2000, 2000), dice.in(0, 30), dice.in(-2000, 2000)},
                     {dice.in(0, 4), dice.in(0, 9), dice.in(0, 4)});
    }
}

// What the tree keeps of a box is what the brute force looks at; that it holds the given one is a test of its own.
WorldBox kept(const WorldBox& box)
{
    const Box rounded = roundedOutwards(box);
    return {glm::dvec3{rounded.min}, glm::dvec3{rounded.max}};
}

using Found = std::vector<std::pair<double, std::uint32_t>>;

void compareTouching(const Tree& tree, const Everything& all, const WorldBox& box)
{
    std::set<std::uint32_t> expected, found;
    for (const auto& [value, b] : all)
        if (b.min.x <= box.max.x && b.min.y <= box.max.y && b.min.z <= box.max.z && b.max.x >= box.min.x &&
            b.max.y >= box.min.y && b.max.z >= box.min.z)
            expected.insert(value);
    tree.touching(box, [&](const Tree::Item& item) { EXPECT_TRUE(found.insert(item.value).second); });
    EXPECT_EQ(found, expected);
}

double rayEntry(const WorldBox& box, const Ray& ray) // by its own arithmetic
{
    double in = 0, out = 1e300;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = ray.direction[axis], o = ray.origin[axis];
        if (d == 0) {
            if (o < box.min[axis] || o > box.max[axis]) return -1;
            continue;
        }
        in = std::max(in, ((d > 0 ? box.min : box.max)[axis] - o) / d);
        out = std::min(out, ((d > 0 ? box.max : box.min)[axis] - o) / d);
    }
    return in <= out ? in : -1;
}

void compareRay(const Tree& tree, const Everything& all, const Ray& ray, double reach)
{
    std::map<std::uint32_t, double> expected, found;
    for (const auto& [value, box] : all)
        if (const double at = rayEntry(box, ray); at >= 0 && at <= reach) expected[value] = at;
    double last = 0;
    tree.ray(ray, reach, [&](const Tree::Item& item, double entry) {
        EXPECT_GE(entry, last);
        last = entry;
        EXPECT_TRUE(found.emplace(item.value, entry).second);
        return reach;
    });
    // Grazing an edge or the end of the reach may come out either way.
    for (const auto& [value, at] : expected) {
        if (found.contains(value)) continue;
        EXPECT_LT(rayEntry(boxAt(all.at(value).centre(), all.at(value).size() * 0.4999999), ray), 0) << value;
    }
    for (const auto& [value, at] : found) {
        const double again = rayEntry(all.at(value), ray);
        EXPECT_GE(rayEntry(boxAt(all.at(value).centre(), all.at(value).size() * 0.5000001 + 1e-9), ray), 0);
        EXPECT_TRUE(again < 0 || std::abs(at - again) <= 1e-6 + 1e-9 * at) << at << " " << again;
    }
}

void compareNearest(const Tree& tree, const Everything& all, const glm::dvec3& point)
{
    Found expected, found;
    for (const auto& [value, box] : all)
        expected.emplace_back(glm::length(glm::max(glm::max(box.min - point, point - box.max), glm::dvec3{0})), value);
    std::ranges::sort(expected);
    expected.resize(std::min<std::size_t>(expected.size(), 10));
    tree.nearest(point, 1e9, [&](const Tree::Item& item, double distance) {
        EXPECT_DOUBLE_EQ(distance,
                         glm::length(glm::max(glm::max(all.at(item.value).min - point, point - all.at(item.value).max),
                                              glm::dvec3{0})));
        found.emplace_back(distance, item.value);
        return found.size() < expected.size() ? 1e9 : -1.0;
    });
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_DOUBLE_EQ(found[i].first, expected[i].first);
}

void compareFrustum(const Tree& tree, const Everything& all, std::span<const glm::dvec4> planes)
{
    std::set<std::uint32_t> expected, found;
    const auto seen = [&](const WorldBox& box) {
        return std::ranges::all_of(planes, [&](const glm::dvec4& p) {
            const glm::dvec3 far{p.x > 0 ? box.max.x : box.min.x, p.y > 0 ? box.max.y : box.min.y,
                                 p.z > 0 ? box.max.z : box.min.z};
            return glm::dot(glm::dvec3{p}, far) + p.w >= 1e-6;
        });
    };
    const auto whole = [&](const WorldBox& box) {
        return std::ranges::all_of(planes, [&](const glm::dvec4& p) {
            const glm::dvec3 near{p.x < 0 ? box.max.x : box.min.x, p.y < 0 ? box.max.y : box.min.y,
                                  p.z < 0 ? box.max.z : box.min.z};
            return glm::dot(glm::dvec3{p}, near) + p.w >= -1e-6;
        });
    };
    for (const auto& [value, box] : all)
        if (seen(box)) expected.insert(value);
    std::size_t offered = 0;
    tree.frustum(planes, [&](std::span<const Tree::Item> items, bool wholly) {
        EXPECT_FALSE(items.empty());
        for (const Tree::Item& item : items) {
            ++offered;
            EXPECT_TRUE(!wholly || whole(all.at(item.value)));
            EXPECT_TRUE(!seen(all.at(item.value)) || found.insert(item.value).second);
        }
    });
    EXPECT_EQ(found, expected);
    EXPECT_LE(offered, all.size());
}

void compareNodes(const Tree& tree, const Everything& all)
{
    std::set<std::uint32_t> found;
    std::vector<int> depths;
    tree.preOrder([&](const Tree::Node& node) {
        for (const Tree::Item& item : node.items) {
            EXPECT_TRUE(found.insert(item.value).second);
            EXPECT_EQ(glm::dvec3{item.box.min}, all.at(item.value).min);
        }
        depths.push_back(node.depth);
        return true;
    });
    EXPECT_EQ(found.size(), all.size());
    std::vector<int> byLevel;
    tree.byLevel([&](const Tree::Node& node) {
        byLevel.push_back(node.depth);
        return true;
    });
    std::ranges::sort(depths);
    EXPECT_EQ(byLevel, depths);
}

void compareAll(const Tree& tree, const Everything& all, Dice& dice)
{
    ASSERT_EQ(tree.validate(), "");
    ASSERT_EQ(tree.size(), all.size());
    compareNodes(tree, all);
    for (int i = 0; i < 6; ++i) {
        const WorldBox about = randomBox(dice);
        compareTouching(tree, all, boxAt(about.centre(), glm::dvec3{dice.in(0, 300)}));
        const glm::dvec3 eye = randomBox(dice).centre();
        const glm::dvec3 way = i == 5 ? glm::dvec3{0, -1, 0} : glm::normalize(about.centre() - eye + 1e-6);
        compareRay(tree, all, {eye + (i == 5 ? glm::dvec3{0, 500, 0} : glm::dvec3{0}), way}, i % 2 ? 1e7 : 1000);
        compareNearest(tree, all, eye);
        const glm::dvec3 side = glm::normalize(glm::cross(way, glm::dvec3{0.1, 1, 0.2}));
        const glm::dvec4 planes[] = {{way + side, -glm::dot(way + side, eye)},
                                     {way - side, -glm::dot(way - side, eye)},
                                     {-way, glm::dot(way, eye) + 2000}};
        compareFrustum(tree, all, planes);
    }
}

std::vector<std::uint32_t> valuesOf(const Everything& all)
{
    std::vector<std::uint32_t> values;
    for (const auto& entry : all)
        values.push_back(entry.first);
    return values;
}

} // namespace

TEST(SceneTree, ThroughTwentyThousandEditsItSaysWhatLookingAtEveryBoxSays)
{
    Dice dice{1};
    Tree tree;
    Everything all;
    std::vector<std::uint32_t> values;
    for (int step = 0; step < 20'000; ++step) {
        // It grows, shrinks to nearly nothing, and grows again.
        const bool growing = step % 8000 < 5000;
        const std::uint32_t dies = dice.below(10);
        if (values.empty() || dies < (growing ? 5u : 1u)) {
            const std::uint32_t value = dice.below(4) ? std::uint32_t(step) : 4'000'000'000u - std::uint32_t(step);
            const WorldBox box = randomBox(dice);
            ASSERT_TRUE(tree.insert(value, box));
            all[value] = kept(box);
            values.push_back(value);
        } else {
            const std::size_t at = dice.below(std::uint32_t(values.size()));
            const std::uint32_t value = values[at];
            if (dies < (growing ? 8u : 3u)) {
                WorldBox box = all.at(value);
                if (dice.below(3)) {
                    const glm::dvec3 by{dice.in(-2, 2), dice.in(-1, 1), dice.in(-2, 2)};
                    box = {box.min + by, box.max + by};
                } else {
                    box = randomBox(dice);
                }
                ASSERT_TRUE(tree.move(value, box));
                all[value] = kept(box);
            } else {
                ASSERT_TRUE(tree.remove(value));
                EXPECT_FALSE(tree.contains(value));
                all.erase(value);
                values[at] = values.back();
                values.pop_back();
            }
        }
        ASSERT_EQ(step % 50 == 0 ? tree.validate() : "", "") << "step " << step;
        if (step % 1000 == 999) compareAll(tree, all, dice);
    }
    for (const std::uint32_t value : valuesOf(all))
        ASSERT_TRUE(tree.remove(value));
    EXPECT_EQ(tree.validate(), "");
    EXPECT_TRUE(tree.bounds().empty());
}

TEST(SceneTree, BuiltAtOnceItIsAsGood)
{
    Dice dice{2};
    Everything all;
    for (std::uint32_t i = 0; i < 5000; ++i)
        all[i * 7] = kept(randomBox(dice));
    const std::vector<std::uint32_t> values = valuesOf(all);
    Tree tree;
    tree.insert(4, boxAt({0, 0, 0}, {1, 1, 1}));
    tree.build(values, [&](std::uint32_t value) { return all.at(value); });
    compareAll(tree, all, dice);
    for (std::uint32_t i = 0; i < 5000; i += 2) {
        tree.move(values[i], all[values[i]] = kept(randomBox(dice)));
        if (i % 3 == 0) all.erase(values[i]), tree.remove(values[i]);
    }
    compareAll(tree, all, dice);
}

TEST(SceneTree, KeepsBoxesThatHoldTheGivenOnes)
{
    Dice dice{3};
    Tree tree;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const WorldBox box = boxAt({dice.in(-1e5, 1e5), dice.in(-1e5, 1e5), 1e5}, glm::dvec3{dice.in(0, 1)});
        tree.insert(i, box);
        const Box now = tree.box(i);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LE(double(now.min[axis]), box.min[axis]);
            EXPECT_GE(double(now.max[axis]), box.max[axis]);
            EXPECT_LE(box.min[axis] - double(now.min[axis]), 0.0079);
            EXPECT_LE(double(now.max[axis]) - box.max[axis], 0.0079);
        }
    }
}

TEST(SceneTree, RefusesWhatIsNoBox)
{
    Tree tree;
    EXPECT_TRUE(tree.insert(1, boxAt({1, 2, 3}, {0, 0, 0})));
    EXPECT_FALSE(tree.insert(1, boxAt({1, 2, 3}, {0, 0, 0})));
    EXPECT_FALSE(tree.move(2, boxAt({1, 2, 3}, {0, 0, 0})));
    EXPECT_FALSE(tree.remove(2));
    EXPECT_EQ(tree.refused(), 0u);
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(tree.insert(2, {}));
    EXPECT_FALSE(tree.insert(2, boxAt({NAN, 0, 0}, {1, 1, 1})));
    EXPECT_FALSE(tree.insert(2, boxAt({0, 0, 0}, {1, infinite, 1})));
    EXPECT_FALSE(tree.insert(2, boxAt({0, 1e300, 0}, {1, 1, 1})));
    EXPECT_FALSE(tree.move(1, boxAt({0, 0, NAN}, {1, 1, 1})));
    EXPECT_EQ(tree.refused(), 5u);
    EXPECT_EQ(tree.box(1).min, glm::vec3(1, 2, 3));
    EXPECT_EQ(tree.size(), 1u);
    EXPECT_TRUE(tree.insert(3, boxAt({Tree::kReach - 1, 0, -Tree::kReach + 1}, {1, 1, 1})));
    EXPECT_EQ(tree.validate(), "");
}

TEST(SceneTree, ThousandsAtOnePlaceAreOneNode)
{
    Tree tree;
    for (std::uint32_t i = 0; i < 10'000; ++i)
        tree.insert(i, boxAt({7, 8, 9}, glm::dvec3{0.5 + 1e-5 * i}));
    tree.insert(10'000, boxAt({700, 8, 9}, {1, 1, 1}));
    EXPECT_EQ(tree.validate(), "");
    int deepest = 0;
    tree.preOrder([&](const Tree::Node& node) {
        deepest = std::max(deepest, node.depth);
        return true;
    });
    EXPECT_LT(deepest, 30);
    for (std::uint32_t i = 10'000; i-- > 0;) // the widest first
        tree.remove(i);
    EXPECT_EQ(tree.validate(), "");
    EXPECT_EQ(tree.bounds().min.x, 699);
}

TEST(SceneTree, ATowerIsSplitInHeight)
{
    Tree tree;
    for (std::uint32_t i = 0; i < 4000; ++i)
        tree.insert(i, boxAt({0, 2.5 * i, 0}, {1, 1, 1}));
    EXPECT_EQ(tree.validate(), "");
    std::size_t largest = 0, seen = 0;
    tree.preOrder([&](const Tree::Node& node) {
        largest = std::max(largest, node.items.size());
        return true;
    });
    EXPECT_LE(largest, Tree::kCrowded);
    tree.preOrder([&](const Tree::Node& node) {
        ++seen;
        return double(node.box.min.y) <= 5000 && double(node.box.max.y) >= 5000;
    });
    EXPECT_LT(seen, 40u);
}

TEST(SceneTree, ChildrenComeInTheOrderAskedFor)
{
    Dice dice{5};
    Tree tree;
    for (std::uint32_t i = 0; i < 2000; ++i)
        tree.insert(i, randomBox(dice));
    const glm::dvec3 eye{-300, 10, 250};
    const auto far = [&](const Tree::Node& node) { return distance(node.box, eye); };
    std::map<int, double> last; // of the siblings seen so far, by depth
    int nodes = 0;
    tree.preOrder(
        [&](const Tree::Node& node) {
            last.erase(last.upper_bound(node.depth), last.end());
            EXPECT_TRUE(!last.contains(node.depth) || far(node) >= last[node.depth]);
            last[node.depth] = far(node);
            ++nodes;
            return true;
        },
        far);
    int byLevel = 0, depth = 0;
    tree.byLevel(
        [&](const Tree::Node& node) {
            EXPECT_GE(node.depth, depth);
            depth = node.depth;
            ++byLevel;
            return node.depth < 3;
        },
        far);
    EXPECT_EQ(depth, 3);
    EXPECT_LT(byLevel, nodes);
}

TEST(SceneTree, TheRayStopsWhereItIsToldTo)
{
    Tree tree;
    for (std::uint32_t i = 0; i < 1000; ++i)
        tree.insert(i, boxAt({10.0 * i, 0, 0}, {1, 1, 1}));
    int met = 0;
    tree.ray({{-50, 0, 0}, {1, 0, 0}}, 1e9, [&](const Tree::Item& item, double entry) {
        ++met;
        return item.value == 5 ? entry : 1e9;
    });
    EXPECT_EQ(met, 6);
}

// However dense they lie: the grid of cells is as coarse as it is.
TEST(SceneTree, AThingTakesSixtyBytes)
{
    Dice dice{6};
    std::vector<std::uint32_t> values(100'000);
    std::vector<WorldBox> boxes(values.size());
    for (const double reach : {5e4, 4.1e4, 3.2e4, 2.6e4}) {
        Tree oneByOne;
        for (std::uint32_t i = 0; i < values.size(); ++i) {
            values[i] = i;
            boxes[i] = boxAt({dice.in(-reach, reach), dice.in(0, 100), dice.in(-reach, reach)}, {2, 3, 2});
            oneByOne.insert(i, boxes[i]);
        }
        Tree tree;
        tree.build(values, [&](std::uint32_t i) { return boxes[i]; });
        EXPECT_LT(double(tree.bytes()) / double(values.size()), 60) << reach;
        EXPECT_LT(double(oneByOne.bytes()) / double(values.size()), 80) << reach;
    }
}
