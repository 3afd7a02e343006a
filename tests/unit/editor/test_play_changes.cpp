#include "tests/unit/editor/worlds.h"

#include "editor/play_changes.h"

#include <gtest/gtest.h>

using namespace editor;
using test::forest;

namespace {

struct PlayChanges : testing::Test {
    std::unique_ptr<Document> document = forest(20, 1);
    std::vector<io::ObjectId> ids = document->scene().sortedIds();
    std::vector<PlayChange> changes;

    io::Object& moved(std::size_t i, const glm::dvec3& by, float turn)
    {
        PlayChange change{document->scene().at(ids[i]), document->scene().at(ids[i])};
        change.after->transform.position += by;
        change.after->transform.rotation.x += turn;
        changes.push_back(change);
        return *changes.back().after;
    }
};

TEST_F(PlayChanges, WhatOnlyTrembledIsNoChange)
{
    moved(0, {0.002, 0, 0}, 0.2f);
    moved(1, {1, 0, 0}, 0);
    moved(2, {0, 0, 0}, 30);
    changes.push_back({document->scene().at(ids[3]), std::nullopt});
    const auto rows = playRows(*document, changes);
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0].property, PlayProperty::Position);
    EXPECT_EQ(rows[1].property, PlayProperty::Rotation);
    EXPECT_EQ(rows[2].property, PlayProperty::Shown);
    for (const PlayRow& row : rows)
        EXPECT_FALSE(row.keep);
}

TEST_F(PlayChanges, WhatIsTickedIsKeptAndIsOneUndoStep)
{
    moved(0, {1, 2, 3}, 40);
    moved(1, {1, 0, 0}, 50);
    changes.push_back({document->scene().at(ids[2]), std::nullopt});
    changes.push_back({document->scene().at(ids[3]), std::nullopt});
    const io::Scene before = document->scene();
    auto rows = playRows(*document, changes);
    ASSERT_EQ(rows.size(), 6u);
    keepPlayChanges(*document, "Keep", changes, rows); // nothing is ticked
    EXPECT_TRUE(io::sameContent(document->scene(), before));
    EXPECT_FALSE(document->history().canUndo());
    rows[0].keep = rows[3].keep = rows[4].keep = true;
    keepPlayChanges(*document, "Keep", changes, rows);
    EXPECT_EQ(document->scene().at(ids[0]).transform.position, before.at(ids[0]).transform.position + glm::dvec3(1, 2, 3));
    EXPECT_EQ(document->scene().at(ids[0]).transform.rotation, before.at(ids[0]).transform.rotation);
    EXPECT_EQ(document->scene().at(ids[1]).transform.position, before.at(ids[1]).transform.position);
    EXPECT_EQ(document->scene().at(ids[1]).transform.rotation, changes[1].after->transform.rotation);
    EXPECT_FALSE(document->scene().find(ids[2]));
    EXPECT_TRUE(document->scene().find(ids[3]));
    EXPECT_EQ(document->undo(), "Keep");
    EXPECT_TRUE(io::sameContent(document->scene(), before));
    EXPECT_FALSE(document->history().canUndo());
}

TEST_F(PlayChanges, WhatIsGoneMeanwhileIsLeftOut)
{
    moved(0, {1, 2, 3}, 40);
    auto rows = playRows(*document, changes);
    for (PlayRow& row : rows)
        row.keep = true;
    removeObjects(*document, "Delete", {&ids[0], 1});
    EXPECT_TRUE(playRows(*document, changes).empty());
    keepPlayChanges(*document, "Keep", changes, rows);
    EXPECT_FALSE(document->scene().find(ids[0]));
}

} // namespace
