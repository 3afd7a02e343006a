// What a renderer owns: the mirror of the scene, the passes, and what the last frame left.
#pragma once

#include "renderer/choosing.h"
#include "renderer/gl/debug.h"
#include "renderer/impostor_baker.h"
#include "renderer/passes/geometry.h"
#include "renderer/passes/lighting.h"
#include "renderer/passes/overlay.h"
#include "renderer/passes/particles.h"
#include "renderer/passes/picture.h"
#include "renderer/passes/precipitation.h"
#include "renderer/passes/shadow.h"
#include "renderer/passes/sky_tables.h"
#include "renderer/passes/transparent.h"
#include "renderer/passes/water.h"
#include "renderer/renderer.h"
#include "renderer/scenery.h"
#include "renderer/thumbnails.h"

namespace renderer {

struct Renderer::State {
    explicit State(const Options& options);

    Picture render(const FrameInput& in);
    Viewpoint look(const FrameInput& in) const;
    Occlusion occlusionOf(const Settings& settings) const;
    std::vector<Line> linesOf(const FrameInput& in, const Viewpoint& viewpoint) const;
    GeometryPass::Drawn drawSurfaces(GpuFrame& gpu, const FrameInput& in, const Viewpoint& viewpoint);
    void count(const GeometryPass::Drawn& drawn);
    void countMemory();

    gl::DebugOutput debug;
    ShaderLibrary shaders;
    GpuStream stream;
    PassTimers timers;
    gl::VertexArray empty{"no vertices"};
    FrameStats stats;

    Scenery scenery;
    ImpostorBaker impostors;
    ViewChooser chooser; // the camera's
    DepthPyramid pyramid;
    SkyTables skyTables;
    ShadowPass shadow;
    GeometryPass geometry;
    LightingPass lighting;
    SkyPass sky;
    WaterPass water;
    TransparentPass transparent;
    ParticlePass particles;
    PrecipitationPass precipitation;
    ToneMapPass toneMap;
    ShowPass show;
    OverlayPass overlay;
    Thumbnails thumbnails;

    struct Frozen {
        Eye eye;             // whose culling is kept
        bool looked = false; // it knows what was hidden
    };
    std::optional<Frozen> frozen;

    PictureTarget canvas;
    Radiance* radiance = nullptr; // of the last frame, if that has any
};

} // namespace renderer
