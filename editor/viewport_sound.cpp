// The sound of what is selected: how far it reaches, and its handles.
#include "editor/editor.h"
#include "editor/text.h"
#include "editor/viewport.h"
#include "editor/widgets.h"

namespace editor {
namespace {

constexpr ImU32 kSound = IM_COL32(92, 214, 200, 255);
constexpr ImU32 kHot = IM_COL32(255, 214, 92, 255);

} // namespace

// Of the primary, if it has one; nothing while another tool has the pointer.
std::optional<Viewport::ShownSound> Viewport::soundShown(Editor& editor) const
{
    if (!showOverlays || sculpting || scattering || m_placing != io::TemplateId::None || !editor.document()) return {};
    const io::Object* object = editor.document()->scene().find(editor.selection().primary());
    const io::Template* value = object ? editor.document()->scene().find(object->templateId) : nullptr;
    if (!value || value->sound.file.empty()) return {};
    return ShownSound{object->templateId, soundFrame(view(), *object, value->sound), value->sound};
}

void Viewport::hoverSound(Editor& editor)
{
    m_soundHovered = {};
    const auto shown = soundShown(editor);
    if (m_hovered && shown) m_soundHovered = soundHandleAt(soundMarks(view(), shown->frame, shown->sound), pointer());
}

bool Viewport::beginSound(Editor& editor)
{
    if (m_soundHovered.kind == SoundHandle::Kind::None) return false;
    m_soundDragged = soundShown(editor);
    if (!m_soundDragged) return false;
    editor.document()->beginGesture(trf("undo.edit", tr(m_soundHovered.kind == SoundHandle::Kind::Key ? "falloff.curve" : "field.template.sound.radius")));
    return true;
}

void Viewport::dragSound(Editor& editor)
{
    const io::Template* now = editor.document()->scene().find(m_soundDragged->id);
    if (!now) return;
    const double step = ImGui::GetIO().KeyCtrl != snapping ? gizmo.snap.translate : 0;
    io::Template changed = *now;
    changed.sound = soundDragged(view(), m_soundDragged->frame, m_soundDragged->sound, m_soundHovered, pointer(), step);
    if (changed.sound != now->sound) setTemplate(*editor.document(), tr("falloff.curve"), m_soundDragged->id, std::move(changed));
}

void Viewport::endSound(Editor& editor, bool keep)
{
    m_soundDragged.reset();
    m_soundHovered = {};
    if (keep) editor.document()->endGesture();
    else editor.document()->cancelGesture();
}

void Viewport::drawSound(Editor& editor) const
{
    const auto shown = soundShown(editor);
    if (!shown) return;
    const MapPanel map{"gizmo"};
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const auto onScreen = [&](glm::dvec2 p) { return ImVec2{m_min.x + float(p.x), m_min.y + float(p.y)}; };
    const auto foot = project(view(), shown->frame.middle), rim = project(view(), shown->frame.at(1, 0));
    if (foot && rim) draw.AddLine(onScreen(*foot), onScreen(*rim), withAlpha(kSound, 0.5f));
    for (const glm::dvec2& p : soundCurve(view(), shown->frame, shown->sound))
        draw.PathLineTo(onScreen(p));
    draw.PathStroke(kSound, 0, 2);
    for (const SoundMark& mark : soundMarks(view(), shown->frame, shown->sound)) {
        const bool hot = mark.handle == m_soundHovered, key = mark.handle.kind == SoundHandle::Kind::Key;
        const ImVec2 at = onScreen(mark.pixel);
        const float size = (key ? 4.0f : 5.0f) + (hot ? 1.5f : 0);
        draw.AddRectFilled({at.x - size - 1, at.y - size - 1}, {at.x + size + 1, at.y + size + 1}, IM_COL32(18, 18, 21, 200), key ? size : 2);
        draw.AddRectFilled({at.x - size, at.y - size}, {at.x + size, at.y + size}, hot ? kHot : kSound, key ? size : 2);
        mapRect("sound handle", key ? "key " + std::to_string(mark.handle.key + 1) : std::string{"radius"}, {at.x - 4, at.y - 4}, {at.x + 4, at.y + 4}, double(shown->sound.radius));
        if (!hot) continue;
        const io::SoundSource& sound = shown->sound;
        const std::string text = key && mark.handle.key < sound.falloff.size()
                                     ? trf("falloff.key", double(sound.falloff[mark.handle.key].level) * 100, double(sound.falloff[mark.handle.key].at * sound.radius))
                                     : trf("viewport.sound_radius", double(sound.radius));
        const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
        draw.AddRectFilled({at.x + 10, at.y - 32}, {at.x + 26 + extent.x, at.y - 24 + extent.y}, IM_COL32(18, 18, 21, 190), 5);
        draw.AddText({at.x + 18, at.y - 28}, kHot, text.c_str());
    }
}

} // namespace editor
