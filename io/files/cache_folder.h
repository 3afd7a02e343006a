// Files that may be lost, as they are made again: in a folder that forgets those unused longest when it grows large.
#pragma once

#include "io/base/kept_bytes.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace io {

// Whole or not at all for whoever reads it; makes its folder. False where it cannot be written.
bool putAside(const std::filesystem::path& file, std::string_view bytes);

void markUsed(const std::filesystem::path& file); // to the hour

// Removes files of this extension, those written or used longest ago first, until the others have `most` bytes; and
// temporaries of putAside() that were left over an hour ago.
void keepWithin(const std::filesystem::path& folder, std::string_view extension, std::uint64_t most);

class CacheFolder : public KeptBytes {
public:
    // `extension` with its dot. A folder that cannot be used is no error.
    CacheFolder(std::filesystem::path folder, std::string extension, std::uint64_t most)
        : m_folder{std::move(folder)}, m_extension{std::move(extension)}, m_most{most}
    {
    }
    // Nothing where the file is damaged or another's. What is found is marked as used.
    std::optional<std::string> find(const ContentKey& key) override;
    void keep(const ContentKey& key, const std::string& bytes) override;
    std::filesystem::path fileOf(const ContentKey& key) const;

private:
    std::filesystem::path m_folder;
    std::string m_extension;
    std::uint64_t m_most; // bytes
};

} // namespace io
