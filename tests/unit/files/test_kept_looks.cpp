// A person's own looks are found by name, and what is no name or no look says so.
#include "io/files/kept_looks.h"
#include "io/scene/environment_presets.h"
#include "tests/unit/files/support.h"

namespace io {
namespace {

TEST(KeptLooks, ComeBackAsTheyWereKept)
{
    const TemporaryFolder folder;
    KeptLooks kept{folder / "looks"};
    Complaints complaints;
    EXPECT_TRUE(kept.names().empty());
    Environment look;
    look.time = 6.125f;
    look.fog.tint = {1, 0.5f, 0.25f};
    look.latitude = 10;
    ASSERT_TRUE(kept.save("Mlžné ráno", look));
    ASSERT_TRUE(kept.save("Another", {}));
    EXPECT_EQ(kept.names(), (std::vector<std::string>{"Another", "Mlžné ráno"}));
    const auto read = kept.read("Mlžné ráno", complaints);
    ASSERT_TRUE(read);
    EXPECT_TRUE(*read == look);

    Environment own;
    own.latitude = 60;
    const auto named = lookNamed("Mlžné ráno", own, kept, complaints);
    ASSERT_TRUE(named);
    EXPECT_EQ(named->time, look.time);
    EXPECT_EQ(named->latitude, 60) << "the place stays";
    ASSERT_TRUE(kept.remove("Another"));
    EXPECT_EQ(kept.names().size(), 1u);
    EXPECT_FALSE(kept.remove("Another"));
}

TEST(KeptLooks, WhatIsNoNameChangesNothing)
{
    const TemporaryFolder folder;
    KeptLooks kept{folder / "looks"};
    for (const char* name : {"", ".", "..", ".hidden", "a/b", "../out", "a\\b", "line\nbreak", "dawn", "Dawn", "GOLDEN-hour"})
        EXPECT_FALSE(kept.save(name, {})) << name;
    EXPECT_FALSE(kept.save(std::string(81, 'x'), {}));
    EXPECT_TRUE(kept.names().empty());
    EXPECT_FALSE(fs::exists(folder / "out.json"));
}

TEST(KeptLooks, AnUnknownOneNamesThoseThatThereAre)
{
    const TemporaryFolder folder;
    KeptLooks kept{folder / "looks"};
    Complaints complaints;
    ASSERT_TRUE(kept.save("Mine", {}));
    const auto none = lookNamed("Yours", {}, kept, complaints);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().text().find("golden-hour"), std::string::npos);
    EXPECT_NE(none.error().text().find("Mine"), std::string::npos);
    const auto dawn = lookNamed("dawn", {}, kept, complaints);
    ASSERT_TRUE(dawn);
    EXPECT_TRUE(*dawn == withPreset({}, Preset::Dawn));
}

TEST(KeptLooks, ADamagedFileIsSaid)
{
    const TemporaryFolder folder;
    KeptLooks kept{folder / "looks"};
    Complaints complaints;
    ASSERT_TRUE(kept.save("Mine", {}));
    put(folder / "looks" / "Mine.json", "{\"format\":");
    const auto read = lookNamed("Mine", {}, kept, complaints);
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().text().find("Mine.json"), std::string::npos);
}

TEST(KeptLooks, BadValuesAreSaidAndMended)
{
    const TemporaryFolder folder;
    KeptLooks kept{folder / "looks"};
    Complaints complaints;
    ASSERT_TRUE(kept.save("Mine", {}));
    put(folder / "looks" / "Mine.json", "{\"format\": \"wold-environment\", \"version\": 1, \"exposure\": \"x\",\n\"fog\": {\"density\": -5}}");
    const auto read = lookNamed("Mine", {}, kept, complaints);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->fog.density, 0);
    const std::string file = (folder / "looks" / "Mine.json").string();
    EXPECT_EQ(listed(complaints), file + ":1: exposure: expected a number, found \"x\"\n" + file + ":2: fog.density: -5 is outside 0 to 0.1 1/m\n");
}

} // namespace
} // namespace io
