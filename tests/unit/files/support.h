// What tests of files share: a folder that goes away, the measured data, complaints as text.
#pragma once

#include "io/base/complaint.h"
#include "io/files/atomic_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace io {

namespace fs = std::filesystem;

class TemporaryFolder {
public:
    TemporaryFolder()
    {
        std::string pattern = (fs::temp_directory_path() / "wold-test-XXXXXX").string();
        m_path = fs::canonical(::mkdtemp(pattern.data()));
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder()
    {
        std::error_code ignored;
        fs::remove_all(m_path, ignored);
    }
    const fs::path& path() const { return m_path; }
    fs::path operator/(const std::string& name) const { return m_path / name; }

private:
    fs::path m_path;
};

inline void put(const fs::path& file, std::string_view bytes)
{
    const Status written = writeFile(file, bytes);
    ASSERT_TRUE(written) << written.error().text();
}

inline std::string get(const fs::path& file)
{
    const Result<std::string> bytes = readFile(file);
    return bytes ? *bytes : "(" + bytes.error().text() + ")";
}

inline std::string listed(const Complaints& complaints)
{
    std::string text;
    for (const Complaint& complaint : complaints)
        text += complaint.where + ": " + complaint.what + "\n";
    return text;
}

inline int errorsIn(const Complaints& complaints)
{
    int count = 0;
    for (const Complaint& complaint : complaints)
        count += complaint.severity == Severity::Error;
    return count;
}

// The measured data of the tests; empty when this machine has none.
inline fs::path testData()
{
    const char* set = std::getenv("WOLD_TEST_DATA");
    const fs::path folder = set ? set : "";
    return fs::exists(folder / "corpus") ? folder : fs::path{};
}

} // namespace io

#define NEEDS_TEST_DATA()                                                                                              \
    if (::io::testData().empty()) GTEST_SKIP() << "WOLD_TEST_DATA names no folder with the test data"
