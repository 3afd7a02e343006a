#include "io/files/file_reader.h"

#include "io/files/disk.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace io {

Result<FileReader> FileReader::open(const std::filesystem::path& file)
{
    // Not blocking: opening a pipe that nobody writes to would wait for ever.
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) return disk::fault(file, "cannot be opened");
    FileReader reader{descriptor, 0};
    struct stat about = {};
    if (::fstat(descriptor, &about) != 0) return disk::fault(file, "cannot be read");
    if (!S_ISREG(about.st_mode)) return Error{file.string(), "is not a regular file"};
    reader.m_size = std::uint64_t(about.st_size);
    return reader;
}

FileReader::~FileReader()
{
    if (m_descriptor >= 0) ::close(m_descriptor);
}

std::size_t FileReader::read(void* to, std::size_t bytes)
{
    std::size_t done = 0;
    while (done < bytes) {
        const ssize_t count = ::read(m_descriptor, static_cast<char*>(to) + done, bytes - done);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) break;
        done += std::size_t(count);
    }
    return done;
}

bool FileReader::skip(std::uint64_t bytes)
{
    const off_t at = ::lseek(m_descriptor, 0, SEEK_CUR);
    if (at < 0 || bytes > m_size - std::min(m_size, std::uint64_t(at))) return false;
    return ::lseek(m_descriptor, off_t(bytes), SEEK_CUR) >= 0;
}

std::string FileReader::start(std::size_t bytes) const
{
    std::string start(bytes, '\0');
    const ssize_t count = ::pread(m_descriptor, start.data(), bytes, 0);
    start.resize(count < 0 ? 0 : std::size_t(count));
    return start;
}

} // namespace io
