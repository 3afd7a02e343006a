// The scene tree's nodes as lines.
#include "renderer/debug_lines.h"

#include <chrono>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace {

constexpr glm::ivec2 kSize{320, 180};

io::WorldBox cube(const glm::dvec3& centre, double half)
{
    return {centre - half, centre + half};
}

renderer::InstanceTree treeOf(int count, const glm::dvec3& extent)
{
    std::mt19937 random{4};
    std::uniform_real_distribution<double> unit{-1, 1};
    std::vector<glm::dvec3> places;
    std::vector<std::uint32_t> rows;
    for (int i = 0; i < count; ++i) {
        places.push_back(glm::dvec3{unit(random), unit(random), unit(random)} * extent);
        rows.push_back(std::uint32_t(i));
    }
    renderer::InstanceTree tree;
    tree.build(rows, [&](std::uint32_t row) { return cube(places[row], 0.5); });
    return tree;
}

std::vector<renderer::Line> linesOf(const renderer::InstanceTree& tree, const renderer::Eye& eye,
                                    const std::optional<renderer::Volume>& culledTo = {})
{
    std::vector<renderer::Line> lines;
    const renderer::InstanceTree* const trees[] = {&tree};
    renderer::addNodes(lines, trees, eye, culledTo);
    return lines;
}

TEST(NodeLines, AreBoxesColouredByDepth)
{
    const renderer::InstanceTree tree = treeOf(2000, {100, 0.1, 100});
    const renderer::Eye eye = renderer::eyeOf({.eye = {0, 300, 0}, .pitch = -90}, kSize);
    const std::vector<renderer::Line> lines = linesOf(tree, eye);
    EXPECT_EQ(lines.size() % 12, 0u) << "a flat world has no rings";
    std::size_t nodes = 0, large = 0;
    int deepest = 0;
    tree.preOrder([&](const auto& node) {
        ++nodes;
        large += glm::distance(node.box.min, node.box.max) > 8;
        deepest = std::max(deepest, node.depth);
        EXPECT_TRUE(node.leaf == (node.children == 0));
        return true;
    });
    EXPECT_GT(large, 20u);
    EXPECT_GE(lines.size(), large * 12);
    EXPECT_LE(lines.size(), nodes * 12);
    std::set<std::tuple<float, float, float>> colours;
    for (const renderer::Line& line : lines)
        colours.insert({line.colour.r, line.colour.g, line.colour.b});
    EXPECT_EQ(colours.size(), std::size_t(deepest) + 1);
}

TEST(NodeLines, ARingRunsAroundWhatSplitsInHeight)
{
    const renderer::InstanceTree tree = treeOf(2000, {60, 60, 60});
    std::size_t nodes = 0, tall = 0;
    tree.preOrder([&](const auto& node) {
        ++nodes;
        tall += node.children == 8 || node.children == 2;
        return true;
    });
    ASSERT_GT(tall, 0u);
    ASSERT_LT(tall, nodes);
    EXPECT_EQ(linesOf(tree, renderer::eyeOf({.eye = {0, 0, 200}}, kSize)).size(), nodes * 12 + tall * 4);
}

TEST(NodeLines, AreFewHoweverManyThingsThereAre)
{
    const renderer::InstanceTree tree = treeOf(300'000, {3000, 2, 3000});
    const auto start = std::chrono::steady_clock::now();
    const std::vector<renderer::Line> lines = linesOf(tree, renderer::eyeOf({.eye = {0, 20, 0}, .pitch = -10}, kSize));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_GT(lines.size(), 100u * 12);
    EXPECT_LE(lines.size(), 600u * 16);
    EXPECT_LT(seconds.count(), 0.2);
    bool near = false;
    for (const renderer::Line& line : lines)
        near |= glm::distance(line.from, {0, 0, -100}) < 60 && glm::distance(line.from, line.to) < 60;
    EXPECT_TRUE(near) << "small ones near by";
}

TEST(NodeLines, AreFaintWhereFrozenCullingDoesNotReach)
{
    const renderer::InstanceTree tree = treeOf(2000, {100, 0.1, 100});
    const renderer::Volume frozen = renderer::volumeOf(renderer::eyeOf({.eye = {0, 1, 0}, .fov = 30}, kSize));
    std::size_t faint = 0, bright = 0;
    for (const renderer::Line& line : linesOf(tree, renderer::eyeOf({.eye = {0, 300, 0}, .pitch = -90}, kSize), frozen))
        ++(line.colour.a < 0.3f ? faint : bright);
    EXPECT_GT(faint, bright);
    EXPECT_GT(bright, 0u);
}

} // namespace
