#include "io/scene/footprint.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace io {
namespace {

constexpr float kSlice = 0.3f;      // m above the origin, up to where a mesh meets what grows
constexpr float kFinest = 0.04f;    // m a texel
constexpr float kMostTexels = 96;   // along a side

using Outline = std::vector<glm::vec2>; // of a convex piece; may have no area

// What of a triangle lies below `top`, from above.
Outline below(const std::array<glm::vec3, 3>& corners, float top)
{
    Outline outline;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3 &a = corners[i], &b = corners[(i + 1) % 3];
        if (a.y <= top) outline.emplace_back(a.x, a.z);
        if ((a.y <= top) == (b.y <= top)) continue;
        const glm::vec3 cut = glm::mix(a, b, (top - a.y) / (b.y - a.y));
        outline.emplace_back(cut.x, cut.z);
    }
    return outline;
}

// Separating axes (Gottschalk et al. 1996): no normal of an edge tells the square and the outline apart.
bool meets(const Outline& outline, glm::vec2 centre, float half)
{
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::vec2 edge = outline[(i + 1) % outline.size()] - outline[i], axis{-edge.y, edge.x};
        float low = 0, high = 0;
        for (const glm::vec2& corner : outline) {
            const float at = glm::dot(corner - centre, axis);
            low = &corner == outline.data() ? at : std::min(low, at);
            high = &corner == outline.data() ? at : std::max(high, at);
        }
        const float reach = half * (std::abs(axis.x) + std::abs(axis.y));
        if (low > reach || high < -reach) return false;
    }
    return true;
}

struct Raster {
    glm::vec2 low;
    glm::ivec2 size;
    float texel;
    std::vector<bool> set = std::vector<bool>(std::size_t(size.x) * std::size_t(size.y));

    std::size_t indexOf(int x, int z) const { return std::size_t(z) * std::size_t(size.x) + std::size_t(x); }
    void draw(const Outline& outline)
    {
        if (outline.size() < 2) return;
        glm::vec2 from = outline[0], to = outline[0];
        for (const glm::vec2& corner : outline)
            from = glm::min(from, corner), to = glm::max(to, corner);
        const glm::ivec2 first = glm::clamp(glm::ivec2{glm::floor((from - low) / texel)}, glm::ivec2{0}, size - 1);
        const glm::ivec2 last = glm::clamp(glm::ivec2{glm::floor((to - low) / texel)}, glm::ivec2{0}, size - 1);
        for (int z = first.y; z <= last.y; ++z)
            for (int x = first.x; x <= last.x; ++x)
                if (!set[indexOf(x, z)] && meets(outline, low + (glm::vec2{x, z} + 0.5f) * texel, texel * 0.5f)) set[indexOf(x, z)] = true;
    }
    // Texels that one gets to from outside without crossing any that is set.
    std::vector<bool> outside() const
    {
        std::vector<bool> seen(set.size());
        std::vector<glm::ivec2> open;
        const auto enter = [&](glm::ivec2 at) {
            if (at.x < 0 || at.y < 0 || at.x >= size.x || at.y >= size.y || seen[indexOf(at.x, at.y)] || set[indexOf(at.x, at.y)]) return;
            seen[indexOf(at.x, at.y)] = true;
            open.push_back(at);
        };
        for (int x = 0; x < size.x; ++x)
            enter({x, 0}), enter({x, size.y - 1});
        for (int z = 0; z < size.y; ++z)
            enter({0, z}), enter({size.x - 1, z});
        while (!open.empty()) {
            const glm::ivec2 at = open.back();
            open.pop_back();
            for (const glm::ivec2 step : {glm::ivec2{1, 0}, glm::ivec2{-1, 0}, glm::ivec2{0, 1}, glm::ivec2{0, -1}})
                enter(at + step);
        }
        return seen;
    }
};

// Leaves and other cut-outs are nothing to grow around.
template <class Visit> void eachSolid(const Model& model, Visit&& visit)
{
    for (const Part& part : model.parts) {
        if (model.materials[std::size_t(part.material)].alphaMode != AlphaMode::Opaque) continue;
        for (std::uint32_t i = part.firstIndex; i + 2 < part.firstIndex + part.indexCount; i += 3)
            visit(std::array{model.vertices[model.indices[i]].position, model.vertices[model.indices[i + 1]].position,
                             model.vertices[model.indices[i + 2]].position});
    }
}

} // namespace

FootprintShape::FootprintShape(const Template& what, const Model& model)
{
    if (what.footprintShape == Footprint::None || what.model.empty()) return; // markers are not there
    radius = what.footprint;
    if (what.footprintShape == Footprint::Box) addBox(model);
    if (what.footprintShape == Footprint::Mesh) addMesh(model);
}

void FootprintShape::addBox(const Model& model)
{
    m_low = {model.bounds.min.x, model.bounds.min.z};
    m_high = {model.bounds.max.x, model.bounds.max.z};
    m_texel = std::max({m_high.x - m_low.x, m_high.y - m_low.y, kFinest});
    m_size = glm::max(glm::ivec2{glm::ceil((m_high - m_low) / m_texel)}, glm::ivec2{1});
    m_covered.assign(std::size_t(m_size.x) * std::size_t(m_size.y), true);
}

void FootprintShape::addMesh(const Model& model)
{
    glm::vec2 low{1e30f}, high{-1e30f};
    eachSolid(model, [&](const std::array<glm::vec3, 3>& corners) {
        for (const glm::vec2& corner : below(corners, kSlice))
            low = glm::min(low, corner), high = glm::max(high, corner);
    });
    if (low.x > high.x) return;
    m_texel = std::max(std::max(high.x - low.x, high.y - low.y) / kMostTexels, kFinest);
    Raster slice{low, glm::max(glm::ivec2{glm::ceil((high - low) / m_texel)}, glm::ivec2{1}), m_texel};
    Raster whole = slice;
    eachSolid(model, [&](const std::array<glm::vec3, 3>& corners) {
        slice.draw(below(corners, kSlice));
        whole.draw({{corners[0].x, corners[0].z}, {corners[1].x, corners[1].z}, {corners[2].x, corners[2].z}});
    });
    // Many rocks and trunks have no underside: what they enclose and cover is inside, a courtyard is not.
    const std::vector<bool> outside = slice.outside();
    m_covered = slice.set;
    for (std::size_t i = 0; i < m_covered.size(); ++i)
        if (!outside[i] && whole.set[i]) m_covered[i] = true;
    m_size = slice.size;
    m_low = low;
    m_high = low + glm::vec2{m_size} * m_texel;
}

bool FootprintShape::covers(glm::vec2 point, float reach) const
{
    if (m_covered.empty()) return false;
    const glm::ivec2 first{glm::floor((point - reach - m_low) / m_texel)}, last{glm::floor((point + reach - m_low) / m_texel)};
    for (int z = std::max(first.y, 0); z <= std::min(last.y, m_size.y - 1); ++z)
        for (int x = std::max(first.x, 0); x <= std::min(last.x, m_size.x - 1); ++x)
            if (m_covered[std::size_t(z) * std::size_t(m_size.x) + std::size_t(x)]) return true;
    return false;
}

} // namespace io
