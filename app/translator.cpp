#include "app/translator.h"

#include "editor/text.h"
#include "io/base/log.h"
#include "io/base/paths.h"
#include "io/files/atomic_file.h"
#include "io/files/json.h"

#include <algorithm>
#include <cctype>

namespace app {
namespace fs = std::filesystem;
namespace {

constexpr const char* kFolder = "app/lang";

io::Result<io::Value> readLanguage(const std::string& code)
{
    const fs::path file = io::resource(kFolder) / (code + ".json");
    auto bytes = io::readFile(file, 1 << 24);
    if (!bytes) return bytes.error();
    return io::parseJson(*bytes, file.string());
}

struct BuiltIn {
    const char* code;
    const char* const& json;
};
const BuiltIn kBuiltIn[]{{"en", kEnglish}, {"cs", kCzech}};

void writeWhereMissing()
{
    for (const BuiltIn& language : kBuiltIn) {
        const fs::path file = io::resource(kFolder) / (std::string{language.code} + ".json");
        std::error_code ignored;
        if (fs::exists(file, ignored)) continue;
        fs::create_directories(file.parent_path(), ignored);
        if (const io::Status written = io::writeFile(file, language.json); written) io::log::info("{}: was missing and is written anew", file.string());
        else io::log::warning("{}; its texts are those that were built in", written.error().text());
    }
}

// Of a file that cannot be read, or could not be written.
io::Result<io::Value> textsOf(const std::string& code)
{
    auto own = readLanguage(code);
    std::error_code ignored;
    const bool there = fs::exists(io::resource(kFolder) / (code + ".json"), ignored);
    if (own || (there && code != "en")) return own;
    if (there) io::log::warning("{}; the texts are those that were built in", own.error().text());
    const auto* found = std::ranges::find_if(kBuiltIn, [&](const BuiltIn& language) { return language.code == code; });
    return found == std::end(kBuiltIn) ? own : io::parseJson(found->json, code);
}

std::string ownName(const io::Value& language, const std::string& code)
{
    constexpr std::string_view kKey = "language.name";
    constexpr std::size_t kDot = kKey.find('.');
    const io::Value* category = language.find(kKey.substr(0, kDot));
    const io::Value* name = category ? category->find(kKey.substr(kDot + 1)) : nullptr;
    return name && name->asString() ? *name->asString() : code;
}

// Texts of `over` on top of those of `under`, category by category.
io::Value merged(io::Value under, const io::Value& over)
{
    if (!over.asObject()) return under;
    for (const auto& [category, texts] : *over.asObject())
        if (texts.asObject())
            for (const auto& [key, text] : *texts.asObject())
                if (io::Value& into = under[category]; into.isNull() || into.asObject()) into[key] = text;
    return under;
}

bool isCode(const std::string& code)
{
    return !code.empty() && code.size() < 16 &&
           std::ranges::all_of(code, [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
}

} // namespace

std::vector<editor::Language> languages()
{
    std::vector<editor::Language> result;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator{io::resource(kFolder), ignored}) {
        const std::string code = entry.path().stem().string();
        if (entry.path().extension() != ".json") continue;
        if (const auto language = readLanguage(code)) result.push_back({code, ownName(*language, code)});
    }
    std::ranges::sort(result, {}, &editor::Language::code);
    return result;
}

io::Status useLanguage(const std::string& code)
{
    if (!isCode(code)) return io::Error{code, "is no name of a language"};
    writeWhereMissing();
    auto english = textsOf("en");
    if (!english) return english.error();
    if (code == "en") return editor::setTexts(*english), io::Status{};
    const auto chosen = textsOf(code);
    if (!chosen) return chosen.error();
    editor::setTexts(merged(*std::move(english), *chosen));
    return {};
}

} // namespace app
