#include "editor/keys.h"

#include "editor/text.h"

namespace editor {
namespace {

std::string name(Key key)
{
    const int code = int(key);
    if (key >= Key::F1 && key <= Key::F12) return "F" + std::to_string(code - int(Key::F1) + 1);
    if (code > int(Key::Space) && code < 128) return std::string(1, char(code));
    switch (key) {
    case Key::Space:
        return tr("key.space");
    case Key::Escape:
        return tr("key.escape");
    case Key::Enter:
        return tr("key.enter");
    case Key::Delete:
        return tr("key.delete");
    case Key::Home:
        return tr("key.home");
    case Key::End:
        return tr("key.end");
    default:
        return std::to_string(code);
    }
}

} // namespace

bool pressed(const Chord& chord, bool repeat)
{
    const ImGuiIO& io = ImGui::GetIO();
    return chord.key != Key::None && io.KeyCtrl == chord.ctrl && io.KeyShift == chord.shift && io.KeyAlt == chord.alt &&
           pressed(chord.key, repeat);
}

std::string name(const Chord& chord)
{
    if (chord.key == Key::None) return {};
    std::string text;
    if (chord.ctrl) text += std::string{tr("key.ctrl")} + "+";
    if (chord.shift) text += std::string{tr("key.shift")} + "+";
    if (chord.alt) text += std::string{tr("key.alt")} + "+";
    return text + name(chord.key);
}

} // namespace editor
