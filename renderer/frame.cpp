#include "renderer/clouds.h"
#include "renderer/debug_lines.h"
#include "renderer/film.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/shaders/shared/lamps.h"
#include "renderer/state.h"
#include "renderer/wind.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr int kLargestSide = 16384;      // pixels; every OpenGL 4.5 has textures of that size
constexpr double kSmallestPixels = 0.6; // diameter under which an object is left out
constexpr double kLeastSway = 0.5;      // pixels
constexpr double kLongestStep = 20;     // m between frames of one flight; what is farther is a cut
constexpr double kWidestTurn = 40;      // degrees, likewise

// EV that eyes used to the dark add to the exposure by hand, from a sun 7 degrees high to 7 below the horizon: light falls by
// a factor of a thousand there, and no exposure shows both ends.
float usedToTheDark(const glm::dvec3& towardSun)
{
    constexpr double kMost = 5; // EV
    const double height = std::sin(glm::radians(7.0));
    return float(kMost * glm::smoothstep(height, -height, towardSun.y));
}

bool needsLight(Show show) // or only what surfaces are
{
    switch (show) {
    case Show::Albedo:
    case Show::Normal:
    case Show::Roughness:
    case Show::Depth:
    case Show::Position:
    case Show::Id:
    case Show::Ao:
    case Show::ShadowMaps: return false;
    default: return true;
    }
}

bool exposesItself(const Settings& settings, const Viewpoint& viewpoint)
{
    return settings.autoExposure && viewpoint.autoExposure.on;
}

} // namespace

// The frame, top to bottom. A pass takes what it reads and returns what it makes, so the data flow is the argument
// lists; a pass that adds to an image takes that image by reference.
Picture Renderer::State::render(const FrameInput& in)
{
    shaders.reloadIfDue();
    if (in.alone) last.reset(), exposure.forget(), shadow.forget();
    GpuFrame gpu{stream, timers, stats, empty};
    const io::Environment& environment = in.environment ? *in.environment : scenery.environment;
    scenery.groundShadow.update(scenery.terrain.heights(), inSteps(bodiesOf(environment).towardLight()));
    if (!in.freezeCulling) frozen.reset();
    const Viewpoint viewpoint = look(in, environment);
    canvas.resize("picture", viewpoint.eye.size);
    scenery.world.select(in.selection);
    const std::uint64_t uploaded = scenery.world.uploadedBytes();
    scenery.world.upload(culledOnGpu(in.settings));
    impostors.render(gpu, scenery.world.sharedModels(), scenery.world.impostors());
    gpu.constants(VIEW_BINDING, viewpoint.view);
    gpu.constants(LIGHT_BINDING, viewpoint.light);
    gpu.constants(SHADOWS_BINDING, viewpoint.shadows);
    gpu.constants(HEAVENS_BINDING, viewpoint.heavens);

    const glsl::Clouds cloudy = cloudsOf(environment, viewpoint.light, viewpoint.eye, in.time);
    skyTables.begin(gpu);
    clouds.update(gpu, cloudy, in.settings.cloudKind, in.alone);
    skyTables.update(gpu, viewpoint.light, viewpoint.heavens, cloudy, in.alone);
    scenery.terrain.aim(viewpoint.eye, viewpoint.culledFor, in.settings.lod ? in.settings.lodPixels : 1.0f);
    if (in.settings.grass && scenery.grass.present()) scenery.footprints.update(scenery.world, scenery.terrain, viewpoint.eye.position, double(in.settings.grassDistance));
    lamps.render(gpu, scenery, viewpoint, in.settings);
    shadow.render(gpu, scenery, viewpoint, in.settings);
    if (exposesItself(in.settings, viewpoint)) exposure.bind(gpu, viewpoint.view);
    else exposure.forget();
    const GeometryPass::Drawn drawn = drawSurfaces(gpu, in, viewpoint);
    grass.render(gpu, geometry, drawn, scenery, viewpoint, environment, in.pressers, in.settings);
    const GBuffer& surfaces = geometry.finish();

    const bool lit = needsLight(in.show);
    if (lit || in.show == Show::Ao) occlusion.render(gpu, surfaces, viewpoint.eye, viewpoint.occlusion, in.settings);
    Radiance& hdr = lit ? lighting.render(gpu, surfaces, viewpoint, in.settings) : lighting.unlit(surfaces);
    if (lit) sky.render(gpu, hdr, viewpoint, in.settings, clouds.areInSky());
    if (lit && !clouds.areBelow()) clouds.render(gpu, hdr, surfaces, in.settings);
    if (lit) shafts.render(gpu, hdr, surfaces, viewpoint, in.settings);
    if (lit) water.render(gpu, hdr, surfaces, environment, viewpoint, in.settings);
    if (lit && clouds.areBelow()) clouds.render(gpu, hdr, surfaces, in.settings);
    transparent.render(gpu, hdr, surfaces, scenery, viewpoint, drawn.objects, in.ghosts, in.settings);
    if (lit) particles.render(gpu, hdr, surfaces, scenery, environment.wind, viewpoint, in.settings);
    if (lit) precipitation.render(gpu, hdr, surfaces, environment, viewpoint, in.settings);
    radiance = lit ? &hdr : nullptr;
    if (lit) expose(gpu, in, hdr, surfaces, viewpoint);

    const bool final = in.show == Show::Final;
    if (final) develop(gpu, in, hdr, surfaces, viewpoint);
    else show.render(gpu, canvas, in.show, hdr, surfaces, scenery, viewpoint, drawn, in.settings);
    const std::span<const io::ObjectId> outlined = final ? in.selection : std::span<const io::ObjectId>{};
    overlay.render(gpu, canvas, surfaces, viewpoint, scenery.world.boundsOf(outlined), linesOf(in, viewpoint));
    exposureByHand = std::log2(double(viewpoint.still.exposure));
    stats.gathering = viewpoint.gathered && *viewpoint.gathered < kTemporalFrames;
    last = {viewpoint.eye, in.time, viewpoint.gathered};
    stats.cullingFrozen = in.freezeCulling;
    if (in.freezeCulling && !frozen) frozen = {viewpoint.eye, occlusionOf(in.settings) != Occlusion::Off};
    stats.uploadedBytes = stream.taken() + scenery.world.uploadedBytes() - uploaded;
    countMemory();
    return {.texture = canvas.texture.id(), .size = canvas.texture.size()};
}

Viewpoint Renderer::State::look(const FrameInput& in, io::Environment environment) const
{
    environment.shadows = capped(environment.shadows, in.settings);
    Viewpoint v;
    v.time = in.time;
    v.eye = eyeOf(in.camera, glm::clamp(in.size, 1, kLargestSide));
    v.culledFor = frozen ? frozen->eye : v.eye;
    v.frozen = frozen.has_value();
    v.bodies = bodiesOf(environment);
    v.towardSun = v.bodies.towardLight();
    v.shadowsToward = inSteps(v.towardSun);
    v.heavens = heavensOf(environment, v.bodies);
    v.wind = windOf(environment.wind, in.settings.wind, v.eye.position, in.time);
    if (!environment.autoExposure.on || !in.settings.autoExposure) environment.exposure += usedToTheDark(v.bodies.towardSun);
    v.still = viewBlock(v.eye, v.eye.clipFromRelative, in.time, environment.exposure);
    v.gathered = gathered(in, v.eye);
    v.view = in.ids || !v.gathered ? v.still : movedAside(v.still, v.eye, jitterOf(*v.gathered, v.eye.size));
    v.autoExposure = environment.autoExposure;
    v.grading = environment.grading;
    v.occlusion = environment.occlusion;
    if (in.settings.lamps) v.lamps = scenery.lamps.inView(v.eye, MOST_LAMPS);
    v.light = lightOf({.environment = environment,
                       .settings = in.settings,
                       .eye = v.eye,
                       .bodies = v.bodies,
                       .time = in.time,
                       .groundShadow = scenery.groundShadow.placement(v.eye.position)});
    if (in.settings.shadows && sunReaches(v.light)) v.cascades = cascadesOf(v.eye, environment.shadows, v.shadowsToward, v.light.sunRadius);
    v.shadows = shadowConstants(environment.shadows, v.cascades, v.shadowsToward);
    addShafts(v, environment.fog, in.settings);
    return v;
}

// Whether this frame is the next picture of the same film: nothing that was gathered or adapted to outlives a cut.
bool Renderer::State::goesOn(const Eye& eye) const
{
    return last && last->eye.size == eye.size && last->eye.tanHalfFov == eye.tanHalfFov &&
           glm::distance(last->eye.position, eye.position) < kLongestStep &&
           glm::dot(last->eye.forward, eye.forward) > std::cos(glm::radians(kWidestTurn));
}

// How many frames before this one it can be gathered with; none when it is not to be.
std::optional<int> Renderer::State::gathered(const FrameInput& in, const Eye& eye) const
{
    if (in.settings.antiAliasing != AntiAliasing::Taa || in.show != Show::Final) return std::nullopt;
    return goesOn(eye) && last->gathered ? *last->gathered + 1 : 0;
}

// Binds the camera's block for what makes a picture of light: not moved aside, with the exposure of this very frame. It
// follows the light as time goes on; where time stands still it is there at once, so that a still picture depends on
// nothing that was before.
void Renderer::State::expose(GpuFrame& gpu, const FrameInput& in, const Radiance& hdr, const GBuffer& surfaces, const Viewpoint& viewpoint)
{
    if (!exposesItself(in.settings, viewpoint)) return gpu.constants(VIEW_BINDING, viewpoint.still);
    std::optional<double> seconds;
    if (goesOn(viewpoint.eye) && in.time > last->time) seconds = in.time - last->time;
    exposure.choose(gpu, hdr, surfaces, viewpoint.still, viewpoint.autoExposure, seconds);
}

// From light to the picture that is shown.
void Renderer::State::develop(GpuFrame& gpu, const FrameInput& in, const Radiance& hdr, const GBuffer& surfaces, const Viewpoint& viewpoint)
{
    const Settings& settings = in.settings;
    const glsl::Film film = filmOf(viewpoint.grading, settings, in.time);
    if (!viewpoint.gathered) temporal.forget();
    const gl::Texture& light =
        viewpoint.gathered ? temporal.render(gpu, hdr, surfaces, viewpoint.eye, last ? last->eye : viewpoint.eye, *viewpoint.gathered) : hdr.texture;
    const bool spared = settings.skyPixels > 1; // a machine that pays for each tap
    const gl::Texture* scattered = film.bloom > 0 ? &bloom.render(gpu, light, spared) : nullptr;
    PictureTarget& rough = smoothing.begin(canvas, settings.antiAliasing);
    toneMap.render(gpu, rough,
                   {.radiance = light, .bloom = scattered, .surfaces = surfaces, .film = film, .chosenExposure = exposure.chosen()},
                   settings);
    smoothing.finish(gpu, canvas, settings.antiAliasing);
}

Occlusion Renderer::State::occlusionOf(const Settings& settings) const
{
    if (!settings.culling || !settings.occlusion || !culledOnGpu(settings)) return Occlusion::Off;
    if (!frozen) return Occlusion::SeenBefore;
    return frozen->looked ? Occlusion::Kept : Occlusion::Off;
}

// The objects and the ground that the camera sees, into the GBuffer. Objects first: the ground, whose pixels cost more,
// is then drawn only where it shows.
GeometryPass::Drawn Renderer::State::drawSurfaces(GpuFrame& gpu, const FrameInput& in, const Viewpoint& viewpoint)
{
    const Eye& eye = viewpoint.culledFor;
    const auto pixel = float(pixelAngle(eye));
    const std::optional<Volume> volume = in.settings.culling ? std::optional{volumeOf(eye)} : std::nullopt;
    const CullRequest request{.volume = volume,
                              .eye = eye.position,
                              .smallestAngle = float(kSmallestPixels / 2 * pixel),
                              .errorAngle = in.settings.lod ? in.settings.lodPixels * pixel : 0.0f,
                              .impostors = true,
                              .meshLeeway = in.settings.meshLeeway,
                              .sortedFor = viewpoint.eye.position,
                              .wind = viewpoint.wind,
                              .swayAngle = float(kLeastSway * pixel),
                              .refused = in.markers ? 0u : CULL_MARKER};
    // Which of two passes draws a thing goes by what was seen before, and where surfaces touch that can be seen.
    const Occlusion occlusion = in.alone && !frozen ? Occlusion::Off : occlusionOf(in.settings);
    stats.occlusionTested = occlusion != Occlusion::Off;
    GeometryPass::Drawn drawn;
    {
        const auto scope = gpu.scope("cull");
        drawn.objects = chooser.choose(gpu, scenery, request, in.settings, occlusion);
        drawn.ground = scenery.terrain.draws(gpu.stream(), volume, in.settings.terrain);
    }
    {
        const auto scope = gpu.scope("geometry");
        geometry.begin(viewpoint, in.ids || in.show == Show::Id);
        for (const DrawList& list : drawn.objects)
            geometry.drawObjects(gpu, list);
        geometry.drawGround(gpu, scenery, drawn.ground, in.settings);
    }
    if (occlusion == Occlusion::SeenBefore) {
        const auto scope = gpu.scope("what came into sight");
        drawn.farthest = &pyramid.make(gpu, geometry.targets().depth);
        drawn.objects.push_back(chooser.chooseRest(gpu, scenery, request, *drawn.farthest));
        geometry.drawObjects(gpu, drawn.objects.back());
    }
    count(drawn);
    return drawn;
}

// What is drawn into the world beside what the editor asks for.
std::vector<Line> Renderer::State::linesOf(const FrameInput& in, const Viewpoint& viewpoint) const
{
    std::vector<Line> lines;
    if (in.show == Show::Final) lines.assign(in.lines.begin(), in.lines.end());
    if (viewpoint.frozen) {
        io::WorldBox bounds = scenery.world.bounds();
        bounds.add(scenery.terrain.bounds());
        addFrustum(lines, viewpoint.culledFor, bounds);
    }
    if (in.show == Show::Nodes) {
        const std::vector<const InstanceTree*> trees = scenery.world.trees();
        addNodes(lines, trees, viewpoint.eye, viewpoint.frozen ? std::optional{volumeOf(viewpoint.culledFor)} : std::nullopt);
    }
    if (in.show == Show::ShadowBoxes) {
        addCascades(lines, viewpoint.cascades, viewpoint.eye, viewpoint.shadowsToward, !viewpoint.frozen);
        const Eye& frozenEye = viewpoint.culledFor;
        const io::Shadows shadows = capped(scenery.environment.shadows, in.settings);
        if (viewpoint.frozen && !viewpoint.cascades.empty())
            addCascades(lines, cascadesOf(frozenEye, shadows, viewpoint.shadowsToward, viewpoint.light.sunRadius), frozenEye, viewpoint.shadowsToward, true);
    }
    return lines;
}

void Renderer::State::count(const GeometryPass::Drawn& drawn)
{
    const glsl::CullCounts& counts = chooser.counts();
    stats.instances = scenery.world.instances();
    stats.instancesDrawn = counts.drawn;
    stats.instancesInside = counts.inside;
    stats.instancesLarge = counts.large;
    stats.instancesHidden = counts.hidden;
    stats.trianglesDrawn = 0;
    for (const Terrain::Draw& part : drawn.ground)
        stats.trianglesDrawn += part.triangles;
    for (std::size_t level = 0; level < MOST_LEVELS; ++level) {
        std::uint64_t triangles = counts.triangles[level]; // the GPU's, that of lists the CPU's
        for (const DrawList& list : drawn.objects)
            triangles += list.trianglesOfLevel[level];
        stats.trianglesOfLevel[level] = triangles;
        stats.trianglesDrawn += triangles;
    }
}

void Renderer::State::countMemory()
{
    using gl::Footprint, gl::MemoryKind;
    stats.gpuMemory = {.textures = Footprint::total(MemoryKind::Textures),
                       .buffers = Footprint::total(MemoryKind::Buffers),
                       .shadowMaps = Footprint::total(MemoryKind::ShadowMaps),
                       .targets = Footprint::total(MemoryKind::Targets)};
    stats.gpuBytes = Footprint::total();
}

} // namespace renderer
