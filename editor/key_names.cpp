#include "editor/key_names.h"

#include "editor/keys.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace editor {
namespace {

struct KeyName {
    std::string_view name;
    int code;
};
constexpr KeyName kKeys[] = {{"Space", int(Key::Space)},
                             {"Escape", int(Key::Escape)},
                             {"Enter", int(Key::Enter)},
                             {"Tab", int(Key::Tab)},
                             {"Backspace", int(Key::Backspace)},
                             {"Insert", int(Key::Insert)},
                             {"Delete", int(Key::Delete)},
                             {"Right", int(Key::Right)},
                             {"Left", int(Key::Left)},
                             {"Down", int(Key::Down)},
                             {"Up", int(Key::Up)},
                             {"PageUp", int(Key::PageUp)},
                             {"PageDown", int(Key::PageDown)},
                             {"Home", int(Key::Home)},
                             {"End", int(Key::End)},
                             {"Shift", 340},
                             {"Ctrl", 341},
                             {"Alt", 342},
                             {"RightShift", 344},
                             {"RightCtrl", 345},
                             {"RightAlt", 346},
                             {"Comma", ','},
                             {"Minus", '-'},
                             {"Period", '.'},
                             {"Slash", '/'}};

} // namespace

bool sameWord(std::string_view a, std::string_view b)
{
    return std::ranges::equal(a, b, [](char x, char y) { return std::tolower(x) == std::tolower(y); });
}

std::optional<int> keyNamed(std::string_view name)
{
    if (name.size() == 1 && std::isalnum(static_cast<unsigned char>(name[0]))) return std::toupper(name[0]);
    if (name.size() > 1 && std::toupper(name[0]) == 'F') {
        int number = 0;
        const auto [end, fault] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
        if (fault == std::errc{} && end == name.data() + name.size() && number >= 1 && number <= 12) return int(Key::F1) + number - 1;
    }
    for (const KeyName& key : kKeys)
        if (sameWord(key.name, name)) return key.code;
    return std::nullopt;
}

std::string nameOfKey(int code)
{
    if ((code >= '0' && code <= '9') || (code >= 'A' && code <= 'Z')) return std::string(1, char(code));
    if (code >= int(Key::F1) && code <= int(Key::F12)) return "F" + std::to_string(code - int(Key::F1) + 1);
    for (const KeyName& key : kKeys)
        if (key.code == code) return std::string{key.name};
    return {};
}

} // namespace editor
