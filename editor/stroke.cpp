#include "editor/stroke.h"

#include "editor/painting.h"
#include "editor/scatter_steps.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

constexpr double kSpacing = 0.2;      // radii between dabs
constexpr double kStampSpacing = 1.5; // a stamp should not blur itself
constexpr double kRestingDabs = 12;   // a second
constexpr float kFarthest = 1e5f;     // m, up and down
constexpr double kCell = 32;          // m

std::int64_t cellKey(std::int64_t x, std::int64_t z)
{
    return x * 0x100000000ll + z;
}

std::int64_t cellOf(double metres)
{
    return std::int64_t(std::floor(metres / kCell));
}

} // namespace

BrushTool toolWith(BrushTool tool, const StrokeKeys& keys)
{
    if (keys.smooths && shapes(tool)) return BrushTool::Smooth;
    if (!keys.inverted) return tool;
    switch (tool) {
    case BrushTool::Raise: return BrushTool::Lower;
    case BrushTool::Lower: return BrushTool::Raise;
    case BrushTool::Paint: return BrushTool::Erase;
    case BrushTool::Grow: return BrushTool::Mow;
    default: return tool;
    }
}

Stroke::Stroke(Document& document, Brush brush, StrokeKeys keys, std::string name)
    : m_document{document}, m_brush{std::move(brush)}, m_keys{keys}, m_name{std::move(name)}
{
    m_brush.tool = toolWith(m_brush.tool, keys);
    m_gesture.emplace(m_document, m_name);
}

Stroke::~Stroke() = default;

float Stroke::amountOf(const Brush& brush)
{
    const float strength = std::clamp(brush.strength, 0.0f, 1.0f);
    switch (brush.tool) {
    case BrushTool::Raise:
    case BrushTool::Lower: return strength * strength * brush.radius * 0.08f; // wide brushes make high hills
    case BrushTool::Noise: return strength * strength * brush.scale * 0.06f;
    case BrushTool::Stamp: return strength * brush.radius;
    case BrushTool::Ramp:
    case BrushTool::Replace:
    case BrushTool::Hole: return 1;
    default: return strength;
    }
}

void Stroke::to(const glm::dvec3& point)
{
    if (!m_last) {
        m_start = m_last = point;
        m_level = m_brush.levelGiven ? double(m_brush.level) : point.y;
        if (m_brush.tool != BrushTool::Ramp) dab({point.x, point.z});
        m_toNext = m_brush.radius * (m_brush.tool == BrushTool::Stamp ? kStampSpacing : kSpacing);
        return;
    }
    const double spacing = m_brush.radius * (m_brush.tool == BrushTool::Stamp ? kStampSpacing : kSpacing);
    const glm::dvec2 from{m_last->x, m_last->z}, way = glm::dvec2{point.x, point.z} - from;
    const double length = glm::length(way);
    m_last = point;
    if (length == 0 || m_brush.tool == BrushTool::Ramp) return;
    m_rested = 0;
    double at = m_toNext;
    for (; at <= length; at += spacing)
        dab(from + way * (at / length));
    m_toNext = at - length;
}

void Stroke::rest(double seconds)
{
    if (!m_last || m_brush.tool == BrushTool::Ramp || m_brush.tool == BrushTool::Stamp) return;
    m_rested += seconds;
    for (; m_rested >= 1 / kRestingDabs; m_rested -= 1 / kRestingDabs)
        dab({m_last->x, m_last->z});
}

void Stroke::dab(const glm::dvec2& at)
{
    const auto& map = m_document.scene().heights();
    if (!map) return;
    float amount = amountOf(m_brush);
    if (m_keys.inverted && (m_brush.tool == BrushTool::Noise || m_brush.tool == BrushTool::Stamp || m_brush.tool == BrushTool::Hole)) amount = -amount;
    if (!shapes(m_brush.tool)) return paint({.centre = at, .amount = amount});
    const auto patch = dabOn(*map, m_brush, {.centre = at, .amount = amount, .level = m_level, .number = m_dabs++});
    if (patch) change(*patch);
}

void Stroke::paint(const Dab& dab)
{
    const io::Scene& scene = m_document.scene();
    if (growsGrass(m_brush.tool)) {
        if (const auto patch = growOn(*scene.heights(), grassMapOf(scene), m_brush, dab)) changeGrassMap(m_document, m_name, *patch);
        return;
    }
    if (const auto patch = paintOn(*scene.heights(), coverOf(scene), m_brush, dab)) {
        changeCover(m_document, m_name, *patch);
        touch({dab.centre - double(m_brush.radius), dab.centre + double(m_brush.radius)});
    }
}

void Stroke::change(const HeightPatch& patch)
{
    const std::shared_ptr<const io::HeightMap> before = m_document.scene().heights();
    io::HeightGrid heights = patch.heights; // within what a file can hold; not a number is no change
    for (int z = 0; z < heights.size.y; ++z)
        for (int x = 0; x < heights.size.x; ++x) {
            float& metres = heights.at(x, z);
            metres = std::isfinite(metres) ? std::clamp(metres, -kFarthest, kFarthest) : before->at(patch.at.x + x, patch.at.y + z);
        }
    setHeights(m_document, m_name, std::make_shared<const io::HeightMap>(before->with(heights, patch.at)), patch.rect());
    if (m_keys.objectsFollow) lift(patch, *before);
    const double beyond = before->metresPerTexel; // triangles reach to the next texel
    const glm::dvec2 low = heights.origin - beyond, high = heights.origin + glm::dvec2{heights.size} * heights.metresPerTexel + beyond;
    if (m_keys.objectsFollow) liftPlants(m_document, m_name, *before, {low, high});
    touch({low, high});
}

void Stroke::touch(const PlaneRect& part)
{
    m_touched = m_touched ? PlaneRect{glm::min(m_touched->low, part.low), glm::max(m_touched->high, part.high)} : part;
}

void Stroke::findObjects()
{
    m_objectsFound = true;
    for (const io::Object& object : m_document.scene().objects())
        m_objects[cellKey(cellOf(object.transform.position.x), cellOf(object.transform.position.z))].push_back(object.id);
}

void Stroke::lift(const HeightPatch& patch, const io::HeightMap& before)
{
    if (!m_objectsFound) findObjects();
    const io::HeightMap& now = *m_document.scene().heights();
    const glm::dvec2 low = patch.heights.origin, high = low + glm::dvec2{patch.heights.size - 1} * patch.heights.metresPerTexel;
    const auto rise = [&](const io::Object& object) {
        const glm::dvec3& p = object.transform.position;
        const auto old = before.height(p.x, p.z), risen = now.height(p.x, p.z);
        return old && risen ? *risen - *old : 0.0;
    };
    std::vector<io::ObjectId> ids;
    for (std::int64_t z = cellOf(low.y - before.metresPerTexel); z <= cellOf(high.y + before.metresPerTexel); ++z)
        for (std::int64_t x = cellOf(low.x - before.metresPerTexel); x <= cellOf(high.x + before.metresPerTexel); ++x) {
            const auto cell = m_objects.find(cellKey(x, z));
            if (cell == m_objects.end()) continue;
            std::ranges::copy_if(cell->second, std::back_inserter(ids), [&](io::ObjectId id) {
                const io::Object* object = m_document.scene().find(id);
                return object && rise(*object) != 0;
            });
        }
    if (ids.empty()) return;
    edit(m_document, m_name, ids, [&](io::Object& object) { object.transform.position.y += rise(object); });
}

void Stroke::cancel()
{
    if (m_gesture) m_gesture->cancel();
    m_gesture.reset();
}

void Stroke::end()
{
    const auto& map = m_document.scene().heights();
    if (map && m_gesture && m_brush.tool == BrushTool::Ramp && m_start && m_last)
        if (const auto patch = rampOn(*map, m_brush, *m_start, *m_last, 1)) change(*patch);
    if (m_gesture && m_touched && m_document.inGesture()) followRules(m_document, m_name, *m_touched);
    m_gesture.reset();
}

} // namespace editor
