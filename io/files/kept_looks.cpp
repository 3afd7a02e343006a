#include "io/files/kept_looks.h"

#include "io/base/paths.h"
#include "io/files/atomic_file.h"
#include "io/files/documents.h"
#include "io/scene/environment_presets.h"

#include <algorithm>

namespace io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 80; // bytes

// However it is written: on some disks, and to a person, "Dawn" is "dawn".
bool isPreset(std::string_view name)
{
    const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; };
    return std::ranges::any_of(enumNames(Preset{}), [&](std::string_view preset) { return std::ranges::equal(name, preset, {}, small); });
}

} // namespace

std::vector<std::string> KeptLooks::names() const
{
    std::vector<std::string> names;
    std::error_code fault;
    for (const fs::directory_entry& entry : fs::directory_iterator{m_folder, fault})
        if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

Result<fs::path> KeptLooks::fileOf(const std::string& name) const
{
    if (name.empty()) return Error{{}, "a look needs a name"};
    const bool plain = std::ranges::none_of(name, [](unsigned char c) { return c < ' ' || c == '/' || c == '\\'; });
    if (name.size() > kLongestName || name.front() == '.' || !plain)
        return Error{name, "is no name for a look: write up to 80 letters without / or \\, not beginning with a dot"};
    if (isPreset(name)) return Error{name, "is one of Wold's own looks: choose another name"};
    return m_folder / (name + ".json");
}

Result<Environment> KeptLooks::read(const std::string& name, Complaints& complaints) const
{
    const Result<fs::path> file = fileOf(name);
    if (!file) return file.error();
    Result<std::string> text = readFile(*file);
    if (!text) return text.error();
    return readEnvironmentText(*std::move(text), file->string(), complaints);
}

Status KeptLooks::save(const std::string& name, const Environment& look)
{
    const Result<fs::path> file = fileOf(name);
    if (!file) return file.error();
    return writeFile(*file, environmentText(look));
}

Status KeptLooks::remove(const std::string& name)
{
    const Result<fs::path> file = fileOf(name);
    if (!file) return file.error();
    std::error_code fault;
    if (fs::remove(*file, fault)) return {};
    return Error{file->string(), fault ? "cannot be removed: " + fault.message() : "is not there"};
}

Result<Environment> lookNamed(const std::string& name, const Environment& own, const KeptLooks& kept, Complaints& complaints)
{
    const auto presets = enumNames(Preset{});
    if (const auto at = std::ranges::find(presets, name); at != presets.end()) return withPreset(own, Preset(at - presets.begin()));
    const std::vector<std::string> names = kept.names();
    if (std::ranges::find(names, name) == names.end()) {
        std::string all;
        for (const std::string_view one : presets)
            all += (all.empty() ? "" : ", ") + std::string{one};
        for (const std::string& one : names)
            all += ", " + one;
        return Error{name, "is no look; there are " + all};
    }
    const Result<Environment> look = kept.read(name, complaints);
    if (!look) return look.error();
    return withLook(own, *look);
}

fs::path looksFolder()
{
    return configFolder() / "looks";
}

} // namespace io
