#include "projects/make/models.h"
#include "projects/make/shapes.h"
#include "tests/projects/facing.h"

#include <gtest/gtest.h>

namespace {

TEST(Facing, AnInsideOutStoneIsFound)
{
    make::Mesh stone = make::makeStone({});
    ASSERT_EQ(tests::piecesOf(stone).size(), 1u);
    EXPECT_GT(tests::piecesOf(stone).front().volume, 0);
    make::Triangle& one = stone.triangles().front();
    std::swap(one.corners[1], one.corners[2]);
    EXPECT_GT(tests::piecesOf(stone).front().turnedEdges, 0);
    for (make::Triangle& t : stone.triangles())
        std::swap(t.corners[1], t.corners[2]);
    EXPECT_LT(tests::piecesOf(stone).front().volume, 0);
    EXPECT_GT(tests::piecesOf(stone).front().turnedOver, 0.9);
    EXPECT_LT(tests::piecesOf(stone).front().agreeing, 0.1);
}

TEST(Facing, EveryModelLooksOutwards)
{
    for (const std::span<const make::Entry> entries : {make::valleyEntries(), make::forestEntries()})
        for (const make::Entry& entry : entries) {
            const std::vector<tests::Piece> pieces = tests::piecesOf(entry.build());
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                const tests::Piece& piece = pieces[i];
                SCOPED_TRACE(testing::Message() << entry.name << ", piece " << i << " of " << pieces.size() << " with "
                                                << piece.area << " m2");
                EXPECT_GT(piece.agreeing, 0.98);
                EXPECT_LT(piece.turnedEdges, 0.001);
                if (piece.opening < 0.4) { // a sheet has no inside
                    EXPECT_GT(piece.volume, 0);
                    EXPECT_LT(piece.turnedOver, 0.02);
                }
            }
        }
}

TEST(Facing, AFernsFrondsLookUpwards)
{
    const make::Mesh fern = make::entryOf("fern").build();
    for (const make::Triangle& t : fern.triangles()) {
        const auto& [a, b, c] = t.corners;
        EXPECT_GT(glm::dot(glm::cross(b.position - a.position, c.position - a.position), a.normal), 0);
    }
}

} // namespace
