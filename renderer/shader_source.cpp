#include "renderer/shader_source.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <sstream>

namespace renderer {
namespace fs = std::filesystem;
namespace {

std::optional<std::string> textOf(const fs::path& file)
{
    std::ifstream in{file, std::ios::binary};
    if (!in) return std::nullopt;
    std::ostringstream text;
    text << in.rdbuf();
    return std::move(text).str();
}

// The name between quotes of an #include line; empty for any other line.
std::string_view included(std::string_view line)
{
    const std::size_t start = line.find_first_not_of(" \t");
    if (start == std::string_view::npos || line.substr(start, 8) != "#include") return {};
    const std::size_t open = line.find('"');
    const std::size_t close = open == std::string_view::npos ? open : line.find('"', open + 1);
    return close == std::string_view::npos ? std::string_view{} : line.substr(open + 1, close - open - 1);
}

class Reader {
public:
    Reader(const fs::path& folder, ShaderSource& out) : m_folder{folder}, m_out{out} {}

    io::Status add(const fs::path& file)
    {
        const std::optional<std::string> text = textOf(file);
        if (!text) return io::Error{file.string(), "cannot be read; is the installation complete?"};
        const std::size_t number = m_out.files.size();
        m_out.files.push_back(file);
        m_out.text += fmt::format("#line 1 {}\n", number);

        std::istringstream lines{*text};
        int at = 0;
        for (std::string line; std::getline(lines, line);) {
            ++at;
            const std::string_view name = included(line);
            if (name.empty()) {
                m_out.text += line + '\n';
                continue;
            }
            if (io::Status status = include(file, name, at); !status) return status;
            m_out.text += fmt::format("#line {} {}\n", at + 1, number);
        }
        return {};
    }

private:
    io::Status include(const fs::path& from, std::string_view name, int line)
    {
        std::error_code ignored;
        fs::path file = (from.parent_path() / name).lexically_normal();
        if (!fs::exists(file, ignored)) file = (m_folder / name).lexically_normal();
        if (std::ranges::find(m_out.files, file) != m_out.files.end()) return {};
        if (!fs::exists(file, ignored))
            return io::Error{fmt::format("{}:{}", from.string(), line), fmt::format("no such file: {}", name)};
        return add(file);
    }

    const fs::path& m_folder;
    ShaderSource& m_out;
};

// A number at the start of `text`, which it is taken off.
std::optional<int> number(std::string_view& text)
{
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{}) return std::nullopt;
    text.remove_prefix(std::size_t(end - text.data()));
    return value;
}

} // namespace

io::Result<ShaderSource> readShader(const fs::path& folder, std::string_view name, std::span<const std::string> defines)
{
    ShaderSource source;
    source.text = "#version 450 core\n";
    for (const std::string& define : defines)
        source.text += "#define " + define + "\n";
    if (io::Status status = Reader{folder, source}.add((folder / name).lexically_normal()); !status)
        return status.error();
    return source;
}

std::string placeOf(const ShaderSource& source, std::string_view log)
{
    for (std::size_t i = 0; i < log.size(); ++i) {
        if (i > 0 && log[i - 1] != '\n' && log[i - 1] != ' ') continue;
        std::string_view rest = log.substr(i);
        const std::optional<int> file = number(rest);
        if (!file || rest.empty() || (rest[0] != ':' && rest[0] != '(')) continue;
        rest.remove_prefix(1);
        const std::optional<int> line = number(rest);
        if (line && *file >= 0 && std::size_t(*file) < source.files.size())
            return fmt::format("{}:{}", source.files[std::size_t(*file)].string(), *line);
    }
    return source.files.empty() ? std::string{} : source.files.front().string();
}

} // namespace renderer
