// What a renderer owns: the mirror of the scene, the passes, and what the last frame left.
#pragma once

#include "renderer/choosing.h"
#include "renderer/gl/debug.h"
#include "renderer/impostor_baker.h"
#include "renderer/passes/bloom.h"
#include "renderer/passes/exposure.h"
#include "renderer/passes/clouds.h"
#include "renderer/passes/geometry.h"
#include "renderer/passes/lamps.h"
#include "renderer/passes/lighting.h"
#include "renderer/passes/occlusion.h"
#include "renderer/passes/overlay.h"
#include "renderer/passes/particles.h"
#include "renderer/passes/picture.h"
#include "renderer/passes/precipitation.h"
#include "renderer/passes/shadow.h"
#include "renderer/passes/shafts.h"
#include "renderer/passes/sky_tables.h"
#include "renderer/passes/smoothing.h"
#include "renderer/passes/temporal.h"
#include "renderer/passes/tone_map.h"
#include "renderer/passes/transparent.h"
#include "renderer/passes/grass.h"
#include "renderer/passes/water.h"
#include "renderer/renderer.h"
#include "renderer/scenery.h"
#include "renderer/thumbnails.h"

namespace renderer {

struct Renderer::State {
    explicit State(const Options& options);

    Picture render(const FrameInput& in);
    Viewpoint look(const FrameInput& in, io::Environment environment) const;
    bool goesOn(const Eye& eye) const;
    std::optional<int> gathered(const FrameInput& in, const Eye& eye) const;
    void expose(GpuFrame& gpu, const FrameInput& in, const Radiance& hdr, const GBuffer& surfaces, const Viewpoint& viewpoint);
    void develop(GpuFrame& gpu, const FrameInput& in, const Radiance& hdr, const GBuffer& surfaces, const Viewpoint& viewpoint);
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
    CloudPass clouds;
    SkyTables skyTables;
    ShadowPass shadow;
    GeometryPass geometry;
    GrassPass grass;
    LampPass lamps;
    OcclusionPass occlusion;
    LightingPass lighting;
    SkyPass sky;
    ShaftsPass shafts;
    WaterPass water;
    TransparentPass transparent;
    ParticlePass particles;
    PrecipitationPass precipitation;
    TemporalPass temporal;
    ExposurePass exposure;
    BloomPass bloom;
    ToneMapPass toneMap;
    SmoothingPass smoothing;
    ShowPass show;
    OverlayPass overlay;
    Thumbnails thumbnails;

    struct Frozen {
        Eye eye;             // whose culling is kept
        bool looked = false; // it knows what was hidden
    };
    std::optional<Frozen> frozen;

    struct Last { // frame, as far as the next one goes on from it
        Eye eye;
        double time = 0; // s
        std::optional<int> gathered; // how many frames before it are in what was gathered with it
    };
    std::optional<Last> last; // none: nothing to go on from

    double exposureByHand = 0; // EV, of the last frame, with what eyes used to the dark add
    PictureTarget canvas;
    Radiance* radiance = nullptr; // of the last frame, if that has any
};

} // namespace renderer
