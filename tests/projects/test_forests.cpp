#include "tests/projects/shipped.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>

namespace {

struct Row {
    const char* name;
    std::size_t triangles;
    std::size_t copies;
};

// The benchmark's table; each set holds the one before.
const Row kRows[] = {{"Rock2", 356, 65},       {"Campfire", 7202, 3},      {"Axe", 548, 2},
                     {"Tree1", 1576, 657},     {"Tree2", 1754, 629},       {"AutumnTree1", 1596, 635},
                     {"Tree3", 1442, 651},     {"AutumnTree2", 2630, 676}, {"FirTree", 736, 166},
                     {"DeadBranch", 1500, 65}, {"DeadTree", 3600, 172},    {"Stump", 2999, 1},
                     {"Stump2", 8704, 1}};

struct Set {
    const char* name;
    std::size_t rows;
    std::size_t triangles;
};

class Forest : public testing::TestWithParam<Set> {};

TEST_P(Forest, HoldsExactlyTheTriangles)
{
    const tests::Shipped& world = tests::shipped(GetParam().name);
    std::map<std::string_view, std::size_t> copies;
    for (const io::Object& object : world.scene().objects())
        ++copies[world.scene().templateName(object.templateId)];

    std::size_t total = 0;
    for (std::size_t i = 0; i < GetParam().rows; ++i) {
        const Row& row = kRows[i];
        const io::Model* model = world.assets.model(world.scene().findTemplate(row.name));
        ASSERT_NE(model, nullptr) << row.name;
        EXPECT_EQ(model->triangles(), row.triangles) << row.name;
        EXPECT_EQ(copies[row.name], row.copies) << row.name;
        total += model->triangles() * copies[row.name];
    }
    EXPECT_EQ(copies.size(), GetParam().rows) << "there is more than the table names";
    EXPECT_EQ(total, GetParam().triangles);
}

TEST_P(Forest, CoversASquareKilometreAndIsDenserInTheMiddle)
{
    const tests::Shipped& world = tests::shipped(GetParam().name);
    EXPECT_EQ(world.scene().heights()->size, glm::ivec2{1025});
    EXPECT_EQ(world.scene().heights()->metresPerTexel, 1);
    std::size_t inner = 0, outer = 0;
    for (const io::Object& object : world.scene().objects()) {
        const double away = glm::length(glm::dvec2{object.transform.position.x, object.transform.position.z});
        EXPECT_LT(away, 512);
        ++(away < 240 ? inner : outer);
    }
    // Per area: the inner disc is a third as large as the ring out to 490 m.
    EXPECT_GT(double(inner) / (240.0 * 240.0), 1.5 * double(outer) / (490.0 * 490.0 - 240.0 * 240.0));
}

INSTANTIATE_TEST_SUITE_P(Sets, Forest,
                         testing::Values(Set{"forest-1", 4, 1081274}, Set{"forest-2", 6, 3198000},
                                         Set{"forest-3", 13, 6765201}),
                         [](const auto& set) { return "Set" + std::to_string(set.index + 1); });

} // namespace
