#include "renderer/shaders/shared/bindings.h"
#include "renderer/state.h"
#include "renderer/wind.h"

#include <algorithm>

namespace renderer {
namespace {

constexpr int kLargestSide = 16384;      // pixels; every OpenGL 4.5 has textures of that size
constexpr double kSmallestPixels = 0.6; // diameter under which an object is left out
constexpr double kLeastSway = 0.5;      // pixels

} // namespace

// The frame, top to bottom. A pass takes what it reads and returns what it makes, so the data flow is the argument
// lists; a pass that adds to an image takes that image by reference.
Picture Renderer::State::render(const FrameInput& in)
{
    shaders.reloadIfDue();
    GpuFrame gpu{stream, timers, stats, empty};
    scenery.groundShadow.update(scenery.terrain.heights(), io::towardSun(scenery.environment));
    const Viewpoint viewpoint = look(in);
    canvas.resize("picture", viewpoint.eye.size);
    scenery.world.select(in.selection);
    scenery.world.upload(culledOnGpu(in.settings));
    impostors.render(gpu, scenery.world.sharedModels(), scenery.world.impostors());
    gpu.constants(VIEW_BINDING, viewpoint.view);
    gpu.constants(LIGHT_BINDING, viewpoint.light);

    skyTables.update(gpu, viewpoint.light);
    scenery.terrain.aim(viewpoint.eye, in.settings.lod ? std::max(in.settings.lodPixels, 1.0f) : 1.0f);
    shadow.render(gpu, scenery, viewpoint, in.settings);
    const GeometryPass::Drawn drawn = drawSurfaces(gpu, in, viewpoint);
    const GBuffer& surfaces = geometry.finish();

    Radiance& hdr = lighting.render(gpu, surfaces, viewpoint, in.settings);
    sky.render(gpu, hdr, viewpoint);
    transparent.render(gpu, hdr, surfaces, scenery, viewpoint, drawn.objects, in.ghosts, in.settings);
    radiance = &hdr;

    if (in.show == Show::Final) {
        toneMap.render(gpu, canvas, hdr, in.settings);
        overlay.render(gpu, canvas, surfaces, viewpoint, scenery.world.boundsOf(in.selection), in.lines);
    } else {
        show.render(gpu, canvas, in.show, hdr, surfaces, scenery, viewpoint, drawn);
    }
    stats.gpuBytes = gl::Footprint::total();
    return {.texture = canvas.texture.id(), .size = canvas.texture.size()};
}

Viewpoint Renderer::State::look(const FrameInput& in) const
{
    io::Environment environment = scenery.environment;
    environment.shadows = capped(environment.shadows, in.settings);
    Viewpoint v;
    v.time = in.time;
    v.eye = eyeOf(in.camera, glm::clamp(in.size, 1, kLargestSide));
    v.towardSun = io::towardSun(environment);
    v.wind = windOf(environment.wind, in.settings.wind, v.eye.position, in.time);
    v.view = viewBlock(v.eye, v.eye.clipFromRelative, in.time, environment.exposure);
    const bool sunUp = v.towardSun.y > -0.02;
    if (in.settings.shadows && sunUp) v.cascades = cascadesOf(v.eye, environment.shadows, v.towardSun);
    v.light = lightOf({.environment = environment,
                       .settings = in.settings,
                       .eye = v.eye,
                       .time = in.time,
                       .cascades = v.cascades,
                       .groundShadow = scenery.groundShadow.placement(v.eye.position)});
    return v;
}

// The objects and the ground that the camera sees, into the GBuffer. Objects first: the ground, whose pixels cost more,
// is then drawn only where it shows.
GeometryPass::Drawn Renderer::State::drawSurfaces(GpuFrame& gpu, const FrameInput& in, const Viewpoint& viewpoint)
{
    const Eye& eye = viewpoint.eye;
    const std::optional<Volume> volume = in.settings.culling ? std::optional{volumeOf(eye)} : std::nullopt;
    const CullRequest request{.volume = volume,
                              .eye = eye.position,
                              .smallestAngle = float(kSmallestPixels / 2 * viewpoint.view.pixelAngle),
                              .errorAngle = in.settings.lod ? in.settings.lodPixels * viewpoint.view.pixelAngle : 0.0f,
                              .impostors = true,
                              .wind = viewpoint.wind,
                              .swayAngle = float(kLeastSway * viewpoint.view.pixelAngle),
                              .refused = in.markers ? 0u : CULL_MARKER};
    const bool occlusion = in.settings.culling && in.settings.occlusion && culledOnGpu(in.settings);
    GeometryPass::Drawn drawn;
    {
        const auto scope = gpu.scope("cull");
        drawn.objects = chooser.choose(gpu, scenery, request, in.settings, occlusion);
        drawn.ground = scenery.terrain.draws(gpu.stream(), volume);
    }
    {
        const auto scope = gpu.scope("geometry");
        geometry.begin(viewpoint);
        for (const DrawList& list : drawn.objects)
            geometry.drawObjects(gpu, list);
        geometry.drawGround(gpu, scenery, drawn.ground);
    }
    if (occlusion) {
        const auto scope = gpu.scope("what came into sight");
        const gl::Texture& farthest = pyramid.make(gpu, geometry.targets().depth);
        drawn.objects.push_back(chooser.chooseRest(gpu, scenery, request, farthest));
        geometry.drawObjects(gpu, drawn.objects.back());
    }
    count(drawn);
    return drawn;
}

void Renderer::State::count(const GeometryPass::Drawn& drawn)
{
    const glsl::CullCounts& counts = chooser.counts();
    stats.instances = scenery.world.instances();
    stats.instancesDrawn = counts.drawn;
    stats.instancesInside = counts.inside;
    stats.instancesHidden = counts.hidden;
    stats.trianglesDrawn = drawn.ground.triangles;
    for (const DrawList& list : drawn.objects)
        for (std::size_t level = 0; level < MOST_LEVELS; ++level) {
            stats.trianglesOfLevel[level] += list.trianglesOfLevel[level];
            stats.trianglesDrawn += list.trianglesOfLevel[level];
        }
}

} // namespace renderer
