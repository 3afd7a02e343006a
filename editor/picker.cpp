#include "editor/picker.h"

#include "editor/ray_scene.h"
#include "editor/terrain_ray.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace editor {

struct Picker::State {
    RayScene objects;
    std::shared_ptr<const io::HeightMap> heights;
    std::shared_ptr<const io::CoverMap> cover;
    std::optional<TerrainRay> ground; // made at the first ray after the heights changed

    const TerrainRay& terrain()
    {
        if (!ground) {
            ground.emplace(heights);
            ground->setCover(cover);
        }
        return *ground;
    }
};

Picker::Picker() : m_state{std::make_unique<State>()} {}
Picker::~Picker() = default;

void Picker::update(const io::Scene& scene, const io::Assets& assets, const io::Changes& changes)
{
    m_state->objects.update(scene, assets, changes);
    const auto& heights = scene.heights();
    const bool fits = heights && scene.cover() && scene.cover()->size() == heights->size;
    m_state->cover = fits ? scene.cover() : nullptr;
    if (m_state->ground) m_state->ground->setCover(m_state->cover);
    if (m_state->heights == heights) return;
    const bool rebuilt = changes.everything || !heights || !m_state->heights || heights->size != m_state->heights->size;
    m_state->heights = heights;
    if (rebuilt) m_state->ground.reset();
    if (m_state->ground && changes.heights.empty()) m_state->ground->update(heights, {}); // it only lies elsewhere
    for (const io::TexelRect& changed : changes.heights)
        if (m_state->ground) m_state->ground->update(heights, changed);
}

const TerrainRay& Picker::ground() const
{
    static const TerrainRay none;
    return m_state->heights ? m_state->terrain() : none;
}

void Picker::prepare()
{
    m_state->objects.prepare();
    if (m_state->heights) m_state->terrain();
}

void Picker::setBoxesOnly(bool boxesOnly)
{
    m_state->objects.setBoxesOnly(boxesOnly);
}
bool Picker::boxesOnly() const
{
    return m_state->objects.boxesOnly();
}
io::WorldBox Picker::bounds(io::ObjectId id) const
{
    return m_state->objects.bounds(id);
}

PickHit Picker::pick(const io::Ray& ray, const PickOptions& options) const
{
    PickHit best;
    double reach = options.maxDistance;
    if (options.terrain && m_state->heights) {
        if (const auto ground = m_state->terrain().hit(ray, reach)) {
            best = {.surface = Surface::Terrain,
                    .position = ground->position,
                    .normal = ground->normal,
                    .distance = ground->distance};
            reach = ground->distance;
        }
    }
    if (options.objects) {
        std::vector<io::ObjectId> skip(options.skip.begin(), options.skip.end());
        std::ranges::sort(skip);
        if (const PickHit object = m_state->objects.hit(ray, reach, skip, options.pixelWidth);
            object && object.distance <= reach)
            best = object;
    }
    return best;
}

double pixelWidth(const View& view)
{
    return 2 * std::tan(glm::radians(double(view.camera.fov)) / 2) / std::max(view.size.y, 1);
}

PickHit Picker::pick(const View& view, glm::dvec2 pixel, PickOptions options) const
{
    options.pixelWidth = editor::pixelWidth(view);
    return pick(rayThrough(view, pixel), options);
}

std::vector<PickHit> Picker::pickAll(const View& view, glm::dvec2 pixel, std::size_t max) const
{
    return pickAll(rayThrough(view, pixel), max, {.pixelWidth = editor::pixelWidth(view)});
}

std::vector<PickHit> Picker::pickAll(const io::Ray& ray, std::size_t max, const PickOptions& options) const
{
    std::vector<PickHit> hits;
    std::vector<io::ObjectId> skip(options.skip.begin(), options.skip.end());
    while (hits.size() < max) {
        PickOptions next = options;
        next.skip = skip;
        next.terrain = false;
        const PickHit hit = pick(ray, next);
        if (!hit) break;
        hits.push_back(hit);
        skip.push_back(hit.id);
    }
    PickOptions groundOnly = options;
    groundOnly.objects = false;
    if (const PickHit ground = pick(ray, groundOnly)) hits.push_back(ground);
    std::ranges::stable_sort(hits, {}, &PickHit::distance);
    if (hits.size() > max) hits.resize(max);
    return hits;
}

namespace {

// The four sides of what is seen in a rectangle of the picture, a little wider; inside is where dot(n, p) + d >= 0.
std::array<glm::dvec4, 4> sidesOf(const View& view, glm::dvec2 low, glm::dvec2 high)
{
    low -= 0.01;
    high += 0.01;
    const glm::dvec3 eye = view.camera.eye;
    const glm::dvec3 inwards = rayThrough(view, (low + high) * 0.5).direction;
    const std::array<glm::dvec2, 4> corners{low, {high.x, low.y}, high, {low.x, high.y}};
    std::array<glm::dvec4, 4> sides;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3 along = rayThrough(view, corners[i]).direction,
                         next = rayThrough(view, corners[(i + 1) % 4]).direction;
        const glm::dvec3 n = glm::cross(along, next);
        sides[i] = glm::dvec4{n, -glm::dot(n, eye)} * (glm::dot(n, inwards) < 0 ? -1.0 : 1.0);
    }
    return sides;
}

} // namespace

std::vector<io::ObjectId> Picker::pickBox(const View& view, const PixelRect& rect,
                                          std::optional<std::span<const std::uint32_t>> seen) const
{
    std::vector<io::ObjectId> ids;
    if (seen) {
        for (const std::uint32_t number : *seen)
            if (m_state->objects.holds(io::ObjectId{number})) ids.push_back(io::ObjectId{number});
    } else {
        const glm::dvec2 low = glm::min(rect.from, rect.to), high = glm::max(rect.from, rect.to);
        m_state->objects.forEachInside(sidesOf(view, low, high), [&](io::ObjectId id, const io::WorldBox& box) {
            const auto pixel = project(view, box.centre());
            if (pixel && pixel->x >= low.x && pixel->y >= low.y && pixel->x <= high.x && pixel->y <= high.y)
                ids.push_back(id);
        });
    }
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
}

PickHit ClickCycle::next(std::span<const PickHit> hits, glm::dvec2 pixel)
{
    // The ground counts only where nothing is before it: behind a tree, the next click means the next tree.
    std::vector<PickHit> offered;
    for (const PickHit& hit : hits)
        if (hit.surface != Surface::Terrain || offered.empty()) offered.push_back(hit);
    std::vector<io::ObjectId> ids;
    for (const PickHit& hit : offered)
        ids.push_back(hit.id);

    const bool again = !ids.empty() && ids == m_ids && glm::distance(pixel, m_pixel) <= kSamePlace;
    m_index = again ? (m_index + 1) % ids.size() : 0;
    if (!again) m_pixel = pixel;
    m_ids = std::move(ids);
    return offered.empty() ? PickHit{} : offered[m_index];
}

} // namespace editor
