#include "renderer/passes/lamp_shadows.h"

#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace renderer {
namespace {

constexpr int kTilesAcross = 8;     // of the atlas
constexpr double kBorder = 2;       // texels of a tile beyond the lamp's cone or a cube's face, for the filter
constexpr double kNearest = 0.05;   // m; what is closer to the lamp is its own glass
constexpr double kWidestSpot = 60;  // degrees from the axis; wider ones are drawn as a cube

int facesOf(const Lamp& lamp)
{
    return lamp.isSpot() && lamp.outer <= glm::radians(kWidestSpot) ? 1 : 6;
}

double tanHalfOf(const Lamp& lamp)
{
    return facesOf(lamp) == 1 ? std::tan(double(lamp.outer)) : 1.0;
}

struct FaceAxes {
    glm::dvec3 right, up, forward;
};

// Faces of a cube as lamps.glsl numbers them; a spot has one, along its axis.
FaceAxes axesOf(const Lamp& lamp, int face)
{
    glm::dvec3 forward{lamp.direction};
    if (facesOf(lamp) == 6) {
        forward = glm::dvec3{0};
        forward[face / 2] = face % 2 ? -1 : 1;
    }
    const glm::dvec3 aside = std::abs(forward.y) > 0.9 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    const glm::dvec3 right = glm::normalize(glm::cross(forward, aside));
    return {right, glm::cross(right, forward), forward};
}

// Depth 0 at the nearest, 1 at the range.
glm::dmat4 clipFromLamp(const Lamp& lamp, const FaceAxes& axes, int tile)
{
    const double scale = (tile - 2 * kBorder) / (tile * tanHalfOf(lamp));
    const double far = std::max(double(lamp.range), 2 * kNearest);
    const double z = far / (far - kNearest);
    glm::dmat4 clip{0};
    for (int i = 0; i < 3; ++i)
        clip[i] = {axes.right[i] * scale, axes.up[i] * scale, axes.forward[i] * z, axes.forward[i]};
    clip[3] = {0, 0, -kNearest * z, 0};
    return clip;
}

glm::ivec2 placeOf(int tile, int side)
{
    return glm::ivec2{tile % kTilesAcross, tile / kTilesAcross} * side;
}

glm::dmat4 atlasFromClip(int tile)
{
    const glm::dvec2 low = glm::dvec2{tile % kTilesAcross, tile / kTilesAcross} / double(kTilesAcross);
    const double half = 0.5 / kTilesAcross;
    return glm::translate(glm::dmat4{1}, glm::dvec3{low + half, 0}) * glm::scale(glm::dmat4{1}, glm::dvec3{half, half, 1});
}

Volume volumeOf(const Lamp& lamp, const FaceAxes& axes, int tile)
{
    const double t = tanHalfOf(lamp) * tile / (tile - 2 * kBorder);
    const auto through = [&](const glm::dvec3& normal) {
        const glm::dvec3 n = glm::normalize(normal);
        return glm::dvec4{n, -glm::dot(n, lamp.place)};
    };
    const glm::dvec3 f = axes.forward * t;
    const glm::dvec4 end{-axes.forward, glm::dot(axes.forward, lamp.place) + double(lamp.range)};
    return {{through(f + axes.right), through(f - axes.right), through(f + axes.up), through(f - axes.up), end}};
}

bool reaches(const Lamp& lamp, const glm::dvec4& sphere)
{
    return glm::distance(lamp.place, glm::dvec3{sphere}) < double(lamp.range) + sphere.w;
}

} // namespace

LampShadows::LampShadows(ShaderLibrary& shaders)
    : m_shaders{shaders}, m_masked{shaders, "shadow", {"SHADOW"}, kFeatureMask | kFeatureUvTransform},
      m_solid{shaders.program({.label = "shadow of solids",
                               .stages = {"objects.vert.glsl", "empty.frag.glsl"},
                               .defines = {"POSITION_ONLY"}})},
      m_objects{makeObjectVertexArray()},
      m_none{{.label = "no shadow of a lamp", .size = {1, 1}, .format = GL_DEPTH_COMPONENT32F, .compare = true}}
{
}

void LampShadows::resize(int tile)
{
    if (m_tile == tile) return;
    m_tile = tile;
    m_atlas = gl::Texture{{.label = "shadows of lamps", .size = glm::ivec2{tile * kTilesAcross}, .format = GL_DEPTH_COMPONENT32F, .compare = true}};
    m_target = gl::Framebuffer{{.label = "shadows of lamps", .depth = &m_atlas}};
    m_held.clear();
    m_free.clear();
    for (int i = kTilesAcross * kTilesAcross; i-- > 0;)
        m_free.push_back(i);
}

LampShadows::Held* LampShadows::find(io::ObjectId object)
{
    const auto held = std::ranges::find(m_held, object, [](const Held& one) { return one.lamp.object; });
    return held == m_held.end() ? nullptr : &*held;
}

void LampShadows::markStale(const Scenery& scenery, const Settings& settings)
{
    const Key key{scenery.world.revision(), scenery.terrain.revision(), settings.lod ? settings.lodPixels : 0.0f};
    for (Held& held : m_held) {
        held.stale |= !(key == m_key);
        for (const std::span<const glm::dvec4> spheres : {scenery.world.touched(), scenery.terrain.touched()})
            held.stale |= std::ranges::any_of(spheres, [&](const glm::dvec4& sphere) { return reaches(held.lamp, sphere); });
    }
    m_key = key;
}

// Brightest first, until the tiles are gone. Who has some keeps them, so that a lamp's shadow is not drawn again.
void LampShadows::choose(std::span<const Lamp> lamps)
{
    std::size_t left = std::size_t(kTilesAcross) * kTilesAcross;
    std::vector<const Lamp*> chosen;
    for (const Lamp& lamp : lamps) {
        const auto faces = std::size_t(facesOf(lamp));
        if (!lamp.castShadow || faces > left) continue;
        left -= faces;
        chosen.push_back(&lamp);
    }
    for (Held& held : m_held)
        held.wanted = false;
    for (const Lamp* lamp : chosen)
        if (Held* held = find(lamp->object); held && int(held->tiles.size()) == facesOf(*lamp)) {
            held->stale |= !(held->lamp == *lamp);
            held->lamp = *lamp;
            held->wanted = true;
        }
    std::erase_if(m_held, [&](const Held& held) {
        if (!held.wanted) m_free.insert(m_free.end(), held.tiles.begin(), held.tiles.end());
        return !held.wanted;
    });
    for (const Lamp* lamp : chosen) {
        if (find(lamp->object)) continue;
        Held held{.lamp = *lamp, .wanted = true};
        for (int face = 0; face < facesOf(*lamp); ++face) {
            held.tiles.push_back(m_free.back());
            m_free.pop_back();
        }
        m_held.push_back(std::move(held));
    }
}

std::vector<LampShadow> LampShadows::render(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, std::span<const Lamp> lamps,
                                            const Settings& settings)
{
    markStale(scenery, settings);
    std::vector<LampShadow> shadows(lamps.size());
    if (!settings.shadows || std::ranges::none_of(lamps, &Lamp::castShadow)) return shadows;
    const auto scope = gpu.scope("shadows of lamps");
    resize(std::clamp(settings.largestShadowMap / 4, 64, 512));
    choose(lamps);

    bool drawn = false;
    for (Held& held : m_held) {
        if (!std::exchange(held.stale, false)) continue;
        for (std::size_t face = 0; face < held.tiles.size(); ++face)
            draw(gpu, scenery, viewpoint, held.lamp, int(face), held.tiles[face], settings);
        drawn = true;
    }
    if (drawn) {
        glDisable(GL_SCISSOR_TEST);
        gpu.constants(VIEW_BINDING, viewpoint.view);
    }
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        const Held* held = lamps[i].castShadow ? find(lamps[i].object) : nullptr;
        if (!held) continue;
        for (std::size_t face = 0; face < held->tiles.size(); ++face)
            shadows[i].atlasFromLamp.emplace_back(atlasFromClip(held->tiles[face]) *
                                                  clipFromLamp(held->lamp, axesOf(held->lamp, int(face)), m_tile));
        shadows[i].texelAngle = float(2 * tanHalfOf(held->lamp) / m_tile);
    }
    return shadows;
}

// Still air: what sways would have the map drawn anew in every frame. The lamp's own model lets its light out.
void LampShadows::draw(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, const Lamp& lamp, int face, int tile,
                       const Settings& settings)
{
    const FaceAxes axes = axesOf(lamp, face);
    const double texelAngle = 2 * tanHalfOf(lamp) / m_tile;
    glsl::View view = viewpoint.view;
    view.clipFromRelative = glm::mat4{clipFromLamp(lamp, axes, m_tile) *
                                      glm::translate(glm::dmat4{1}, viewpoint.eye.position - lamp.place)};
    const Volume volume = volumeOf(lamp, axes, m_tile);
    const CullRequest request{.volume = volume,
                              .eye = lamp.place,
                              .smallestAngle = float(texelAngle / 2),
                              .errorAngle = settings.lod ? float(texelAngle) * std::max(settings.lodPixels, 1.0f) : 0.0f,
                              .required = CULL_CASTS_SHADOW,
                              .leftOut = scenery.world.recordOf(lamp.object)};
    std::vector<DrawList> lists;
    scenery.world.batchedDraws(gpu.stream(), request, false, lists);
    scenery.world.directDraws(gpu.stream(), request, false, lists);

    const glm::ivec2 at = placeOf(tile, m_tile);
    glEnable(GL_SCISSOR_TEST);
    glScissor(at.x, at.y, m_tile, m_tile);
    m_target.clearDepth(1);
    m_target.bind();
    glViewport(at.x, at.y, m_tile, m_tile);
    gpu.constants(VIEW_BINDING, view);
    const gl::DrawState state{.depthTest = GL_LESS, .depthWrite = true, .depthOffset = {1.5f, 2.0f}};
    for (const DrawList& list : lists)
        drawRanges(gpu, m_objects, list, list.opaque, [&](const DrawRange&, const Batch& batch) {
            gl::apply(state);
            const bool masked = batch.features & kFeatureMask;
            if (masked) bindArrays(gpu, *list.models, batch);
            return gpu.use(masked ? m_masked.of(batch) : m_solid);
        });
    const char* fragment = scenery.terrain.holed() ? "terrain_shadow.frag.glsl" : "empty.frag.glsl";
    if (!scenery.terrain.present() || !gpu.use(m_shaders.program(scenery.terrain.program("shadow of the ground", GroundStages::Grid, fragment)))) return;
    const Terrain::Draw ground = scenery.terrain.shadowDraw(gpu.stream(), volume, texelAngle * lamp.range * 0.25);
    gl::apply(state);
    scenery.terrain.bindForShadows(gpu);
    scenery.terrain.draw(gpu, ground);
}

void LampShadows::bind(GpuFrame& gpu) const
{
    gpu.bind({{LAMP_SHADOW_UNIT, m_atlas ? &m_atlas : &m_none}});
}

} // namespace renderer
