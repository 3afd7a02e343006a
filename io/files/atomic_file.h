// Writing files so that a crash, a full disk or a pulled plug leaves old or new, each whole.
#pragma once

#include "io/base/result.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace io {

// Which bytes a file held: 64 bit FNV-1a, the same on every machine.
std::uint64_t fingerprint(std::string_view bytes);

// Several files written as one: temporaries beside their targets, fsync, a commit record that lists the renames and
// removals, those done, fsync of the folders, the record removed. Files whose bytes did not change are not written.
class FileTransaction {
public:
    explicit FileTransaction(std::filesystem::path folder) : m_folder{std::move(folder)} {}
    void add(std::string file, std::string bytes); // relative to the folder, inside it
    void remove(std::string file, std::uint64_t fingerprint); // only if it is that file still, and no link
    struct Report {
        std::vector<std::filesystem::path> written; // relative to the folder
        std::vector<std::filesystem::path> removed;
        std::vector<std::filesystem::path> kept; // that should have gone, but hold other bytes now
        std::uint64_t bytes = 0;
    };
    // `before` is told each step that touches the disk, so that a test can cut the work there.
    Result<Report> commit(const std::function<void(std::string_view step)>& before = {});

private:
    struct Item {
        std::string file;
        std::string bytes;
    };
    struct Removal {
        std::string file;
        std::uint64_t fingerprint;
    };
    std::filesystem::path m_folder;
    std::vector<Item> m_items;
    std::vector<Removal> m_removals;
};

// Finishes the renames and removals of a transaction that was cut off after its commit record, and drops the temporaries of
// one that was cut off before. Leaves those of another process that still runs alone.
Status recoverTransactions(const std::filesystem::path& folder);

Status writeFile(const std::filesystem::path& file, std::string_view bytes); // one file, atomically; makes its folder
Result<std::string> readFile(const std::filesystem::path& file,
                             std::uint64_t limit = std::uint64_t(1) << 30); // regular files only

} // namespace io
