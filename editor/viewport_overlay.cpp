// What lies over the picture: gizmo, selection box, boxes of groups, compass, hints, faults of shaders.
#include "editor/editor.h"
#include "editor/instance_edits.h"
#include "editor/placement.h"
#include "editor/statistics_overlay.h"
#include "editor/text.h"
#include "editor/viewport.h"
#include "editor/widgets.h"
#include "renderer/debug_lines.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

constexpr ImU32 kAxes[] = {palette::kRed, palette::kGreen, palette::kBlue};
constexpr ImU32 kNeutral = IM_COL32(225, 225, 232, 255);
constexpr ImU32 kHot = IM_COL32(255, 214, 92, 255);
constexpr glm::vec4 kLampReach{1, 0.85f, 0.4f, 0.6f}; // sRGB
constexpr glm::vec4 kSoundReach{0.36f, 0.84f, 0.78f, 0.55f};
constexpr glm::vec4 kTriggerReach{1, 0.55f, 0.35f, 0.8f};
constexpr ImU32 kPill = IM_COL32(18, 18, 21, 190);

ImU32 colourOf(const GizmoShape& shape)
{
    const ImU32 colour = shape.hovered ? kHot : shape.axis < 0 ? kNeutral : kAxes[shape.axis];
    return withAlpha(colour, float(shape.fade));
}

std::string_view name(GizmoHandle handle)
{
    constexpr std::string_view kNames[] = {"none", "x", "y", "z", "yz", "zx", "xy", "centre", "view"};
    return kNames[std::size_t(handle)];
}

glm::dvec2 middleOf(const GizmoShape& shape)
{
    if (!shape.closed && !shape.filled) return shape.points[shape.points.size() / 2];
    glm::dvec2 sum{0};
    for (const glm::dvec2& p : shape.points)
        sum += p;
    return sum / double(shape.points.size());
}

// Text on a dark pill; answers its width.
float pill(ImVec2 at, std::string_view text, ImU32 colour, bool centred = false, Icon icon = Icon::None)
{
    const ImVec2 size = ImGui::CalcTextSize(text.data(), text.data() + text.size());
    const float lead = icon == Icon::None ? 0 : 22.f;
    const float width = size.x + 20 + lead;
    if (centred) at.x -= std::floor(width / 2);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(at, {at.x + width, at.y + size.y + 10}, kPill, 5);
    if (icon != Icon::None) drawIcon(draw, icon, {at.x + 9, at.y + 5 + (size.y - 14) / 2}, 14, colour);
    draw.AddText({at.x + 10 + lead, at.y + 5}, colour, text.data(), text.data() + text.size());
    return width;
}

std::string amountText(const Gizmo& gizmo)
{
    const glm::dvec3 by = gizmo.amount();
    if (gizmo.mode == GizmoMode::Translate) return trf("viewport.moved", by.x, by.y, by.z);
    if (gizmo.mode == GizmoMode::Rotate) return trf("viewport.rotated", by.x);
    return trf("viewport.scaled", by.x, by.y, by.z);
}

// How far what a copy carries reaches: its lamp, its sound, its trigger.
void addReaches(std::vector<renderer::Line>& lines, const io::Object& object, const io::Template& value)
{
    if (const auto lamp = renderer::lampOf(object, value.light)) renderer::addLamp(lines, *lamp, kLampReach);
    if (!value.sound.file.empty()) renderer::addSphere(lines, soundPlace(object, value.sound), double(value.sound.radius), kSoundReach);
    const glm::dvec3 half = glm::dvec3{value.trigger.size} * glm::abs(glm::dvec3{object.transform.scale}) / 2.0;
    if (value.trigger.shape == io::TriggerShape::Sphere) renderer::addSphere(lines, object.transform.position, half.x, kTriggerReach);
    if (value.trigger.shape != io::TriggerShape::Box) return;
    const glm::dmat3 axes = glm::mat3_cast(io::orientation(object.transform.rotation));
    renderer::addBox(lines, object.transform.position, {axes[0] * half.x, axes[1] * half.y, axes[2] * half.z}, kTriggerReach);
}

} // namespace

renderer::FrameInput Viewport::frameInput(Editor& editor)
{
    refreshSelectionShown(editor);
    renderer::FrameInput input;
    input.camera = editor.cameras().named(kEditCamera);
    input.size = m_size;
    input.settings = editor.renderSettings;
    input.show = editor.show;
    input.time = editor.time();
    input.environment = editor.live().shown(editor.document()->scene().environment());
    input.selection = m_tinted;
    if (m_ghost) input.ghosts = {&*m_ghost, 1};
    m_frameLines = m_lines;
    addBrushLines(editor, m_frameLines);
    addScatterLines(editor, m_frameLines);
    if (showOverlays) path.addLines(*editor.document(), m_frameLines);
    input.lines = m_frameLines;
    input.freezeCulling = freezeCulling;
    input.ids = m_drag == Drag::Click || m_drag == Drag::Box; // a box may be let go in the next frame
    return input;
}

// Selected groups have no mesh of their own: their members are tinted, and a box stands around them. Lamps show how far they
// reach.
void Viewport::refreshSelectionShown(Editor& editor)
{
    const Document& document = *editor.document();
    if (m_shownRevision == document.revision() && m_shownSelection == editor.selection().revision()) return;
    m_shownRevision = document.revision();
    m_shownSelection = editor.selection().revision();
    m_tinted = document.hierarchy().withMembers(editor.selection().ids());
    const auto primary = std::find(m_tinted.begin(), m_tinted.end(), editor.selection().primary());
    if (primary != m_tinted.end()) std::rotate(primary, primary + 1, m_tinted.end());
    const io::Scene& scene = document.scene();
    std::erase_if(m_tinted, [&](io::ObjectId id) { return !scene.find(id) && !scene.findInstance(id); });
    m_transforms.clear();
    for (const io::ObjectId id : m_tinted)
        m_transforms.push_back(io::isInstance(id) ? objectOf(scene, *scene.findInstance(id)).transform : scene.at(id).transform);
    m_lines.clear();
    for (const io::ObjectId id : editor.selection().ids()) {
        const io::Object* object = document.scene().find(id);
        if (!object) continue;
        if (const io::Template* value = document.scene().find(object->templateId))
            addReaches(m_lines, *object, *value);
        if (object->templateId != io::TemplateId::None) continue;
        if (const io::WorldBox box = boundsOf(document, {&id, 1}); !box.empty())
            renderer::addBox(m_lines, box, {0.62f, 0.47f, 1.0f, 0.55f});
    }
}

void Viewport::overlays(Editor& editor)
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRect(m_min, {m_min.x + float(m_size.x), m_min.y + float(m_size.y)}, true);
    drawGizmo();
    drawSound(editor);
    drawPathKeys(editor);
    if (m_drag == Drag::Box) drawBox();
    drawCompass();
    drawHints(editor);
    drawFaults(editor);
    draw.PopClipRect();
}

void Viewport::drawGizmo() const
{
    if (!gizmoShown || sculpting || scattering || m_transforms.empty() || m_placing != io::TemplateId::None) return;
    const auto frame = gizmo.dragging() ? std::optional{gizmo.activeFrame()} : gizmo.frame(m_transforms);
    if (!frame) return;
    const MapPanel map{"gizmo"};
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (const GizmoShape& shape : gizmo.shapes(view(), *frame)) {
        if (shape.points.empty()) continue;
        for (const glm::dvec2& p : shape.points)
            draw.PathLineTo({m_min.x + float(p.x), m_min.y + float(p.y)});
        if (shape.filled)
            draw.PathFillConvex(colourOf(shape));
        else
            draw.PathStroke(colourOf(shape), shape.closed ? ImDrawFlags_Closed : 0, shape.hovered ? 3.5f : 2.5f);
        const glm::dvec2 middle = middleOf(shape);
        const ImVec2 at{m_min.x + float(middle.x), m_min.y + float(middle.y)};
        if (shape.handle != GizmoHandle::None)
            mapRect("gizmo", name(shape.handle), {at.x - 4, at.y - 4}, {at.x + 4, at.y + 4}, shape.hovered);
    }
    if (!gizmo.dragging()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    pill({mouse.x + 18, mouse.y + 14}, amountText(gizmo), palette::kText);
}

void Viewport::drawBox() const
{
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const ImVec2 a{m_min.x + float(m_pressed.x), m_min.y + float(m_pressed.y)};
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 min{std::min(a.x, mouse.x), std::min(a.y, mouse.y)},
        max{std::max(a.x, mouse.x), std::max(a.y, mouse.y)};
    draw.AddRectFilled(min, max, withAlpha(palette::kAccent, 0.16f));
    draw.AddRect(min, max, palette::kAccent);
}

void Viewport::drawPathKeys(const Editor& editor) const
{
    constexpr float kRadius = 6;
    const auto keys = path.keysOnScreen(*editor.document(), view());
    std::optional<std::size_t> under;
    if (m_hovered) under = path.keyUnder(*editor.document(), view(), pointer());
    const MapPanel map{"path"};
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (!keys[i]) continue;
        const ImVec2 at{m_min.x + float(keys[i]->x), m_min.y + float(keys[i]->y)};
        const bool hot = under && *under == i;
        draw.AddCircleFilled(at, kRadius, hot ? kHot : IM_COL32(90, 200, 255, 255));
        draw.AddCircle(at, kRadius, IM_COL32(16, 16, 18, 255), 0, 1.5f);
        const std::string number = std::to_string(i + 1);
        pill({at.x + 10, at.y - 12}, number, palette::kText);
        mapRect("path_key", number, {at.x - 4, at.y - 4}, {at.x + 4, at.y + 4}, hot);
    }
}

// The world's axes as the camera sees them, top right.
void Viewport::drawCompass() const
{
    constexpr float kRadius = 30;
    const ImVec2 middle{m_min.x + float(m_size.x) - 48, m_min.y + 48};
    if (m_size.x < 200 || m_size.y < 160) return;
    const glm::dmat3 turn{renderer::viewFromRelative(camera.camera())};
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddCircleFilled(middle, kRadius + 12, IM_COL32(18, 18, 21, 90));
    int order[] = {0, 1, 2};
    std::sort(order, order + 3, [&turn](int a, int b) { return turn[a].z < turn[b].z; }); // far ones first
    for (const int axis : order) {
        const glm::dvec3 to = turn[axis];
        const float alpha = to.z < -0.1 ? 0.6f : 1.f;
        const ImVec2 tip{middle.x + float(to.x) * kRadius, middle.y - float(to.y) * kRadius};
        draw.AddLine(middle, tip, withAlpha(kAxes[axis], alpha), 2);
        draw.AddCircleFilled(tip, 8, withAlpha(kAxes[axis], alpha));
        const char letter[] = {"XYZ"[axis], 0};
        const ImVec2 size = boldFont()->CalcTextSizeA(12, FLT_MAX, 0, letter);
        draw.AddText(boldFont(), 12, {tip.x - size.x / 2, tip.y - size.y / 2}, IM_COL32(16, 16, 18, 255), letter);
    }
}

void Viewport::drawHints(Editor& editor) const
{
    const glm::dvec3 eye = camera.camera().eye;
    const float bottom = m_min.y + float(m_size.y) - 36;
    const float middle = m_min.x + float(m_size.x) / 2;
    pill({m_min.x + 10, bottom}, trf("viewport.eye", eye.x, eye.y, eye.z), palette::kSoftText);
    if (editor.show != renderer::Show::Final) {
        const auto names = enumNames(editor.show);
        pill({m_min.x + 10, m_min.y + 10}, tr("show." + std::string{names[std::size_t(editor.show)]}), kHot, false,
             Icon::Layers);
    }
    if (freezeCulling) {
        const float top = editor.show == renderer::Show::Final ? 10.f : 42.f;
        pill({m_min.x + 10, m_min.y + top}, tr("viewport.culling_frozen"), kHot, false, Icon::Frame);
    }
    if (m_drag == Drag::Look || m_speedShown > 0) {
        pill({middle, bottom}, trf("viewport.speed", camera.speed()), palette::kText, true, Icon::Camera);
    } else if (m_placing != io::TemplateId::None) {
        const std::string name{editor.document()->scene().templateName(m_placing)};
        pill({middle, bottom}, trf("viewport.placing", name), palette::kText, true, Icon::Place);
    } else if (sculpting) {
        const std::string tool = tr("brush." + std::string{enumNames(brush.tool)[std::size_t(brush.tool)]});
        pill({middle, bottom}, !shapes(brush.tool) ? trf("viewport.painting", tool, double(brush.radius)) : trf("viewport.sculpting", tool, double(brush.radius)), palette::kText, true, Icon::Terrain);
    } else if (scattering) {
        const io::ScatterLayer* layer = scatterTarget(*editor.document());
        const std::string mode = tr("scatter_mode." + std::string{enumNames(scatterBrush.mode)[std::size_t(scatterBrush.mode)]});
        pill({middle, bottom}, layer ? trf("viewport.scattering", mode, layer->name, double(scatterBrush.radius)) : tr("viewport.scatter_no_layer"), palette::kText, true, Icon::Tree);
    } else if (m_drag == Drag::Gizmo) {
        pill({middle, bottom}, tr("viewport.dragging"), palette::kText, true);
    }
}

void Viewport::drawStatistics(Editor& editor) const
{
    const renderer::FrameStats none;
    const int pills = showOverlays ? int(editor.show != renderer::Show::Final) + int(freezeCulling) : 0;
    const float top = pills == 0 ? 10.f : 14.f + 32.f * float(pills);
    statisticsOverlay(frames, editor.renderer() ? editor.renderer()->stats() : none, memoryOf(*editor.document()), {m_min.x + 10, m_min.y + top},
                      {float(m_size.x) - 20, float(m_size.y) - top - 46});
}

void Viewport::drawFaults(Editor& editor) const
{
    if (!editor.renderer()) return;
    float y = m_min.y + 12;
    for (const renderer::ShaderFault& fault : editor.renderer()->shaderFaults()) {
        const std::string text = fault.where + ": " + fault.what;
        const std::string shown = ui::fitted(text.substr(0, text.find('\n')), float(m_size.x) - 160);
        pill({m_min.x + 10, y}, shown, palette::kRed, false, Icon::Error);
        y += 32;
    }
}

} // namespace editor
