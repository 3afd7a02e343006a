#include "renderer/passes/shadow.h"

#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr float kLeastSway = 2;      // texels; the maps' filter is as wide
constexpr double kSwayStep = 0.04;   // s, for each cascade before it: what sways far away may lag a little
constexpr float kMeshLeeway = 2;           // texels are blurred over three; but a flat caster hides nothing of itself
constexpr float kGroundErrorTexels = 0.5f; // how far the ground may stray, which is its own nearest receiver
constexpr double kNearlyAll = 0.75;        // of a window's texels: parts that make up more are drawn as one

// What a layer lacks of its cascade's window. Few and large parts cost less than many small ones that overlap.
std::vector<io::TexelRect> missing(const io::TexelRect& window, const io::TexelRect& held, std::span<const io::TexelRect> stale)
{
    std::vector<io::TexelRect> parts = without(window, held);
    io::TexelRect all;
    for (const io::TexelRect& rect : stale)
        all = around(all, common(rect, window));
    if (!all.empty()) parts.push_back(all);
    const auto texels = [](const io::TexelRect& rect) { return double(rect.high.x - rect.low.x) * double(rect.high.y - rect.low.y); };
    double sum = 0;
    for (const io::TexelRect& part : parts)
        sum += texels(part);
    return sum > kNearlyAll * texels(window) ? std::vector{window} : parts;
}

// The wind's time that a cascade's shadows stand for: the farther, the fewer times a second.
double timeFor(std::size_t index, double time)
{
    return index == 0 ? time : std::floor(time / (kSwayStep * double(index))) * (kSwayStep * double(index));
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

gl::Handle<DeleteSampler> samplerOfNumbers()
{
    GLuint id = 0;
    glCreateSamplers(1, &id);
    glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    constexpr std::string_view kLabel = "shadow maps as numbers";
    glObjectLabel(GL_SAMPLER, id, GLsizei(kLabel.size()), kLabel.data());
    return gl::Handle<DeleteSampler>{id};
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
      m_objects{makeObjectVertexArray()},
      m_lit{{.label = "no shadow", .size = {1, 1}, .layers = 1, .format = GL_DEPTH_COMPONENT32F, .compare = true}},
      m_asNumbers{samplerOfNumbers()}, m_shaders{shaders}
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
                          .wrap = GL_REPEAT,
                          .compare = true}};
    m_layers.clear();
    for (int layer = 0; layer < layers; ++layer)
        m_layers.push_back({.target = gl::Framebuffer{{.label = "shadow cascade", .depth = &m_maps, .depthLayer = layer}}});
}

ViewChooser& ShadowPass::nextChooser()
{
    if (m_pieces == m_choosers.size()) m_choosers.push_back(std::make_unique<ViewChooser>(m_shaders));
    return *m_choosers[m_pieces++];
}

const gl::Texture& ShadowPass::render(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, const Settings& settings)
{
    const auto scope = gpu.scope("shadows");
    gpu.bind({{GROUND_SHADOW_UNIT, &scenery.groundShadow.texture()}});
    if (viewpoint.cascades.empty()) {
        gpu.bind({{SHADOW_UNIT, &m_lit}});
        for (Layer& layer : m_layers) // nobody keeps account of what moves
            layer.window = {};
        scenery.world.forgetTouched();
        scenery.terrain.forgetTouched();
        return m_lit;
    }
    resize(viewpoint.cascades.front().resolution, int(viewpoint.cascades.size()));
    m_pieces = 0;
    for (std::size_t i = 0; i < viewpoint.cascades.size(); ++i)
        update(gpu, scenery, viewpoint, i, settings);
    scenery.world.forgetTouched();
    scenery.terrain.forgetTouched();
    glDisable(GL_SCISSOR_TEST);
    gpu.constants(VIEW_BINDING, viewpoint.view);
    glBindSampler(SHADOW_DEPTH_UNIT, m_asNumbers.get()); // nothing else is bound there
    gpu.bind({{SHADOW_UNIT, &m_maps}, {SHADOW_DEPTH_UNIT, &m_maps}});
    return m_maps;
}

void ShadowPass::update(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, std::size_t index, const Settings& settings)
{
    const Cascade& cascade = viewpoint.cascades[index];
    Layer& layer = m_layers[index];
    Key key{.texel = cascade.texel,
            .bottom = cascade.bottom,
            .depthRange = cascade.depthRange,
            .towardSun = viewpoint.shadowsToward,
            .world = scenery.world.revision(),
            .terrain = scenery.terrain.revision(),
            .culling = settings.culling,
            .lodPixels = settings.lod ? settings.lodPixels : 0.0f,
            .wind = {viewpoint.wind.towards, viewpoint.wind.speed, viewpoint.wind.gustiness}};
    if (layer.key.time) key.time = timeFor(index, viewpoint.time);
    if (!(key == layer.key)) layer.window = {};
    std::vector<io::TexelRect> stale;
    for (const std::span<const glm::dvec4> spheres : {scenery.world.touched(), scenery.terrain.touched()})
        for (const glm::dvec4& sphere : spheres)
            stale.push_back(shadowOf(cascade, sphere, viewpoint.shadowsToward));
    bool sways = !layer.window.empty() && key.time;
    for (const io::TexelRect& part : missing(cascade.window(), layer.window, stale))
        for (const CascadePiece& piece : piecesOf(cascade, part, viewpoint.eye.position, viewpoint.shadowsToward))
            sways |= draw(gpu, scenery, viewpoint, cascade, layer, piece, settings);
    layer.key = key;
    layer.key.time = sways ? std::optional{timeFor(index, viewpoint.time)} : std::nullopt;
    layer.window = cascade.window();
}

bool ShadowPass::draw(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, const Cascade& cascade, const Layer& layer,
                      const CascadePiece& piece, const Settings& settings)
{
    glsl::View view = viewpoint.view;
    view.clipFromRelative = glm::mat4{piece.clipFromRelative};
    view.pixelAngle = float(cascade.texel);
    const std::optional<Volume> volume = settings.culling ? std::optional{piece.casters} : std::nullopt;
    const CullRequest request{.volume = volume,
                              .towardSun = viewpoint.shadowsToward,
                              .smallestRadius = float(cascade.texel * 0.5),
                              .errorLength = settings.lod ? float(cascade.texel) * std::max(settings.lodPixels, 1.0f) : 0.0f,
                              .impostors = true,
                              .meshLeeway = kMeshLeeway,
                              .wind = viewpoint.wind,
                              .swayLength = float(cascade.texel) * kLeastSway,
                              .required = CULL_CASTS_SHADOW};
    const std::vector<DrawList> lists = nextChooser().choose(gpu, scenery, request, settings, Occlusion::Off);

    glEnable(GL_SCISSOR_TEST);
    glScissor(piece.at.x, piece.at.y, piece.size.x, piece.size.y);
    layer.target.clearDepth(1);
    layer.target.bind();
    gpu.constants(VIEW_BINDING, view);
    // Slopes are pushed away from the light by part of their own depth range over a texel.
    const gl::DrawState state{.depthTest = GL_LESS, .depthWrite = true, .depthClamp = true, .depthOffset = {1.25f, 2.0f}};
    for (const DrawList& list : lists)
        drawRanges(gpu, m_objects, list, list.opaque, [&](const DrawRange& range, const Batch& batch) {
            gl::apply(state);
            if (hasHoles(batch)) bindArrays(gpu, *list.models, batch);
            const gl::Program& solid = range.swaying ? m_solidSwaying : m_solid;
            return gpu.use(hasHoles(batch) ? m_masked.of(batch, false, range.swaying) : solid);
        });

    const bool sways = mayBeSeen(scenery, viewpoint, request) && std::ranges::any_of(lists, swaysIn);
    const char* fragment = scenery.terrain.holed() ? "terrain_shadow.frag.glsl" : "empty.frag.glsl";
    if (!scenery.terrain.present() || !gpu.use(m_shaders.program(scenery.terrain.program("shadow of the ground", GroundStages::Grid, fragment)))) return sways;
    const Terrain::Draw ground = scenery.terrain.shadowDraw(gpu.stream(), volume, cascade.texel * kGroundErrorTexels);
    gl::apply(state);
    scenery.terrain.bindForShadows(gpu);
    scenery.terrain.draw(gpu, ground);
    return sways;
}

} // namespace renderer
