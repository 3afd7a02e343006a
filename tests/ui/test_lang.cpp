// The languages: both files hold exactly the texts that the window asks for.
#include "editor/scalars.h"
#include "editor/text.h"
#include "io/files/atomic_file.h"
#include "io/files/json.h"
#include "io/files/usual_controls.h"
#include "io/scene/environment_presets.h"
#include "renderer/renderer.h"
#include "tests/ui/support/rig.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <regex>
#include <set>

namespace {

namespace fs = std::filesystem;
using Keys = std::set<std::string>;

io::Value language(const std::string& code)
{
    const std::string file = WOLD_SOURCE_DIR "/app/lang/" + code + ".json";
    const auto text = io::readFile(file);
    EXPECT_TRUE(text);
    auto value = io::parseJson(*text, file);
    EXPECT_TRUE(value);
    return *value;
}

std::map<std::string, std::string> textsOf(const std::string& code)
{
    std::map<std::string, std::string> texts;
    const io::Value all = language(code);
    for (const auto& [category, entries] : *all.asObject())
        for (const auto& [key, text] : *entries.asObject())
            texts[category + "." + key] = *text.asString();
    return texts;
}

Keys categories()
{
    Keys result;
    const io::Value english = language("en");
    for (const auto& [category, entries] : *english.asObject())
        result.insert(category);
    return result;
}

// String literals in the sources that read as "category.key", outside comments. Those that could as well be the name
// of a property count only where a text is asked for.
Keys keysInSources()
{
    Keys keys;
    const Keys known = categories();
    const std::regex comment{"//[^\n]*"}, literal{"(trf?\\()?\"([a-z]+)\\.([a-z0-9_.-]+)\""};
    for (const char* folder : {"editor", "app"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator{fs::path{WOLD_SOURCE_DIR} / folder}) {
            if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
            const std::string text = std::regex_replace(*io::readFile(entry.path()), comment, "");
            for (std::sregex_iterator at{text.begin(), text.end(), literal}, end; at != end; ++at) {
                const std::string category = (*at)[2], key = (*at)[3];
                const bool asked = (*at)[1].matched;
                const bool property = category == "environment" || category == "camera";
                if (known.contains(category) && key != "json" && (asked || !property))
                    keys.insert(category + "." + key);
            }
        }
    return keys;
}

// The keys that are put together while it runs: one for each field, choice, panel, action.
struct KeysOfFields {
    std::string prefix, path;
    Keys& keys;

    template <class T> void operator()(const char* key, T& value, const io::Hint&)
    {
        if constexpr (editor::HasFields<T, KeysOfFields>) {
            keys.insert("section." + prefix + path + key);
            KeysOfFields inner{prefix, path + key + ".", keys};
            fields(inner, value);
        } else if constexpr (!requires { value.emplace_back(); }) { // a list has a place of its own
            keys.insert("field." + prefix + path + key);
            if constexpr (editor::NamedEnum<T>)
                for (const std::string_view name : enumNames(value))
                    keys.insert("value." + std::string{name});
        }
    }
};

template <class T> void addFields(Keys& keys, const char* prefix)
{
    T thing;
    KeysOfFields visitor{prefix, "", keys};
    fields(visitor, thing);
}

Keys computedKeys()
{
    Keys keys;
    addFields<io::Environment>(keys, "");
    addFields<io::Template>(keys, "template.");
    addFields<io::Terrain>(keys, "terrain.");
    addFields<io::TerrainLayer>(keys, "layer.");
    addFields<io::GrassKind>(keys, "grass_kind.");
    addFields<io::Transform>(keys, "object.");
    addFields<renderer::Settings>(keys, "render.");
    for (const std::string_view tool : enumNames(editor::BrushTool::Raise)) {
        keys.insert("brush." + std::string{tool});
        keys.insert("brush_step." + std::string{tool});
    }
    for (std::size_t tool = 0; tool < enumNames(editor::BrushTool::Raise).size(); ++tool) { // each shows its own
        editor::Brush brush{.tool = editor::BrushTool(tool), .levelGiven = true};
        KeysOfFields visitor{"brush.", "", keys};
        fields(visitor, brush);
    }
    for (std::size_t mode = 0; mode < enumNames(editor::ScatterMode{}).size(); ++mode) {
        keys.insert("scatter_mode." + std::string{enumNames(editor::ScatterMode{})[mode]});
        keys.insert("scatter_step." + std::string{enumNames(editor::ScatterMode{})[mode]});
        editor::ScatterBrush brush{.mode = editor::ScatterMode(mode)};
        KeysOfFields visitor{"scatter_brush.", "", keys};
        fields(visitor, brush);
    }
    addFields<io::Species>(keys, "species.");
    addFields<io::ScatterLayer>(keys, "scatter.");
    keys.erase("field.scatter.id"); // never shown
    addFields<editor::GroundRecipe>(keys, "recipe.");
    for (const editor::Reshape kind : {editor::Reshape::Resample, editor::Reshape::Crop, editor::Reshape::Offset}) {
        editor::Reshaping reshaping{.kind = kind};
        KeysOfFields visitor{"reshape.", "", keys};
        fields(visitor, reshaping);
    }
    for (const std::string_view name : enumNames(renderer::Show::Final))
        keys.insert("show." + std::string{name});
    const test::Rig rig;
    for (const editor::Action& action : rig.editor->actions().all())
        keys.insert("action." + std::string{action.id});
    for (const editor::Panel* panel : rig.editor->workspace().panels())
        keys.insert("panel." + std::string{panel->id()});
    for (const std::string_view name : enumNames(io::Preset{}))
        keys.insert("look." + std::string{name});
    for (const std::string_view action : io::playActions())
        keys.insert("control." + std::string{action});
    for (const std::string_view name : enumNames(io::TriggerDo{}))
        keys.insert("trigger_do." + std::string{name});
    for (const char* starter : {"valley", "empty"})
        keys.insert("starter." + std::string{starter});
    for (const char* entry :
         {"look", "fly", "speed", "dolly", "orbit", "pan", "click", "behind", "toggle", "box", "snap", "cancel"})
        for (const char* part : {"", "_how"})
            keys.insert(std::string{"keys."} + entry + part);
    return keys;
}

TEST(Lang, BothLanguagesHoldTheSameKeys)
{
    const auto english = textsOf("en"), czech = textsOf("cs");
    for (const auto& [key, text] : english)
        EXPECT_TRUE(czech.contains(key)) << "cs.json lacks " << key;
    for (const auto& [key, text] : czech)
        EXPECT_TRUE(english.contains(key)) << "en.json lacks " << key;
}

TEST(Lang, EachCallsItselfByItsOwnName)
{
    EXPECT_EQ(textsOf("en")["language.name"], "English");
    EXPECT_EQ(textsOf("cs")["language.name"], "Čeština");
}

TEST(Lang, NoTextIsMissing)
{
    const auto english = textsOf("en");
    for (const Keys& keys : {keysInSources(), computedKeys()})
        for (const std::string& key : keys)
            EXPECT_TRUE(english.contains(key)) << "no text for " << key;
}

TEST(Lang, NoTextIsUnused)
{
    Keys used = keysInSources();
    used.merge(computedKeys());
    for (const auto& [key, text] : textsOf("en")) {
        const std::string field = key.substr(key.find('.') + 1);
        if (key.starts_with("hint.") && used.contains("field." + field)) continue; // of a field, where there is one
        EXPECT_TRUE(used.contains(key)) << key << " is used nowhere";
    }
}

TEST(Lang, PlaceholdersAreTheSame)
{
    const auto english = textsOf("en"), czech = textsOf("cs");
    const std::regex placeholder{"\\{[^}]*\\}"};
    const auto count = [&](const std::string& text) {
        return std::distance(std::sregex_iterator{text.begin(), text.end(), placeholder}, std::sregex_iterator{});
    };
    for (const auto& [key, text] : english) {
        if (czech.contains(key)) {
            EXPECT_EQ(count(text), count(czech.at(key))) << key;
        }
        EXPECT_FALSE(text.empty()) << key;
    }
}

TEST(Lang, CzechIsCzech)
{
    std::size_t same = 0, accented = 0;
    const auto english = textsOf("en"), czech = textsOf("cs");
    for (const auto& [key, text] : czech) {
        same += english.contains(key) && english.at(key) == text;
        accented += text.find_first_of("\xc3\xc4\xc5") != std::string::npos;
    }
    EXPECT_LT(same, czech.size() / 6);
    EXPECT_GT(accented, czech.size() / 2);
}

// Every step that a person can make in the window has a name of its language.
TEST(Lang, StepsAreNamedInTheLanguageOfTheWindow)
{
    for (const std::string code : {"en", "cs"}) {
        test::Rig rig;
        rig.host.setLanguage(code);
        std::set<std::string> known;
        for (const auto& [key, text] : textsOf(code))
            if (key.starts_with("undo.")) known.insert(text);
        rig.editor->chosenTemplate = io::TemplateId{2};
        const io::ObjectId first{1};
        for (const editor::Action& action : rig.editor->actions().all()) {
            if (action.id == "quit" || action.id == "close" || action.id == "undo" || action.id == "redo") continue;
            rig.editor->selection().set(rig.document().hierarchy().outermost({&first, 1}));
            if (rig.document().scene().find(first) == nullptr) rig.document().goTo(0);
            rig.editor->actions().run(action.id);
            rig.frame(2);
            for (const std::string& name : rig.document().history().names())
                EXPECT_TRUE(known.contains(name)) << code << " " << action.id << ": " << name;
        }
    }
}

TEST(Text, MissingKeysShowThemselvesAndBadFormatsDoNotThrow)
{
    io::Value table;
    table["a"]["good"] = "{0} of {1}";
    table["a"]["bad"] = "{0} of {7}";
    table["a"]["number"] = 5;
    editor::setTexts(table);
    EXPECT_EQ(editor::trf("a.good", 1, "x"), "1 of x");
    EXPECT_EQ(editor::trf("a.bad", 1), "{0} of {7}");
    EXPECT_STREQ(editor::tr("a.number"), "a.number");
    EXPECT_STREQ(editor::tr("nosuch.key"), "nosuch.key");
    EXPECT_EQ(editor::missingTexts().size(), 3u);
}

} // namespace
