// A file read from its beginning to its end without ever being in memory as a whole.
#pragma once

#include "io/base/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

namespace io {

class FileReader {
public:
    static Result<FileReader> open(const std::filesystem::path& file); // regular files only
    FileReader(FileReader&& other) noexcept : m_descriptor{std::exchange(other.m_descriptor, -1)}, m_size{other.m_size} {}
    FileReader& operator=(FileReader&& other) noexcept
    {
        std::swap(m_descriptor, other.m_descriptor);
        std::swap(m_size, other.m_size);
        return *this;
    }
    ~FileReader();

    std::uint64_t size() const { return m_size; } // bytes
    std::size_t read(void* to, std::size_t bytes); // how many there were; fewer at the end and after a fault
    bool skip(std::uint64_t bytes);
    std::string start(std::size_t bytes) const; // the first ones, wherever the reader is

private:
    FileReader(int descriptor, std::uint64_t size) : m_descriptor{descriptor}, m_size{size} {}

    int m_descriptor;
    std::uint64_t m_size;
};

} // namespace io
