// Writing files so that a crash, a full disk or a pulled plug leaves old or new, each whole.
#pragma once

#include "io/base/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace io {

// Several files written as one: temporaries beside their targets, fsync, a commit record that lists the renames,
// the renames, fsync of the folders, the record removed. Files whose bytes did not change are not written.
class FileTransaction {
public:
    explicit FileTransaction(std::filesystem::path folder) : m_folder{std::move(folder)} {}
    void add(std::filesystem::path file, std::string bytes); // inside the folder
    struct Report {
        std::vector<std::filesystem::path> written;
        std::uint64_t bytes = 0;
    };
    Result<Report> commit();

private:
    struct Item {
        std::filesystem::path file;
        std::string bytes;
    };
    std::filesystem::path m_folder;
    std::vector<Item> m_items;
};

// Finishes the renames of a transaction that was cut off after its commit record, or drops its temporaries.
Status recoverTransactions(const std::filesystem::path& folder);

Status writeFile(const std::filesystem::path& file, std::string_view bytes); // one file, atomically
Result<std::string> readFile(const std::filesystem::path& file, std::uint64_t limit = std::uint64_t(1) << 30); // regular files only

} // namespace io
