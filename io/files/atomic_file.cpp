#include "io/files/atomic_file.h"

#include "io/base/paths.h"
#include "io/files/disk.h"
#include "io/files/file_reader.h"
#include "io/files/json.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <set>
#include <sys/stat.h>
#include <unistd.h>

namespace io {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kRecord = ".wold-commit";
constexpr std::string_view kTemporary = ".wold-tmp"; // ends the name of every temporary: .NAME.PID-N.wold-tmp

fs::path temporaryFor(const fs::path& target)
{
    static std::atomic<int> count{0};
    return target.parent_path() / ("." + target.filename().string() + "." + std::to_string(::getpid()) + "-" +
                                   std::to_string(++count) + std::string{kTemporary});
}

bool isTemporary(const fs::path& file)
{
    const std::string name = file.filename().string();
    return name.starts_with('.') && name.ends_with(kTemporary);
}

// Whether the process that made a temporary is another one and still at work.
bool ownerRuns(const fs::path& temporary)
{
    std::string name = temporary.filename().string();
    name.resize(name.size() - kTemporary.size());
    const std::size_t dot = name.rfind('.');
    int pid = 0;
    std::from_chars(name.data() + dot + 1, name.data() + name.size(), pid);
    return pid > 0 && pid != ::getpid() && (::kill(pid, 0) == 0 || errno == EPERM);
}

struct Step { // a rename of `temporary`, or without one a removal
    fs::path temporary;
    fs::path target;
    std::uint64_t fingerprint = 0; // of what is removed
};

// The temporaries of a transaction that has not been committed; dropped when it fails.
class Temporaries {
public:
    ~Temporaries()
    {
        std::error_code ignored;
        for (const Step& step : steps)
            fs::remove(step.temporary, ignored);
    }
    void keep() { steps.clear(); }
    std::vector<Step> steps;
};

std::string recordText(const fs::path& folder, const std::vector<Step>& steps)
{
    Value::Array renames, removals;
    for (const Step& step : steps) {
        std::string target = step.target.lexically_relative(folder).string();
        if (step.temporary.empty())
            removals.push_back(Value::Array{std::move(target), std::to_string(step.fingerprint)});
        else
            renames.push_back(Value::Array{step.temporary.lexically_relative(folder).string(), std::move(target)});
    }
    return writeJson(Value::Object{{"format", "wold-commit"},
                                   {"version", 1},
                                   {"renames", std::move(renames)},
                                   {"removals", std::move(removals)}}) +
           "\n";
}

Status syncFolders(const std::vector<Step>& steps)
{
    std::set<fs::path> folders;
    for (const Step& step : steps)
        folders.insert(step.target.parent_path());
    for (const fs::path& folder : folders)
        if (Status done = disk::syncFolder(folder); !done) return done;
    return {};
}

bool holds(const fs::path& file, std::string_view bytes)
{
    Result<FileReader> reader = FileReader::open(file);
    if (!reader || reader->size() != bytes.size()) return false;
    std::string part(std::size_t(1) << 20, '\0'); // a map may be large: the file is never in memory as a whole
    while (!bytes.empty()) {
        const std::size_t size = std::min(part.size(), bytes.size());
        if (reader->read(part.data(), size) != size || bytes.substr(0, size) != std::string_view{part}.substr(0, size)) return false;
        bytes.remove_prefix(size);
    }
    return true;
}

enum class Found { Nothing, Other, Same };

Found look(const fs::path& file, std::uint64_t expected)
{
    std::error_code error;
    const fs::file_status status = fs::symlink_status(file, error);
    if (!fs::exists(status)) return Found::Nothing;
    const Result<std::string> bytes = fs::is_regular_file(status) ? readFile(file) : Result<std::string>{Error{}};
    return bytes && fingerprint(*bytes) == expected ? Found::Same : Found::Other;
}

// Renames what is there to be renamed and removes what is still the file that was meant: can be done again after a cut.
Status carryOut(const Step& step)
{
    std::error_code error;
    if (!step.temporary.empty())
        return fs::exists(step.temporary, error) ? disk::rename(step.temporary, step.target) : Status{};
    if (look(step.target, step.fingerprint) != Found::Same) return {};
    fs::remove(step.target, error);
    return error ? Status{Error{step.target.string(), "cannot be removed: " + error.message()}} : Status{};
}

// A record comes from a folder that anyone may have made: it may rename only our temporaries, in place, and remove only
// what it can say the bytes of.
Result<Step> stepOf(const fs::path& folder, const Value& rename)
{
    const Value::Array* names = rename.asArray();
    const std::string* from = names && names->size() == 2 ? (*names)[0].asString() : nullptr;
    const std::string* to = names && names->size() == 2 ? (*names)[1].asString() : nullptr;
    const Error damaged{(folder / kRecord).string(), "a damaged record of an unfinished save; remove it"};
    if (!from || !to) return damaged;
    Result<fs::path> temporary = insideFolder(folder, *from);
    Result<fs::path> target = insideFolder(folder, *to);
    if (!temporary) return temporary.error();
    if (!target) return target.error();
    if (!isTemporary(*temporary) || temporary->parent_path() != target->parent_path()) return damaged;
    return Step{.temporary = *temporary, .target = *target};
}

Result<Step> removalOf(const fs::path& folder, const Value& removal)
{
    const Value::Array* pair = removal.asArray();
    const std::string* file = pair && pair->size() == 2 ? (*pair)[0].asString() : nullptr;
    const std::string* digits = pair && pair->size() == 2 ? (*pair)[1].asString() : nullptr;
    std::uint64_t bytes = 0;
    if (!file || !digits ||
        std::from_chars(digits->data(), digits->data() + digits->size(), bytes).ec != std::errc{})
        return Error{(folder / kRecord).string(), "a damaged record of an unfinished save; remove it"};
    const Result<fs::path> target = insideFolder(folder, *file);
    if (!target) return target.error();
    return Step{.temporary = {}, .target = folder / fs::path{*file}, .fingerprint = bytes};
}

Status finishRecord(const fs::path& folder)
{
    const fs::path record = folder / kRecord;
    std::error_code error;
    if (!fs::exists(record, error)) return {};
    const Result<std::string> text = readFile(record);
    if (!text) return text.error();
    const Result<Value> value = parseJson(*text, record.string());
    if (!value) return value.error();
    const Value* renames = value->find("renames");
    if (!renames || !renames->asArray())
        return Error{record.string(), "a damaged record of an unfinished save; remove it"};

    std::vector<Step> steps;
    for (const Value& rename : *renames->asArray()) {
        Result<Step> step = stepOf(folder, rename);
        if (!step) return step.error();
        steps.push_back(std::move(*step));
    }
    const Value* removals = value->find("removals");
    for (const Value& removal : removals && removals->asArray() ? *removals->asArray() : Value::Array{}) {
        Result<Step> step = removalOf(folder, removal);
        if (!step) return step.error();
        steps.push_back(std::move(*step));
    }
    for (const Step& step : steps)
        if (Status done = carryOut(step); !done) return done;
    if (Status done = syncFolders(steps); !done) return done;
    fs::remove(record, error);
    return error ? Status{Error{record.string(), "cannot be removed: " + error.message()}} : disk::syncFolder(folder);
}

void dropTemporaries(const fs::path& folder)
{
    std::error_code error;
    fs::recursive_directory_iterator entry{folder, fs::directory_options::skip_permission_denied, error};
    std::vector<fs::path> left;
    for (; !error && entry != fs::recursive_directory_iterator{}; entry.increment(error)) {
        std::error_code ignored;
        const bool hiddenFolder = entry->is_directory(ignored) && entry->path().filename().string().starts_with('.');
        if (hiddenFolder) entry.disable_recursion_pending(); // .git may be large and is not ours
        if (!entry->is_symlink(ignored) && entry->is_regular_file(ignored) && isTemporary(entry->path()) &&
            !ownerRuns(entry->path()))
            left.push_back(entry->path());
    }
    for (const fs::path& file : left)
        fs::remove(file, error);
}

Result<std::string> readAll(int descriptor, const fs::path& file, std::uint64_t size)
{
    std::string bytes(size, '\0');
    std::size_t got = 0;
    while (got < bytes.size()) {
        const ssize_t count = ::read(descriptor, bytes.data() + got, bytes.size() - got);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return disk::fault(file, "cannot be read");
        if (count == 0) break;
        got += std::size_t(count);
    }
    bytes.resize(got);
    return bytes;
}

} // namespace

std::uint64_t fingerprint(std::string_view bytes)
{
    std::uint64_t hash = 14695981039346656037u;
    for (const char byte : bytes)
        hash = (hash ^ std::uint8_t(byte)) * 1099511628211u;
    return hash;
}

void FileTransaction::remove(std::string file, std::uint64_t fingerprint)
{
    m_removals.push_back({std::move(file), fingerprint});
}

void FileTransaction::add(std::string file, std::string bytes)
{
    m_items.push_back({std::move(file), std::move(bytes)});
}

Result<FileTransaction::Report> FileTransaction::commit(const std::function<void(std::string_view)>& before)
{
    const auto tell = [&](std::string_view step) {
        if (before) before(step);
    };
    if (Status made = disk::makeFolders(m_folder); !made) return made.error();
    const fs::path folder = fs::canonical(m_folder);
    if (Status finished = finishRecord(folder); !finished) return finished.error(); // of an earlier save that failed
    Report report;
    Temporaries temporaries;
    for (const Item& item : m_items) {
        const Result<fs::path> target = insideFolder(folder, item.file);
        if (!target) return target.error();
        if (holds(*target, item.bytes)) continue;
        if (Status made = disk::makeFolders(target->parent_path()); !made) return made.error();
        const Step& step =
            temporaries.steps.emplace_back(Step{.temporary = temporaryFor(*target), .target = *target});
        tell("temporary");
        if (Status written = disk::writeAndSync(step.temporary, item.bytes, step.target); !written)
            return written.error();
        report.written.emplace_back(item.file);
        report.bytes += item.bytes.size();
    }
    for (const Removal& removal : m_removals) {
        const Result<fs::path> target = insideFolder(folder, removal.file);
        if (!target) return target.error();
        const fs::path file = folder / removal.file; // the name itself, not what a link of that name leads to
        const Found found = look(file, removal.fingerprint);
        if (found == Found::Other) report.kept.emplace_back(removal.file);
        if (found != Found::Same) continue;
        temporaries.steps.push_back({.temporary = {}, .target = file, .fingerprint = removal.fingerprint});
        report.removed.emplace_back(removal.file);
    }
    if (temporaries.steps.empty()) return report;

    if (Status synced = syncFolders(temporaries.steps); !synced) return synced.error();
    const fs::path record = folder / kRecord;
    const fs::path draft = temporaryFor(record);
    tell("draft of the record");
    if (Status written = disk::writeAndSync(draft, recordText(folder, temporaries.steps), {}); !written) {
        std::error_code ignored;
        fs::remove(draft, ignored);
        return written.error();
    }
    tell("record");
    if (Status renamed = disk::rename(draft, record); !renamed) return renamed.error();
    // From here the new files are the truth: what fails now is finished when the project is opened next.
    const std::vector<Step> steps = std::exchange(temporaries.steps, {});
    if (Status synced = disk::syncFolder(folder); !synced) return synced.error();
    for (const Step& step : steps) {
        tell(step.temporary.empty() ? "removal" : "rename");
        if (Status done = carryOut(step); !done) return done.error();
    }
    tell("sync");
    if (Status synced = syncFolders(steps); !synced) return synced.error();
    tell("end");
    std::error_code error;
    fs::remove(record, error);
    if (error) return Error{record.string(), "cannot be removed: " + error.message()};
    return report;
}

Status recoverTransactions(const fs::path& folder)
{
    std::error_code error;
    const fs::path whole = fs::canonical(folder, error);
    if (error) return Error{folder.string(), "cannot be opened: " + error.message()};
    if (Status finished = finishRecord(whole); !finished) return finished;
    dropTemporaries(whole);
    return {};
}

Status writeFile(const fs::path& file, std::string_view bytes)
{
    std::error_code error;
    // Absolute first, so that a bare name has a folder; canonical, so that a link keeps pointing at what is written.
    const fs::path target = fs::weakly_canonical(fs::absolute(file), error);
    if (error) return Error{file.string(), "cannot be resolved: " + error.message()};
    if (holds(target, bytes)) return {};
    if (Status made = disk::makeFolders(target.parent_path()); !made) return made;
    const fs::path temporary = temporaryFor(target);
    Status done = disk::writeAndSync(temporary, bytes, target);
    if (done) done = disk::rename(temporary, target);
    if (!done) {
        fs::remove(temporary, error);
        return done;
    }
    return disk::syncFolder(target.parent_path());
}

Result<std::string> readFile(const fs::path& file, std::uint64_t limit)
{
    // Not blocking: opening a pipe that nobody writes to would wait for ever.
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) return disk::fault(file, "cannot be opened");
    Result<std::string> bytes = [&]() -> Result<std::string> {
        struct stat about = {};
        if (::fstat(descriptor, &about) != 0) return disk::fault(file, "cannot be read");
        if (!S_ISREG(about.st_mode)) return Error{file.string(), "is not a regular file"};
        if (std::uint64_t(about.st_size) > limit)
            return Error{file.string(),
                         "is too large: " + std::to_string(about.st_size) + " bytes, at most " + std::to_string(limit)};
        return readAll(descriptor, file, std::uint64_t(about.st_size));
    }();
    ::close(descriptor);
    return bytes;
}

} // namespace io
