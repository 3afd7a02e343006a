#include "editor/text.h"

#include "io/base/log.h"

#include <map>
#include <set>

namespace editor {
namespace {

struct Texts {
    std::map<std::string, std::string, std::less<>> byKey;
    std::set<std::string, std::less<>> missing;
};

Texts& texts()
{
    static Texts t;
    return t;
}

void addCategory(Texts& into, const std::string& category, const io::Value& entries)
{
    const io::Value::Object* object = entries.asObject();
    if (!object) return;
    for (const auto& [key, text] : *object)
        if (const std::string* s = text.asString()) into.byKey[category + "." + key] = *s;
}

} // namespace

void setTexts(const io::Value& language)
{
    texts() = {};
    const io::Value::Object* categories = language.asObject();
    if (!categories) return;
    for (const auto& [category, entries] : *categories)
        addCategory(texts(), category, entries);
}

const char* tr(const char* key)
{
    const auto found = texts().byKey.find(std::string_view{key});
    if (found != texts().byKey.end()) return found->second.c_str();
    const auto [place, added] = texts().missing.emplace(key);
    if (added) io::log::debug("no text for {} in this language", key);
    return place->c_str();
}

const char* tr(const std::string& key)
{
    return tr(key.c_str());
}

bool hasText(std::string_view key)
{
    return texts().byKey.contains(key);
}

std::string trFormatted(const char* key, fmt::format_args arguments)
{
    const char* text = tr(key);
    try {
        return fmt::vformat(text, arguments);
    } catch (const fmt::format_error& fault) {
        if (texts().missing.emplace(key).second) io::log::warning("text {}: {}: \"{}\"", key, fault.what(), text);
        return text;
    }
}

std::vector<std::string> missingTexts()
{
    return {texts().missing.begin(), texts().missing.end()};
}

} // namespace editor
