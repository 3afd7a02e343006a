// The scatter brush in the viewport: strokes that plant, and the lines that show where they fall.
#include "editor/brush_ring.h"
#include "editor/editor.h"
#include "editor/text.h"
#include "editor/viewport.h"

#include <algorithm>

namespace editor {
namespace {

constexpr double kFarthest = 20000; // m, that one plants from the eye
constexpr glm::vec4 kGrow{0.45f, 1.0f, 0.5f, 1}, kTake{1.0f, 0.5f, 0.4f, 1}, kChange{0.5f, 0.8f, 1.0f, 1};

glm::vec4 colourOf(ScatterMode mode)
{
    if (mode == ScatterMode::Erase || mode == ScatterMode::Thin) return kTake;
    return mode == ScatterMode::Reseed || mode == ScatterMode::Replace ? kChange : kGrow;
}

ScatterMode modeNow(ScatterMode mode)
{
    return modeWith(mode, ImGui::GetIO().KeyCtrl, ImGui::GetIO().KeyShift);
}

} // namespace

const io::ScatterLayer* Viewport::scatterTarget(const Document& document) const
{
    return document.scene().find(scatterLayer);
}

void Viewport::scatterWith(Editor& editor, ScatterMode mode)
{
    scatterBrush.mode = mode;
    scattering = true;
    sculpting = false;
    stopPlacing();
    editor.workspace().bringToFront("scatter");
}

void Viewport::beginScatter(Editor& editor)
{
    if (!m_brushAt || !scatterTarget(*editor.document())) return;
    ScatterBrush brush = scatterBrush;
    brush.mode = modeNow(brush.mode);
    const auto names = enumNames(brush.mode);
    m_scatterStroke.emplace(*editor.document(), editor.picker(), brush, scatterLayer, tr("scatter_step." + std::string{names[std::size_t(brush.mode)]}));
    m_scatterStroke->to(*m_brushAt);
    m_drag = Drag::Scatter;
    editor.follow();
}

void Viewport::holdScatter(Editor& editor)
{
    if (m_scatterStroke && !editor.document()->inGesture()) m_scatterStroke.reset(); // undone or saved meanwhile: it is a step already
    if (!m_scatterStroke) return;
    if (pressed(Key::Escape)) {
        m_scatterStroke->cancel();
        m_scatterStroke.reset();
        m_drag = Drag::None;
    } else if (const ImVec2 moved = ImGui::GetIO().MouseDelta; m_brushAt && (moved.x != 0 || moved.y != 0)) {
        m_scatterStroke->to(*m_brushAt);
    }
    editor.follow();
}

void Viewport::endScatter(Editor& editor)
{
    if (!m_scatterStroke) return;
    m_scatterStroke->end();
    const ScatterBrush brush = m_scatterStroke->brush();
    const std::vector<glm::dvec3> way = m_scatterStroke->way();
    m_scatterStroke.reset();
    const io::ScatterLayer* layer = scatterTarget(*editor.document());
    if (!layer || brush.mode != ScatterMode::Plant || brush.target != ScatterTarget::Instances) return;
    const io::InstanceTiles& tiles = editor.document()->scene().instances(layer->id);
    const bool bare = std::ranges::all_of(way, [&](const glm::dvec3& at) { return countIn(tiles, PlantRegion::disc({at.x, at.z}, double(brush.radius))) == 0; });
    if (bare) editor.toasts().add(io::log::Level::Warning, tr("message.nothing_grows"));
}

// On meshes where the layer grows on them; plants themselves are looked through.
void Viewport::updateScatter(Editor& editor)
{
    if (!scattering) return;
    m_brushAt.reset();
    if (m_drag != Drag::None && m_drag != Drag::Scatter) return;
    if (!m_hovered && m_drag != Drag::Scatter) return;
    const io::ScatterLayer* layer = scatterTarget(*editor.document());
    if (layer && layer->meshes) {
        for (const PickHit& hit : editor.picker().pickAll(view(), pointer()))
            if (!m_brushAt && (hit.surface == Surface::Terrain || editor.document()->scene().find(hit.id))) m_brushAt = hit.position;
    } else if (const PickHit hit = editor.picker().pick(view(), pointer(), {.objects = false, .maxDistance = kFarthest}); hit.surface == Surface::Terrain) {
        m_brushAt = hit.position;
    }
    if (m_drag == Drag::None && pressed(Key::Escape)) scattering = false;
}

void Viewport::addScatterLines(const Editor& editor, std::vector<renderer::Line>& lines) const
{
    if (!scattering || !m_brushAt) return;
    const io::HeightMap* map = editor.document()->scene().heights().get();
    const ScatterMode mode = m_scatterStroke ? m_scatterStroke->brush().mode : modeNow(scatterBrush.mode);
    const bool spot = mode == ScatterMode::Single || mode == ScatterMode::Lasso;
    addRing(lines, map, camera.camera().eye, *m_brushAt, spot ? 0.5 : double(scatterBrush.radius), colourOf(mode));
    if (!m_scatterStroke || mode != ScatterMode::Lasso) return;
    const std::vector<glm::dvec3>& way = m_scatterStroke->way();
    const glm::dvec3 lift{0, 0.1, 0};
    for (std::size_t i = 1; i < way.size(); ++i)
        lines.push_back({.from = way[i - 1] + lift, .to = way[i] + lift, .colour = kGrow, .onTop = true});
    if (!way.empty()) lines.push_back({.from = way.back() + lift, .to = way.front() + lift, .colour = {glm::vec3{kGrow}, 0.4f}, .onTop = true});
}

} // namespace editor
