// Runs a program from outside, as a person or another tool would, and keeps what it said.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace test {

struct Ran {
    int code = -1; // exit code; -1 when a signal or the time limit ended it
    int signal = 0;
    std::string out, err;

    std::string lastError() const; // last line of stderr
};

struct RunOptions {
    std::string input;                                            // stdin
    std::vector<std::pair<std::string, std::string>> environment; // added; an empty value removes
    int seconds = 120;
};

Ran run(const std::vector<std::string>& words, const RunOptions& options = {});

// A folder of its own that goes away with the object.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path& path() const { return m_path; }
    std::string operator/(std::string_view name) const { return (m_path / name).string(); }
    std::string write(std::string_view name, std::string_view text) const; // answers the file's path

private:
    std::filesystem::path m_path;
};

std::string textOf(const std::filesystem::path& file);
std::vector<std::string> linesOf(const std::string& text);

} // namespace test
