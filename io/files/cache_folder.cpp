#include "io/files/cache_folder.h"

#include "io/base/log.h"
#include "io/files/atomic_file.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>
#include <vector>

namespace io {
namespace fs = std::filesystem;
namespace {

constexpr char kMagic[8] = {'W', 'O', 'L', 'D', 'K', 'E', 'P', 'T'};
constexpr std::string_view kTemporary = ".tmp";
constexpr auto kAbandoned = std::chrono::hours{1};
constexpr auto kFresh = std::chrono::hours{1}; // marked since then, it need not be marked again

struct Header {
    char magic[8];
    ContentKey key;
    ContentKey checksum; // of all that follows
};
static_assert(sizeof(Header) == 40, "written as bytes: no padding");

struct Kept {
    fs::path file;
    fs::file_time_type time;
    std::uintmax_t bytes;
};

} // namespace

bool putAside(const fs::path& file, std::string_view bytes)
{
    static std::atomic<unsigned> number{0};
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    const fs::path temporary = file.string() + fmt::format(".{}-{}{}", ::getpid(), number++, kTemporary);
    std::ofstream stream{temporary, std::ios::binary};
    stream.write(bytes.data(), std::streamsize(bytes.size()));
    stream.close();
    if (stream) fs::rename(temporary, file, error); // not flushed: a lost one is made again
    if (stream && !error) return true;
    std::error_code ignored;
    fs::remove(temporary, ignored);
    return false;
}

void markUsed(const fs::path& file)
{
    std::error_code ignored;
    const auto now = fs::file_time_type::clock::now();
    if (now - fs::last_write_time(file, ignored) > kFresh) fs::last_write_time(file, now, ignored);
}

void keepWithin(const fs::path& folder, std::string_view extension, std::uint64_t most)
{
    const auto now = fs::file_time_type::clock::now();
    std::vector<Kept> kept;
    std::uintmax_t total = 0;
    std::error_code error;
    for (fs::directory_iterator at{folder, error}, end; !error && at != end; at.increment(error)) {
        std::error_code gone; // others write and remove here too
        Kept one{at->path(), at->last_write_time(gone), at->file_size(gone)};
        if (gone || !at->is_regular_file(gone)) continue;
        if (one.file.extension() == kTemporary && now - one.time > kAbandoned) fs::remove(one.file, gone);
        if (one.file.extension() != extension) continue;
        total += one.bytes;
        kept.push_back(std::move(one));
    }
    std::ranges::sort(kept, {}, &Kept::time);
    for (const Kept& one : kept) {
        if (total <= most) break;
        fs::remove(one.file, error);
        total -= one.bytes;
    }
}

fs::path CacheFolder::fileOf(const ContentKey& key) const
{
    return m_folder / fmt::format("{:016x}{:016x}{}", key[0], key[1], m_extension);
}

std::optional<std::string> CacheFolder::find(const ContentKey& key)
{
    const fs::path file = fileOf(key);
    Result<std::string> bytes = readFile(file);
    if (!bytes) return std::nullopt;
    Header header{};
    const std::string_view rest = std::string_view{*bytes}.substr(std::min(sizeof header, bytes->size()));
    if (bytes->size() >= sizeof header) std::memcpy(&header, bytes->data(), sizeof header);
    if (std::memcmp(header.magic, kMagic, sizeof kMagic) != 0 || header.key != key ||
        header.checksum != contentKey(rest)) {
        log::debug("{}: damaged; what it held is made anew", file.string());
        return std::nullopt;
    }
    markUsed(file);
    bytes->erase(0, sizeof header);
    return *std::move(bytes);
}

void CacheFolder::keep(const ContentKey& key, const std::string& bytes)
{
    Header header{.key = key, .checksum = contentKey(bytes)};
    std::memcpy(header.magic, kMagic, sizeof kMagic);
    std::string file(reinterpret_cast<const char*>(&header), sizeof header);
    file += bytes;
    if (!putAside(fileOf(key), file))
        log::debug("{}: cannot be written; what it held is made again next time", fileOf(key).string());
    keepWithin(m_folder, m_extension, m_most);
}

} // namespace io
