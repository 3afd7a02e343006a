#include "app/settings.h"

#include "io/base/log.h"
#include "io/base/paths.h"
#include "io/files/atomic_file.h"
#include "io/files/json.h"
#include "io/scene/field_words.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kRecent = 12;
constexpr std::uint64_t kLargest = 16 << 20; // bytes

io::Value defaults()
{
    return io::Value::Object{{"version", 1}, {"language", "en"}, {"quality", "auto"}, {"recent", io::Value::Array{}}};
}

std::string text(const io::Value& object, std::string_view key, std::string otherwise)
{
    const io::Value* value = object.find(key);
    return value && value->asString() ? *value->asString() : otherwise;
}

void setAside(const fs::path& file, const io::Error& error)
{
    fs::path bad = file;
    bad += ".bad";
    std::error_code failed;
    fs::rename(file, bad, failed);
    io::log::warning("{}; using the default settings{}", error.text(),
                     failed ? "" : ", the file is kept as " + bad.string());
}

io::Result<io::Value> read(const fs::path& file)
{
    auto bytes = io::readFile(file, kLargest);
    if (!bytes) return bytes.error();
    auto value = io::parseJson(*bytes, file.string());
    if (value && !value->asObject()) return io::Error{file.string() + ":1", "settings are one JSON object"};
    return value;
}

} // namespace

fs::path Settings::defaultFile()
{
    return io::configFolder() / "settings.json";
}

Settings Settings::load(const fs::path& file)
{
    Settings settings;
    settings.m_file = file;
    std::error_code ignored;
    if (fs::exists(file, ignored)) {
        auto value = read(file);
        if (value)
            settings.m_values = settings.m_saved = *std::move(value), settings.complain();
        else
            setAside(file, value.error());
    }
    if (settings.m_values.isNull()) {
        settings.m_values = defaults();
        settings.save();
    }
    return settings;
}

// They stay in the file, and the usual ones hold.
void Settings::complain() const
{
    const auto say = [&](const char* key, const char* wanted) { io::log::warning("{}: {}: {}; the usual one is used", m_file.string(), key, wanted); };
    const auto wrong = [](const io::Value* value, auto right) { return value && !value->isNull() && !right(*value); };
    const auto isText = [](const io::Value& value) { return value.asString() != nullptr; };
    const auto isNumber = [](const io::Value& value) { return value.asNumber() && std::isfinite(*value.asNumber()); };
    if (wrong(m_values.find("language"), isText)) say("language", "the code of a language is wanted, as \"en\"");
    if (wrong(m_values.find("quality"), [](const io::Value& value) { return value.asString() && qualityNamed(*value.asString()); })) say("quality", "auto, low, medium, high or ultra is wanted");
    if (wrong(m_values.find("recent"), [](const io::Value& value) { return value.asArray() != nullptr; })) say("recent", "a list of projects is wanted");
    const io::Value* ui = m_values.find("ui");
    if (wrong(ui, [](const io::Value& value) { return value.asObject() != nullptr; })) return say("ui", "an object is wanted");
    for (const char* key : {"scale", "frame_rate"})
        if (ui && wrong(ui->find(key), isNumber)) say((std::string{"ui."} + key).c_str(), "a number is wanted");
}

std::string Settings::language() const
{
    return text(m_values, "language", "en");
}

Quality Settings::quality() const
{
    return qualityNamed(text(m_values, "quality", "auto")).value_or(Quality::Auto);
}

std::vector<fs::path> Settings::recentProjects() const
{
    std::vector<fs::path> result;
    const io::Value* list = m_values.find("recent");
    if (list && list->asArray())
        for (const io::Value& item : *list->asArray())
            if (const std::string* name = item.asString()) result.emplace_back(*name);
    return result;
}

std::optional<double> Settings::ui(std::string_view key) const
{
    const io::Value* ui = m_values.find("ui");
    const io::Value* value = ui ? ui->find(key) : nullptr;
    const double* number = value ? value->asNumber() : nullptr;
    return number && std::isfinite(*number) ? std::optional{*number} : std::nullopt;
}

float Settings::uiScale() const
{
    return float(std::clamp(ui("scale").value_or(1), 0.5, 3.0));
}

double Settings::frameRate() const
{
    return std::clamp(ui("frame_rate").value_or(30), 5.0, 240.0);
}

io::Value Settings::editor() const
{
    const io::Value* value = m_values.find("editor");
    return value ? *value : io::Value{};
}

void Settings::setLanguage(const std::string& code)
{
    m_values["language"] = code;
}

void Settings::setUi(std::string_view key, io::Value value)
{
    io::Value& ui = m_values["ui"];
    if (!ui.asObject()) ui = io::Value::Object{};
    ui[key] = std::move(value);
}

void Settings::setUiScale(float scale)
{
    setUi("scale", io::decimal(scale));
}

void Settings::setFrameRate(double rate)
{
    setUi("frame_rate", rate);
}

void Settings::addRecentProject(const fs::path& project)
{
    std::error_code failed;
    const fs::path full = fs::weakly_canonical(project, failed);
    std::vector<fs::path> list = recentProjects();
    const fs::path& added = failed ? project : full;
    std::erase(list, added);
    list.insert(list.begin(), added);
    io::Value::Array names;
    for (std::size_t i = 0; i < std::min(list.size(), kRecent); ++i)
        names.emplace_back(list[i].string());
    m_values["recent"] = std::move(names);
}

void Settings::setEditor(const io::Value& value)
{
    m_values["editor"] = value;
}

void Settings::save()
{
    if (m_file.empty() || m_values == m_saved) return;
    std::error_code failed;
    if (m_file.has_parent_path()) fs::create_directories(m_file.parent_path(), failed);
    const io::Status written = io::writeFile(m_file, io::writeJson(m_values, 2) + "\n");
    if (!written) io::log::warning("settings are not kept: {}", written.error().text());
    m_saved = m_values; // also when it failed, so that it is said once
}

} // namespace app
