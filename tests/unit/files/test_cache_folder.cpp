// What may be lost is found again by its key, never damaged and never beyond the folder's share of the disk.
#include "io/files/cache_folder.h"
#include "tests/unit/files/support.h"

#include <chrono>
#include <random>

namespace io {
namespace {

constexpr std::uint64_t kPlenty = 1 << 20;

TEST(CacheFolder, findsWhatWasKeptUnderItsKeyOnly)
{
    const TemporaryFolder folder;
    CacheFolder cache{folder / "a" / "b", ".kept", kPlenty};
    EXPECT_FALSE(cache.find({1, 2}));
    cache.keep({1, 2}, "one");
    cache.keep({1, 3}, std::string("\0\xff", 2));
    cache.keep({2, 2}, "");
    EXPECT_EQ(cache.find({1, 2}), "one");
    EXPECT_EQ(cache.find({1, 3}), std::string("\0\xff", 2));
    EXPECT_EQ(cache.find({2, 2}), "");
    EXPECT_FALSE(cache.find({2, 1}));
    cache.keep({1, 2}, "another");
    EXPECT_EQ((CacheFolder{folder / "a" / "b", ".kept", kPlenty}.find({1, 2})), "another");
    fs::copy_file(cache.fileOf({1, 2}), cache.fileOf({9, 9}));
    EXPECT_FALSE(cache.find({9, 9})) << "another's under this name";
}

TEST(CacheFolder, damagedFilesAreAsNone)
{
    const TemporaryFolder folder;
    CacheFolder cache{folder.path(), ".kept", kPlenty};
    cache.keep({1, 2}, "what was dear to make");
    const std::string good = get(cache.fileOf({1, 2}));
    std::mt19937 random{1};
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string flipped = good;
        flipped[i] ^= char(1 << random() % 8);
        put(cache.fileOf({1, 2}), flipped);
        EXPECT_FALSE(cache.find({1, 2})) << i;
        put(cache.fileOf({1, 2}), good.substr(0, i));
        EXPECT_FALSE(cache.find({1, 2})) << i;
    }
    put(cache.fileOf({1, 2}), good + "more");
    EXPECT_FALSE(cache.find({1, 2}));
    put(cache.fileOf({1, 2}), good);
    EXPECT_TRUE(cache.find({1, 2}));
}

TEST(CacheFolder, aFolderThatCannotBeUsedIsNoError)
{
    const TemporaryFolder folder;
    put(folder / "file", "in the way");
    CacheFolder cache{folder / "file" / "kept", ".kept", kPlenty};
    cache.keep({1, 2}, "one");
    EXPECT_FALSE(cache.find({1, 2}));
    fs::create_directory(folder / "folder.kept");
    keepWithin(folder.path(), ".kept", 0);
    EXPECT_TRUE(fs::exists(folder / "folder.kept"));
}

TEST(CacheFolder, forgetsWhatWasNotUsedForLongest)
{
    const TemporaryFolder folder;
    CacheFolder cache{folder.path(), ".kept", 3500};
    const auto ago = [&](const fs::path& file, int hours) {
        fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours{hours});
    };
    for (std::uint64_t i = 0; i < 3; ++i) {
        cache.keep({i, 0}, std::string(1000, 'a'));
        ago(cache.fileOf({i, 0}), 9 - int(i));
    }
    put(folder / "notes.txt", std::string(9000, 'n'));
    put(folder / "cut-off.kept.1-2.tmp", "half");
    put(folder / "being-written.kept.1-3.tmp", "half");
    ago(folder / "notes.txt", 99);
    ago(folder / "cut-off.kept.1-2.tmp", 2);
    EXPECT_TRUE(cache.find({0, 0})); // the oldest, but used
    cache.keep({3, 0}, std::string(1000, 'a'));
    EXPECT_TRUE(cache.find({0, 0}));
    EXPECT_FALSE(cache.find({1, 0}));
    EXPECT_TRUE(cache.find({2, 0}));
    EXPECT_TRUE(cache.find({3, 0}));
    EXPECT_TRUE(fs::exists(folder / "notes.txt")) << "no file of ours";
    EXPECT_TRUE(fs::exists(folder / "being-written.kept.1-3.tmp"));
    EXPECT_FALSE(fs::exists(folder / "cut-off.kept.1-2.tmp"));
}

} // namespace
} // namespace io
