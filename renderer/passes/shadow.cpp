#include "renderer/passes/shadow.h"

#include "renderer/shaders/shared/bindings.h"

#include <algorithm>

namespace renderer {
namespace {

constexpr float kErrorTexels = 1.0f; // how far what casts a shadow may stray from its full model
constexpr float kLeastSway = 0.5f;   // texels

// Whether something came, went or moved whose shadow may fall into a cascade.
bool touched(const World& world, const Volume& volume)
{
    return std::ranges::any_of(world.touched(), [&](const glm::dvec4& sphere) {
        return std::ranges::all_of(volume.planes, [&](const glm::dvec4& plane) {
            return glm::dot(glm::dvec3{plane}, glm::dvec3{sphere}) + plane.w + sphere.w >= 0;
        });
    });
}

bool swaysIn(const DrawList& list)
{
    return std::ranges::any_of(list.opaque, &DrawRange::swaying);
}

// Where the GPU culls, its list has a range for all that could sway.
bool mayBeSeen(const Scenery& scenery, const Viewpoint& viewpoint, const CullRequest& request)
{
    return glsl::windReach(glsl::windMost(viewpoint.wind), scenery.world.mostSway()) > request.swayLength;
}

} // namespace

ShadowPass::ShadowPass(ShaderLibrary& shaders)
    : m_masked{shaders, "shadow", {"SHADOW"}, kFeatureMask | kFeatureUvTransform | kFeatureImpostor},
      m_solid{shaders.program({.label = "shadow of solids",
                               .stages = {"objects.vert.glsl", "empty.frag.glsl"},
                               .defines = {"POSITION_ONLY"}})},
      m_solidSwaying{shaders.program({.label = "shadow of solids that sway",
                                      .stages = {"objects.vert.glsl", "empty.frag.glsl"},
                                      .defines = {"POSITION_ONLY", "WIND"}})},
      m_ground{shaders.program({.label = "shadow of the ground", .stages = {"terrain.vert.glsl", "empty.frag.glsl"}})},
      m_objects{makeObjectVertexArray()},
      m_lit{{.label = "no shadow", .size = {1, 1}, .layers = 1, .format = GL_DEPTH_COMPONENT32F, .compare = true}}, m_shaders{shaders}
{
    const float lit = 1;
    glClearTexImage(m_lit.id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, &lit);
}

void ShadowPass::resize(int resolution, int layers)
{
    if (m_maps.size() == glm::ivec2{resolution} && m_maps.layers() == layers) return;
    m_maps = gl::Texture{{.label = "shadow maps",
                          .size = glm::ivec2{resolution},
                          .layers = layers,
                          .format = GL_DEPTH_COMPONENT32F,
                          .compare = true}};
    m_layers.clear();
    for (int layer = 0; layer < layers; ++layer)
        m_layers.emplace_back(gl::FramebufferDesc{.label = "shadow cascade", .depth = &m_maps, .depthLayer = layer});
    m_keys.assign(std::size_t(layers), {});
    while (m_choosers.size() < std::size_t(layers))
        m_choosers.push_back(std::make_unique<ViewChooser>(m_shaders));
}

const gl::Texture& ShadowPass::render(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, const Settings& settings)
{
    const auto scope = gpu.scope("shadows");
    gpu.bind({{GROUND_SHADOW_UNIT, &scenery.groundShadow.texture()}});
    if (viewpoint.cascades.empty()) {
        gpu.bind({{SHADOW_UNIT, &m_lit}});
        return m_lit;
    }
    resize(capped(scenery.environment.shadows, settings).resolution, int(viewpoint.cascades.size()));
    for (std::size_t i = 0; i < viewpoint.cascades.size(); ++i) {
        const Cascade& cascade = viewpoint.cascades[i];
        Key key{.snapped = cascade.snapped,
                      .radius = cascade.radius,
                      .towardSun = viewpoint.towardSun,
                      .world = scenery.world.revision(),
                      .terrain = scenery.terrain.revision(),
                      .culling = settings.culling,
                      .lod = settings.lod,
                      .wind = {viewpoint.wind.towards, viewpoint.wind.speed, viewpoint.wind.gustiness}};
        if (m_keys[i].time) key.time = viewpoint.time;
        if (key == m_keys[i] && !touched(scenery.world, cascade.volume)) continue;
        const bool sways = renderCascade(gpu, scenery, viewpoint, i, settings);
        key.time = sways ? std::optional{viewpoint.time} : std::nullopt;
        m_keys[i] = key;
    }
    scenery.world.forgetTouched();
    gpu.constants(VIEW_BINDING, viewpoint.view);
    gpu.bind({{SHADOW_UNIT, &m_maps}});
    return m_maps;
}

bool ShadowPass::renderCascade(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, std::size_t index,
                               const Settings& settings)
{
    const Cascade& cascade = viewpoint.cascades[index];
    glsl::View view = viewpoint.view;
    view.clipFromRelative = glm::mat4{cascade.clipFromRelative};
    view.pixelAngle = float(cascade.texel);
    gpu.constants(VIEW_BINDING, view);
    m_layers[index].clearDepth(1);
    m_layers[index].bind();

    // Slopes are pushed away from the light by part of their own depth range over a texel.
    gl::DrawState state{.depthTest = GL_LESS, .depthWrite = true, .depthClamp = true, .depthOffset = {1.25f, 2.0f}};
    const std::optional<Volume> volume = settings.culling ? std::optional{cascade.volume} : std::nullopt;
    const CullRequest request{.volume = volume,
                              .towardSun = viewpoint.towardSun,
                              .smallestRadius = float(cascade.texel * 0.5),
                              .errorLength = settings.lod ? float(cascade.texel) * kErrorTexels : 0.0f,
                              .impostors = true,
                              .wind = viewpoint.wind,
                              .swayLength = float(cascade.texel) * kLeastSway,
                              .required = CULL_CASTS_SHADOW};
    const std::vector<DrawList> lists = m_choosers[index]->choose(gpu, scenery, request, settings, false);
    m_layers[index].bind();
    gpu.constants(VIEW_BINDING, view);
    for (const DrawList& list : lists)
        drawRanges(gpu, m_objects, list, list.opaque, [&](const DrawRange& range, const Batch& batch) {
            const bool masked = batch.features & (kFeatureMask | kFeatureImpostor);
            gl::apply(state);
            if (masked) bindArrays(gpu, *list.models, batch);
            const gl::Program& solid = range.swaying ? m_solidSwaying : m_solid;
            return gpu.use(masked ? m_masked.of(batch, false, range.swaying) : solid);
        });

    const bool sways = mayBeSeen(scenery, viewpoint, request) && std::ranges::any_of(lists, swaysIn);
    if (!scenery.terrain.present() || !gpu.use(m_ground)) return sways;
    const Terrain::Draw ground = scenery.terrain.draws(gpu.stream(), volume);
    gl::apply(state);
    scenery.terrain.bind(gpu, false);
    scenery.terrain.draw(gpu, ground);
    return sways;
}

} // namespace renderer
