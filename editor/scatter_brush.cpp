#include "editor/scatter_brush.h"

#include "editor/scatter.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

constexpr double kSpacing = 0.3;  // radii between dabs
constexpr double kCorner = 0.5;   // m between corners of a lasso

glm::dvec2 flat(const glm::dvec3& point)
{
    return {point.x, point.z};
}

// Another pattern each time, and the same for the same history.
io::ScatterLayer reseeded(io::ScatterLayer layer, std::uint64_t revision)
{
    layer.seed = std::uint32_t(layer.seed * 2654435761u + std::uint32_t(revision) + 1);
    return layer;
}

io::ScatterLayer layerOf(const io::Scene& scene, io::ScatterId id)
{
    const io::ScatterLayer* layer = scene.find(id);
    return layer ? *layer : io::ScatterLayer{};
}

} // namespace

ScatterMode modeWith(ScatterMode mode, bool erases, bool thins)
{
    return erases ? ScatterMode::Erase : thins ? ScatterMode::Thin : mode;
}

ScatterStroke::ScatterStroke(Document& document, const Picker& picker, ScatterBrush brush, io::ScatterId layer, std::string name)
    : m_document{document}, m_brush{brush}, m_layer{layerOf(document.scene(), layer)}, m_name{std::move(name)},
      m_planting{plantingOf(document, brush.mode == ScatterMode::Reseed ? reseeded(m_layer, document.revision()) : m_layer, &picker)}
{
    m_gesture.emplace(m_document, m_name);
}

LayerTiles ScatterStroke::tiles() const
{
    LayerTiles tiles = layerTiles(m_document.scene(), m_layer);
    if (m_brush.species < 0) return tiles;
    tiles.species.resize(m_layer.species.size());
    if (std::size_t(m_brush.species) < tiles.species.size()) tiles.species[std::size_t(m_brush.species)] = true;
    return tiles;
}

std::vector<io::TemplateId> ScatterStroke::meant() const
{
    std::vector<io::TemplateId> ids;
    for (std::size_t i = 0; i < m_layer.species.size(); ++i)
        if (m_brush.species < 0 || m_brush.species == int(i))
            if (const io::TemplateId id = m_document.scene().findTemplate(m_layer.species[i].templateName); id != io::TemplateId::None) ids.push_back(id);
    return ids;
}

void ScatterStroke::to(const glm::dvec3& point)
{
    const bool begins = m_way.empty();
    const glm::dvec2 last = flat(begins ? point : m_way.back());
    if (m_brush.mode == ScatterMode::Single) {
        if (begins) plantOne(point);
        m_way = {point};
        return;
    }
    if (m_brush.mode == ScatterMode::Lasso) {
        if (begins || glm::distance(last, flat(point)) >= kCorner) m_way.push_back(point);
        return;
    }
    m_way = {point};
    const double spacing = double(m_brush.radius) * kSpacing;
    if (begins) {
        dab(last);
        m_toNext = spacing;
        return;
    }
    const glm::dvec2 way = flat(point) - last;
    const double length = glm::length(way);
    if (length == 0) return;
    double at = m_toNext;
    for (; at <= length; at += spacing)
        dab(last + way * (at / length));
    m_toNext = at - length;
}

void ScatterStroke::dab(const glm::dvec2& at)
{
    work(PlantRegion::disc(at, double(m_brush.radius)));
}

void ScatterStroke::work(const PlantRegion& region)
{
    if (m_brush.target == ScatterTarget::Objects) return workOnObjects(region);
    InstanceSlots slots;
    switch (m_brush.mode) {
    case ScatterMode::Plant:
    case ScatterMode::Lasso: slots = planted(layerTiles(m_document.scene(), m_layer), m_planting, region); break;
    case ScatterMode::Erase: slots = erased(tiles(), region); break;
    case ScatterMode::Thin: slots = thinned(tiles(), region, double(m_brush.share)); break;
    case ScatterMode::Reseed:
        setInstances(m_document, m_name, erased(layerTiles(m_document.scene(), m_layer), region));
        slots = planted(layerTiles(m_document.scene(), m_layer), m_planting, region);
        break;
    case ScatterMode::Replace:
        if (m_brush.species >= 0 && m_brush.instead >= 0)
            slots = replaced(layerTiles(m_document.scene(), m_layer), m_planting.rules(), region, std::uint8_t(m_brush.species), std::uint8_t(m_brush.instead));
        break;
    case ScatterMode::Single: break;
    }
    if (!slots.empty()) setInstances(m_document, m_name, std::move(slots));
}

void ScatterStroke::workOnObjects(const PlantRegion& region)
{
    const io::Scene& scene = m_document.scene();
    switch (m_brush.mode) {
    case ScatterMode::Plant:
    case ScatterMode::Lasso: scatter(m_document, m_name, m_planting, region); break;
    case ScatterMode::Erase: removeObjects(m_document, m_name, scatteredIn(scene, meant(), region)); break;
    case ScatterMode::Thin: removeObjects(m_document, m_name, thinnedOut(scene, scatteredIn(scene, meant(), region), double(m_brush.share))); break;
    case ScatterMode::Reseed:
        removeObjects(m_document, m_name, scatteredIn(scene, meant(), region));
        scatter(m_document, m_name, m_planting, region);
        break;
    case ScatterMode::Replace: {
        if (m_brush.species < 0 || std::size_t(m_brush.instead) >= m_layer.species.size()) break;
        const io::TemplateId other = scene.findTemplate(m_layer.species[std::size_t(m_brush.instead)].templateName);
        if (scene.find(other)) edit(m_document, m_name, scatteredIn(scene, meant(), region), [&](io::Object& object) { object.templateId = other; });
        break;
    }
    case ScatterMode::Single: break;
    }
}

// One of the mix where the pointer is, whatever the rules say.
void ScatterStroke::plantOne(const glm::dvec3& point)
{
    const auto plant = m_planting.one(point, m_document.revision());
    if (!plant) return;
    if (m_brush.target == ScatterTarget::Objects) {
        const io::TemplateId what = m_planting.rules().kinds[plant->kind].templateId;
        addObjects(m_document, m_name, {{.id = m_document.freshId(), .templateId = what, .transform = plant->transform}});
        return;
    }
    const io::PlacedInstance placed = io::instanceAt(plant->transform, int(plant->kind), io::kPaintedInstance);
    const io::LayerTile where{m_layer.id, placed.tile};
    const io::InstanceTile* before = m_document.scene().find(where);
    io::InstanceTile tile = before ? *before : io::InstanceTile{};
    tile.instances.push_back(placed.instance);
    setInstances(m_document, m_name, {{where, std::make_shared<const io::InstanceTile>(std::move(tile))}});
}

void ScatterStroke::cancel()
{
    if (m_gesture) m_gesture->cancel();
    m_gesture.reset();
}

void ScatterStroke::end()
{
    if (m_gesture && m_document.inGesture() && m_brush.mode == ScatterMode::Lasso && m_way.size() > 2) {
        std::vector<glm::dvec2> corners;
        std::ranges::transform(m_way, std::back_inserter(corners), flat);
        work(PlantRegion::polygon(std::move(corners)));
    }
    m_gesture.reset();
}

} // namespace editor
