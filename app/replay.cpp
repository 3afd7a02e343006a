#include "app/replay.h"

#include "app/text.h"
#include "io/files/atomic_file.h"
#include "io/files/json.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace app {
namespace {

constexpr std::array<std::string_view, 3> kButtons{"left", "right", "middle"};
constexpr int kLongestWait = 100'000; // frames
constexpr int kMostSteps = 10'000;

// Reads one line's object into steps. The first fault is kept; what follows it does not matter.
class LineReader {
public:
    LineReader(const io::Value& object, int line, std::vector<Step>& steps)
        : m_object{object}, m_line{line}, m_steps{steps}
    {
    }

    std::string read(); // what is wrong, empty when nothing is

private:
    using Reader = void (LineReader::*)(const io::Value&);
    struct Kind {
        std::string_view name;
        Reader reader;
    };
    static const std::array<Kind, 15> kKinds;

    void add(Action action) { m_steps.push_back({std::move(action), m_line}); }
    void wrong(std::string what)
    {
        if (m_fault.empty()) m_fault = std::move(what);
    }

    double number(const io::Value& value, std::string_view name);
    int count(const io::Value& value, std::string_view name, int least, int most);
    glm::dvec2 pair(const io::Value& value, std::string_view name);
    std::string text(const io::Value& value, std::string_view name);
    Place place(const io::Value& value, std::string_view name);
    int buttonOf(const io::Value& from);
    int button(const io::Value& value);
    std::vector<int> modsOf(const io::Value& from);
    void press(const std::vector<int>& keys, bool down);

    void move(const io::Value& value) { add(step::Move{.to = place(value, "move")}); }
    void pressButton(const io::Value& value) { add(step::Button{button(value), true}); }
    void releaseButton(const io::Value& value) { add(step::Button{button(value), false}); }
    void click(const io::Value& value);
    void drag(const io::Value& value);
    void wheel(const io::Value& value) { add(step::Wheel{pair(value, "wheel")}); }
    void key(const io::Value& value);
    void keyDown(const io::Value& value) { press(keys(value), true); }
    void keyUp(const io::Value& value) { press(keys(value), false); }
    void typed(const io::Value& value) { add(step::Text{text(value, "text")}); }
    void wait(const io::Value& value) { add(step::Wait{count(value, "wait", 0, kLongestWait)}); }
    void resize(const io::Value& value);
    void shot(const io::Value& value) { add(step::Shot{value.asBool() ? std::string{} : text(value, "shot")}); }
    void uiMap(const io::Value& value) { add(step::UiMap{text(value, "uimap")}); }
    void pad(const io::Value& value);
    std::vector<int> keys(const io::Value& value);

    const io::Value& m_object;
    int m_line;
    std::vector<Step>& m_steps;
    std::string m_fault;
};

const std::array<LineReader::Kind, 15> LineReader::kKinds{{{"move", &LineReader::move},
                                                           {"press", &LineReader::pressButton},
                                                           {"release", &LineReader::releaseButton},
                                                           {"click", &LineReader::click},
                                                           {"drag", &LineReader::drag},
                                                           {"wheel", &LineReader::wheel},
                                                           {"key", &LineReader::key},
                                                           {"keydown", &LineReader::keyDown},
                                                           {"keyup", &LineReader::keyUp},
                                                           {"text", &LineReader::typed},
                                                           {"wait", &LineReader::wait},
                                                           {"size", &LineReader::resize},
                                                           {"shot", &LineReader::shot},
                                                           {"uimap", &LineReader::uiMap},
                                                           {"pad", &LineReader::pad}}};

std::string LineReader::read()
{
    const auto* members = m_object.asObject();
    if (!members || members->empty()) return "write one JSON object, as {\"move\": [100, 80]}";
    const auto& [name, value] = members->front();
    const auto kind = std::ranges::find(kKinds, name, &Kind::name);
    if (kind == kKinds.end()) return fmt::format("unknown event \"{}\"; docs/replay.md lists them", name);
    for (std::size_t i = 1; i < members->size(); ++i)
        if (const std::string& extra = (*members)[i].first; extra != "button" && extra != "mods" && (name != "pad" || extra != "to"))
            return fmt::format("\"{}\" does not belong to \"{}\"", extra, name);
    (this->*kind->reader)(value);
    return m_fault;
}

double LineReader::number(const io::Value& value, std::string_view name)
{
    if (const double* n = value.asNumber()) return *n;
    wrong(fmt::format("\"{}\" wants a number", name));
    return 0;
}

int LineReader::count(const io::Value& value, std::string_view name, int least, int most)
{
    const double n = number(value, name);
    if (n < least || n > most || n != std::floor(n)) {
        wrong(fmt::format("\"{}\" wants a whole number from {} to {}", name, least, most));
        return least;
    }
    return int(n);
}

glm::dvec2 LineReader::pair(const io::Value& value, std::string_view name)
{
    const auto* items = value.asArray();
    if (items && items->size() == 2 && (*items)[0].asNumber() && (*items)[1].asNumber()) {
        const glm::dvec2 result{*(*items)[0].asNumber(), *(*items)[1].asNumber()};
        if (std::abs(result.x) < 1e6 && std::abs(result.y) < 1e6) return result;
    }
    wrong(fmt::format("\"{}\" wants two numbers, as [100, 80]", name));
    return {};
}

std::string LineReader::text(const io::Value& value, std::string_view name)
{
    if (const std::string* s = value.asString(); s && !s->empty()) return *s;
    wrong(fmt::format("\"{}\" wants a text in quotes", name));
    return {};
}

Place LineReader::place(const io::Value& value, std::string_view name)
{
    const auto* members = value.asObject();
    if (!members) return {.pixel = pair(value, name)};
    Place result;
    for (const auto& [key, member] : *members)
        if (key == "panel")
            result.panel = text(member, key);
        else if (key == "label")
            result.label = text(member, key);
        else if (key == "kind")
            result.kind = text(member, key);
        else if (key == "offset")
            result.pixel = pair(member, key);
        else
            wrong(fmt::format("a widget is named by panel, label and kind, not \"{}\"", key));
    if (!result.isWidget()) wrong(fmt::format("\"{}\" names no widget: give its panel and label", name));
    return result;
}

int LineReader::button(const io::Value& value)
{
    const std::string* name = value.asString();
    const auto found = name ? std::ranges::find(kButtons, *name) : kButtons.end();
    if (found == kButtons.end()) return wrong("a button is \"left\", \"right\" or \"middle\""), 0;
    return int(found - kButtons.begin());
}

int LineReader::buttonOf(const io::Value& from)
{
    const io::Value* value = from.find("button");
    return value ? button(*value) : 0;
}

std::vector<int> LineReader::modsOf(const io::Value& from)
{
    std::vector<int> result;
    const io::Value* list = from.find("mods");
    if (!list) return result;
    if (!list->asArray()) return wrong("\"mods\" wants a list, as [\"ctrl\", \"shift\"]"), result;
    for (const io::Value& mod : *list->asArray()) {
        const std::string* name = mod.asString();
        const bool known = name && (editor::sameWord(*name, "ctrl") || editor::sameWord(*name, "shift") || editor::sameWord(*name, "alt"));
        if (!known) return wrong("a modifier is \"ctrl\", \"shift\" or \"alt\""), result;
        result.push_back(*keyNamed(*name));
    }
    return result;
}

void LineReader::press(const std::vector<int>& keys, bool down)
{
    if (down)
        for (const int code : keys)
            add(step::Key{code, true});
    else
        for (auto code = keys.rbegin(); code != keys.rend(); ++code)
            add(step::Key{*code, false});
}

void LineReader::click(const io::Value& value)
{
    const auto mods = modsOf(m_object);
    const int which = buttonOf(m_object);
    add(step::Move{.to = place(value, "click")});
    press(mods, true);
    add(step::Button{which, true});
    add(step::Button{which, false});
    press(mods, false);
}

void LineReader::drag(const io::Value& value)
{
    const io::Value *from = value.find("from"), *to = value.find("to"), *steps = value.find("steps");
    if (!from || !to) return wrong("\"drag\" wants \"from\" and \"to\"");
    const Place start = place(*from, "from"), end = place(*to, "to");
    const int moves = steps ? count(*steps, "steps", 1, kMostSteps) : 10;
    const auto mods = modsOf(value.find("mods") ? value : m_object);
    const int which = buttonOf(value.find("button") ? value : m_object);
    add(step::Move{.to = start});
    press(mods, true);
    add(step::Button{which, true});
    for (int i = 1; i <= moves; ++i)
        add(step::Move{start, end, double(i) / moves});
    add(step::Button{which, false});
    press(mods, false);
}

std::vector<int> LineReader::keys(const io::Value& value)
{
    std::vector<int> codes;
    const std::string chord = text(value, "key");
    for (const std::string_view name : split(chord, '+')) {
        const auto code = keyNamed(name);
        if (!code) return wrong(fmt::format("there is no key \"{}\"; docs/replay.md lists their names", name)), codes;
        codes.push_back(*code);
    }
    return codes;
}

void LineReader::key(const io::Value& value)
{
    const auto codes = keys(value);
    press(codes, true);
    press(codes, false);
}

void LineReader::resize(const io::Value& value)
{
    const glm::dvec2 size = pair(value, "size");
    if (size.x < 1 || size.y < 1 || size.x > 16384 || size.y > 16384 || size != glm::floor(size))
        return wrong("\"size\" wants a width and a height from 1 to 16384");
    add(step::Resize{glm::ivec2{size}});
}

void LineReader::pad(const io::Value& value)
{
    const io::Value* to = m_object.find("to");
    const double share = to ? number(*to, "to") : 1;
    if (share < 0 || share > 1) wrong("\"to\" wants a number from 0 to 1");
    add(step::Pad{"pad " + text(value, "pad"), share});
}

} // namespace

io::Result<std::vector<Step>> parseReplay(std::string_view text, const std::string& where)
{
    std::vector<Step> steps;
    int number = 0;
    for (const std::string_view line : split(text, '\n')) {
        ++number;
        if (line.find_first_not_of(" \t\r") == line.npos) continue;
        const std::string place = fmt::format("{}:{}", where, number);
        const auto object = io::parseJson(line, place);
        if (!object) return io::Error{place, object.error().what};
        if (const std::string fault = LineReader{*object, number, steps}.read(); !fault.empty())
            return io::Error{place, fault};
    }
    return steps;
}

io::Result<std::vector<Step>> readReplay(const std::filesystem::path& file)
{
    const auto text = io::readFile(file);
    if (!text) return text.error();
    return parseReplay(*text, file.string());
}

} // namespace app
