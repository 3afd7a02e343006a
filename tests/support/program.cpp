#include "tests/support/program.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace test {
namespace fs = std::filesystem;
namespace {

void redirect(const fs::path& file, int flags, int to)
{
    const int descriptor = open(file.c_str(), flags, 0600);
    if (descriptor < 0) _exit(126);
    dup2(descriptor, to);
    close(descriptor);
}

[[noreturn]] void become(const std::vector<std::string>& words, const RunOptions& options, const fs::path& folder)
{
    redirect(folder / "in", O_RDONLY, STDIN_FILENO);
    redirect(folder / "out", O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
    redirect(folder / "err", O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
    for (const auto& [name, value] : options.environment)
        value.empty() ? unsetenv(name.c_str()) : setenv(name.c_str(), value.c_str(), 1);
    const rlimit noCore{0, 0};
    setrlimit(RLIMIT_CORE, &noCore);
    std::vector<char*> arguments;
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

// Slow builds are given more time.
int patience()
{
    const char* times = std::getenv("WOLD_TEST_PATIENCE");
    return times ? std::max(1, std::atoi(times)) : 1;
}

// False when the time was up.
bool waitFor(pid_t child, int seconds, int& status)
{
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{seconds * patience()};
    while (waitpid(child, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > end) {
            kill(child, SIGKILL);
            waitpid(child, &status, 0);
            return false;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds{5});
    }
    return true;
}

} // namespace

std::string Ran::lastError() const
{
    const auto lines = linesOf(err);
    return lines.empty() ? "" : lines.back();
}

Ran run(const std::vector<std::string>& words, const RunOptions& options)
{
    const Folder folder;
    folder.write("in", options.input);
    const pid_t child = fork();
    if (child == 0) become(words, options, folder.path());
    Ran ran;
    int status = 0;
    if (waitFor(child, options.seconds, status) && WIFEXITED(status)) ran.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) ran.signal = WTERMSIG(status);
    ran.out = textOf(folder.path() / "out");
    ran.err = textOf(folder.path() / "err");
    return ran;
}

Folder::Folder()
{
    std::string name = (fs::temp_directory_path() / "wold-test-XXXXXX").string();
    if (mkdtemp(name.data())) m_path = name;
}

Folder::~Folder()
{
    std::error_code ignored;
    if (!m_path.empty()) fs::remove_all(m_path, ignored);
}

std::string Folder::write(std::string_view name, std::string_view text) const
{
    const fs::path file = m_path / name;
    fs::create_directories(file.parent_path());
    std::ofstream{file, std::ios::binary} << text;
    return file.string();
}

std::string textOf(const fs::path& file)
{
    std::ostringstream text;
    text << std::ifstream{file, std::ios::binary}.rdbuf();
    return text.str();
}

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream{text};
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

} // namespace test
