#include "io/files/disk.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace io::disk {
namespace {

class Descriptor {
public:
    explicit Descriptor(int number) : m_number{number} {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor()
    {
        if (m_number >= 0) ::close(m_number);
    }
    int get() const { return m_number; }
    int release() { return std::exchange(m_number, -1); }

private:
    int m_number;
};

bool writeAll(int descriptor, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        bytes.remove_prefix(std::size_t(count));
    }
    return true;
}

bool sync(int descriptor)
{
    // Some file systems cannot flush a folder and say EINVAL: nothing more can be done there.
    return ::fsync(descriptor) == 0 || errno == EINVAL;
}

} // namespace

Error fault(const std::filesystem::path& file, std::string_view doing)
{
    return {file.string(), std::string{doing} + ": " + std::strerror(errno)};
}

Status writeAndSync(const std::filesystem::path& file, std::string_view bytes, const std::filesystem::path& like)
{
    const std::filesystem::path& named = like.empty() ? file : like; // a person knows no temporary
    Descriptor out{::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666)};
    if (out.get() < 0) return fault(named, "cannot be written");
    struct stat old = {};
    if (::stat(like.c_str(), &old) == 0 && ::fchmod(out.get(), old.st_mode & 07777) != 0)
        return fault(named, "cannot take its permissions");
    if (!writeAll(out.get(), bytes)) return fault(named, "cannot be written");
    if (!sync(out.get())) return fault(named, "cannot be flushed to the disk");
    if (::close(out.release()) != 0) return fault(named, "cannot be closed");
    return {};
}

Status rename(const std::filesystem::path& from, const std::filesystem::path& to)
{
    if (std::rename(from.c_str(), to.c_str()) != 0) return fault(to, "cannot be replaced");
    return {};
}

Status syncFolder(const std::filesystem::path& folder)
{
    const Descriptor opened{::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    if (opened.get() < 0 || !sync(opened.get())) return fault(folder, "cannot be flushed to the disk");
    return {};
}

Status makeFolders(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return Error{folder.string(), "the folder cannot be made: " + error.message()};
    return {};
}

} // namespace io::disk
