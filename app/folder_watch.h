// FolderWatch: tells when a file under a folder was written, made or removed, by looking at times.
#pragma once

#include <cstdint>
#include <filesystem>

namespace app {

class FolderWatch {
public:
    explicit FolderWatch(std::filesystem::path folder) : m_folder{std::move(folder)}, m_state{state()} {}
    bool changed(); // since the last call

private:
    std::uint64_t state() const;

    std::filesystem::path m_folder;
    std::uint64_t m_state;
};

} // namespace app
