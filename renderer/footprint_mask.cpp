#include "renderer/footprint_mask.h"

#include "renderer/shaders/shared/grass.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace renderer {
namespace {

constexpr double kTexel = double(GRASS_CELL);
constexpr double kReach = kTexel * 0.7072; // from a texel's centre to its corners
constexpr double kTall = 1e5;              // m: things at any height
constexpr double kAfloat = 0.6;            // m over the ground, from where on nothing is kept out of
constexpr std::int64_t kStep = 16;         // texels that the window moves by

// With one more on each side.
io::TexelRect texelsAround(const glm::dvec2& from, const glm::dvec2& to) // world, m
{
    return {io::Texel{glm::floor(from / kTexel)} - io::Texel{1}, io::Texel{glm::ceil(to / kTexel)} + io::Texel{1}};
}

} // namespace

void FootprintMask::update(const World& world, const Terrain& terrain, const glm::dvec3& eye, double distance)
{
    const auto side = int(std::bit_ceil(std::uint32_t(std::ceil(distance * 2 / kTexel)) + std::uint32_t(kStep)));
    if (side != m_side) {
        m_side = side;
        m_known = false;
        m_texture = gl::Texture{{.label = "footprints", .size = glm::ivec2{m_side}, .format = GL_R8, .filter = GL_NEAREST, .wrap = GL_REPEAT}};
        m_texels.assign(std::size_t(m_side) * std::size_t(m_side), 0);
    }
    const io::Texel middle = io::Texel{glm::floor(glm::dvec2{eye.x, eye.z} / kTexel / double(kStep))} * kStep, half{m_side / 2};
    const io::TexelRect window{middle - half, middle + half};
    const bool all = !m_known || world.revision() != m_worldRevision || terrain.revision() != m_terrainRevision;
    const io::TexelRect before = all ? io::TexelRect{} : m_window;
    m_window = window;
    m_known = true;
    m_worldRevision = world.revision();
    m_terrainRevision = terrain.revision();
    for (const io::TexelRect& part : io::without(window, before)) // what came in
        redraw(world, terrain, part);
    if (all) return;
    for (const std::span<const glm::dvec4> spheres : {world.touched(), terrain.touched()})
        for (const glm::dvec4& sphere : spheres) {
            const glm::dvec2 centre{sphere.x, sphere.z};
            redraw(world, terrain, common(window, texelsAround(centre - sphere.w, centre + sphere.w)));
        }
}

void FootprintMask::redraw(const World& world, const Terrain& terrain, const io::TexelRect& part)
{
    if (part.empty()) return;
    for (std::int64_t z = part.low.y; z < part.high.y; ++z)
        for (std::int64_t x = part.low.x; x < part.high.x; ++x)
            m_texels[indexOf({x, z})] = 0;
    const glm::dvec2 low = glm::dvec2{part.low} * kTexel, high = glm::dvec2{part.high} * kTexel;
    io::WorldBox box;
    box.add({low.x, -kTall, low.y});
    box.add({high.x, kTall, high.y});
    world.footprints(box, [&](const glsl::Instance& instance, const io::FootprintShape& shape) { draw(instance, shape, part, terrain); });
    send(part);
}

void FootprintMask::draw(const glsl::Instance& instance, const io::FootprintShape& shape, const io::TexelRect& part, const Terrain& terrain)
{
    const glm::dvec3 position = glm::dvec3{instance.positionHigh} + glm::dvec3{instance.positionLow};
    const auto& ground = terrain.heights();
    const auto height = ground ? ground->height(position.x, position.z) : std::nullopt;
    if (height && position.y > *height + kAfloat) return;
    const glm::dmat2 worldFromModel{glm::dvec2{instance.axisX.x, instance.axisX.z}, glm::dvec2{instance.axisZ.x, instance.axisZ.z}};
    if (std::abs(glm::determinant(worldFromModel)) < 1e-9) return;
    const glm::dmat2 modelFromWorld = glm::inverse(worldFromModel);
    const double scale = std::sqrt(std::abs(glm::determinant(worldFromModel)));
    const double radius = double(shape.radius) * scale;
    const glm::dvec2 at{position.x, position.z};
    glm::dvec2 from = at - radius, to = at + radius;
    if (shape.hasTexels())
        for (const glm::dvec2 corner : {glm::dvec2{shape.low()}, glm::dvec2{shape.high()}, glm::dvec2{shape.low().x, shape.high().y}, glm::dvec2{shape.high().x, shape.low().y}}) {
            from = glm::min(from, at + worldFromModel * corner);
            to = glm::max(to, at + worldFromModel * corner);
        }
    const io::TexelRect under = common(part, texelsAround(from, to));
    for (std::int64_t z = under.low.y; z < under.high.y; ++z)
        for (std::int64_t x = under.low.x; x < under.high.x; ++x) {
            const glm::dvec2 away = (glm::dvec2{x, z} + 0.5) * kTexel - at;
            const bool covered = (radius > 0 && glm::length(away) <= radius + kReach) || shape.covers(glm::vec2{modelFromWorld * away}, float(kReach / scale));
            if (covered) m_texels[indexOf({x, z})] = 255;
        }
}

void FootprintMask::send(const io::TexelRect& part)
{
    for (const io::TexelRect& piece : io::cutAtMultiples(part, m_side)) {
        const io::Texel at = piece.low & io::Texel{m_side - 1};
        m_texture.uploadPart(glm::ivec2{at}, glm::ivec2{piece.high - piece.low}, m_texels.data() + indexOf(at), GL_RED, GL_UNSIGNED_BYTE, 0, 0, m_side);
    }
}

bool FootprintMask::covers(const glm::dvec2& place) const
{
    return m_known && m_texels[indexOf(io::Texel{glm::floor(place / kTexel)})] > 0;
}

} // namespace renderer
