#include "support.h"

#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <map>

namespace io {
namespace {

using Files = std::map<std::string, std::string>;

Files filesIn(const fs::path& folder)
{
    Files files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder})
        if (entry.is_regular_file()) files[entry.path().lexically_relative(folder).string()] = get(entry.path());
    return files;
}

const Files kOld = {{"project.json", "old project"},
                    {"scenes/a.json", "old scene"},
                    {"same.json", "same"},
                    {"templates/gone.json", "gone"}};
const Files kNew = {{"project.json", "new project"},
                    {"scenes/a.json", "new scene"},
                    {"same.json", "same"},
                    {"templates/t.json", "new"}};

void write(const fs::path& folder, const Files& files)
{
    for (const auto& [name, bytes] : files)
        put(folder / name, bytes);
}

FileTransaction transaction(const fs::path& folder, const Files& files)
{
    FileTransaction result{folder};
    for (const auto& [name, bytes] : files)
        result.add(name, bytes);
    result.remove("templates/gone.json", fingerprint("gone"));
    result.remove("templates/never.json", fingerprint("gone"));
    return result;
}

// Runs `work` in a process of its own and answers how that ended.
template <class Work> int inAnotherProcess(Work work)
{
    const pid_t child = ::fork();
    if (child == 0) {
        work();
        std::_Exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
}

TEST(FileTransaction, WritesOnlyWhatChanged)
{
    const TemporaryFolder folder;
    write(folder.path(), kOld);
    struct stat before = {}, after = {};
    ::stat((folder / "same.json").c_str(), &before);
    const Result<FileTransaction::Report> report = transaction(folder.path(), kNew).commit();
    ASSERT_TRUE(report);
    EXPECT_EQ(report->written.size(), 3u);
    EXPECT_EQ(report->bytes, std::string{"new projectnew scenenew"}.size());
    EXPECT_EQ(filesIn(folder.path()), kNew);
    ::stat((folder / "same.json").c_str(), &after);
    EXPECT_EQ(before.st_ino, after.st_ino);
    EXPECT_TRUE(transaction(folder.path(), kNew).commit()->written.empty());
}

// A power cut before any step leaves the old files or the new ones after recovery, never a mixture and no litter.
TEST(FileTransaction, IsOldOrNewWhereverItIsCut)
{
    bool sawOld = false, sawNew = false;
    for (int cut = 0; cut < 32; ++cut) {
        const TemporaryFolder folder;
        write(folder.path(), kOld);
        const int status = inAnotherProcess([&] {
            int step = 0;
            (void)transaction(folder.path(), kNew).commit([&](std::string_view) {
                if (step++ == cut) ::kill(::getpid(), SIGKILL);
            });
        });
        ASSERT_TRUE(recoverTransactions(folder.path()));
        const Files found = filesIn(folder.path());
        EXPECT_TRUE(found == kOld || found == kNew) << "cut before step " << cut;
        sawOld |= found == kOld;
        sawNew |= found == kNew;
        if (!WIFSIGNALED(status)) {
            EXPECT_EQ(found, kNew);
            EXPECT_GE(cut, 10); // steps: 3 temporaries, 2 of the record, 3 renames, 1 removal, 2 at the end
            break;
        }
    }
    EXPECT_TRUE(sawOld && sawNew);
}

TEST(FileTransaction, RecoveryRemovesOnlyWhatItsRecordMeant)
{
    const TemporaryFolder folder;
    write(folder.path(), kOld);
    inAnotherProcess([&] {
        (void)transaction(folder.path(), kNew).commit([&](std::string_view step) {
            if (step == "removal") ::kill(::getpid(), SIGKILL);
        });
    });
    put(folder / "templates/gone.json", "written after the cut");
    ASSERT_TRUE(recoverTransactions(folder.path()));
    Files expected = kNew;
    expected["templates/gone.json"] = "written after the cut";
    EXPECT_EQ(filesIn(folder.path()), expected);
}

TEST(FileTransaction, RecoveryThatIsCutIsFinishedByTheNext)
{
    const TemporaryFolder folder;
    write(folder.path(), kOld);
    inAnotherProcess([&] {
        (void)transaction(folder.path(), kNew).commit([&](std::string_view step) {
            if (step == "rename") ::kill(::getpid(), SIGKILL);
        });
    });
    // As if a first recovery had come as far as one rename.
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder.path()})
        if (entry.path().filename().string().starts_with(".project.json."))
            fs::rename(entry.path(), folder / "project.json");
    ASSERT_TRUE(recoverTransactions(folder.path()));
    EXPECT_EQ(filesIn(folder.path()), kNew);
    ASSERT_TRUE(recoverTransactions(folder.path()));
    EXPECT_EQ(filesIn(folder.path()), kNew);
}

TEST(FileTransaction, AFullDiskLeavesTheOldFiles)
{
    const TemporaryFolder folder;
    write(folder.path(), kOld);
    Files large = kNew;
    large["scenes/a.json"] = std::string(1 << 20, 'x');
    const int status = inAnotherProcess([&] {
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{4096, 4096};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        const Result<FileTransaction::Report> report = transaction(folder.path(), large).commit();
        std::_Exit(!report && report.error().what.find("cannot be written") != std::string::npos ? 7 : 8);
    });
    EXPECT_EQ(WEXITSTATUS(status), 7);
    EXPECT_EQ(filesIn(folder.path()), kOld);
}

TEST(FileTransaction, RefusesFilesOutside)
{
    const TemporaryFolder folder;
    for (const char* name : {"../x", "/tmp/x", "a/../../x", ""}) {
        FileTransaction outside{folder.path()};
        outside.add(name, "x");
        EXPECT_FALSE(outside.commit()) << name;
    }
    fs::create_directory_symlink("/tmp", folder / "link");
    FileTransaction linked{folder.path()};
    linked.add("link/x", "x");
    EXPECT_FALSE(linked.commit());
}

TEST(Recovery, RefusesARecordThatReachesOutside)
{
    const TemporaryFolder outer;
    const fs::path folder = outer / "project";
    put(outer / "victim.json", "mine");
    put(folder / ".evil.1-1.wold-tmp", "theirs");
    put(folder / "plain.txt", "plain");
    for (const char* renames : {R"([[".evil.1-1.wold-tmp","../victim.json"]])", R"([["../victim.json","stolen.json"]])",
                                R"([["plain.txt","other.txt"]])", R"([[1,2]])", R"("x")", R"([["a"]])",
                                R"([],"removals":[["plain.txt","x"]])", R"([],"removals":[["plain.txt"]])",
                                R"([],"removals":[["../victim.json","1"]])"}) {
        put(folder / ".wold-commit", std::string{R"({"renames":)"} + renames + "}");
        EXPECT_FALSE(recoverTransactions(folder)) << renames;
    }
    EXPECT_EQ(get(outer / "victim.json"), "mine");
    EXPECT_EQ(get(folder / "plain.txt"), "plain");
}

TEST(Recovery, LeavesTemporariesOfARunningProcess)
{
    const TemporaryFolder folder;
    const std::string running = ".a.json." + std::to_string(::getppid()) + "-1.wold-tmp";
    const std::string gone = ".a.json.999999999-1.wold-tmp";
    put(folder / running, "x");
    put(folder / gone, "x");
    ASSERT_TRUE(recoverTransactions(folder.path()));
    EXPECT_TRUE(fs::exists(folder / running));
    EXPECT_FALSE(fs::exists(folder / gone));
}

TEST(WriteFile, KeepsPermissionsAndFollowsLinks)
{
    const TemporaryFolder folder;
    put(folder / "real", "1");
    ::chmod((folder / "real").c_str(), 0600);
    fs::create_symlink("real", folder / "link");
    put(folder / "link", "2");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(get(folder / "real"), "2");
    struct stat about = {};
    ::stat((folder / "real").c_str(), &about);
    EXPECT_EQ(about.st_mode & 0777, 0600u);
}

TEST(WriteFile, TakesABareNameInTheCurrentFolder)
{
    const TemporaryFolder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder / "");
    const Status written = writeFile("picture.png", "bytes");
    fs::current_path(before);
    ASSERT_TRUE(written) << written.error().text();
    EXPECT_EQ(get(folder / "picture.png"), "bytes");
}

TEST(ReadFile, TakesOnlyRegularFilesUpToALimit)
{
    const TemporaryFolder folder;
    ::mkfifo((folder / "pipe").c_str(), 0600);
    EXPECT_NE(readFile(folder / "pipe").error().what.find("not a regular file"),
              std::string::npos); // and does not wait
    EXPECT_FALSE(readFile(folder.path()));
    EXPECT_FALSE(readFile("/dev/zero"));
    EXPECT_FALSE(readFile(folder / "missing"));
    put(folder / "file", "12345");
    EXPECT_FALSE(readFile(folder / "file", 4));
    EXPECT_EQ(get(folder / "file"), "12345");
}

} // namespace
} // namespace io
