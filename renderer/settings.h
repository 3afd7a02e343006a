// How the renderer draws: switches and choices that belong to a person and a machine, beside what a world chooses itself.
// Keys are those of --set render.KEY.
#pragma once

#include "io/scene/fields.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace renderer {

// What a scene chooses, and a person may choose in its place: the same words, and `scene`.
enum class AntiAliasing { Off, Fxaa, Smaa, Taa, Scene };
enum class ToneMap { Agx, Neutral, Aces, Reinhard, Scene };
enum class Shading { Pbr, BlinnPhong, Scene };
enum class SkyFrom { Tables, Integral, Scene };

using io::CloudKind;
enum class GroundStages { Tessellation, Grid }; // how the ground's vertices are made
enum class GrassFrom { Blades, Seeds }; // a grid fixed to the world, or points that the ground's pixels give (the original's way)
enum class Culler { Auto, Cpu, Gpu }; // auto: the GPU where there is one

struct Settings {
    bool culling = true; // what the camera or a cascade cannot see is not drawn; the picture is the same without
    Culler culler = Culler::Auto;
    bool occlusion = true; // what stands behind other things is not drawn; known to the GPU only
    bool lod = true;     // things are drawn coarser where that is not to be seen
    bool shadows = true;
    bool clouds = true;
    bool fog = true;
    bool wind = true;
    bool water = true;
    bool lamps = true;    // point and spot lights
    bool particles = true; // smoke, fire, dust, rain and snow
    bool ao = true;       // ambient occlusion
    bool shafts = true;   // light shafts in fog
    bool bloom = true;
    bool autoExposure = true; // where a scene asks for it
    bool grading = true;  // white balance, contrast, saturation
    bool vignette = true;
    bool grain = true;
    bool dither = true;
    SkyFrom sky = SkyFrom::Scene;
    CloudKind cloudKind = CloudKind::Layer; // the most that a machine can bear; set by --quality
    AntiAliasing antiAliasing = AntiAliasing::Scene;
    ToneMap toneMap = ToneMap::Scene;
    Shading shading = Shading::Scene;
    GroundStages terrain = GroundStages::Grid; // set by --quality

    float lodPixels = 1; // how far a coarser level may stray from the full model, in pixels, or texels of a shadow map; set by --quality
    float meshLeeway = 1; // so many times as far may meshes in the picture, but not impostors, flat as they are; set by --quality
    int skyPixels = 1;   // pixels along a side of one of the sky's, but for sun and stars; set by --quality

    bool groundDetail = false; // a finer copy of its layers' textures near the eye; set by --quality
    bool halfOcclusion = false; // occlusion at half the resolution; set by --quality
    bool grass = true;
    GrassFrom grassMethod = GrassFrom::Blades;
    int mostBlades = 20'000; // in view, of all kinds; set by --quality
    float grassDistance = 60; // m, to which grass is drawn; set by --quality
    float grassDensity = 1;   // share of what is painted that is drawn near the eye; set by --quality

    bool froxels = false;       // shafts through a volume of shadowed fog rather than on the screen; set by --quality

    // Caps on the shadows that a scene asks for: what a machine can bear, set by --quality.
    int mostCascades = 6;
    int largestShadowMap = 8192;    // texels along a side
    float farthestShadow = 1e6f;    // m
    bool operator==(const Settings&) const = default;
};

// The names of an enum of the scene's, and one more.
template <std::size_t N> constexpr std::array<std::string_view, N + 1> orScene(const std::array<std::string_view, N>& names)
{
    std::array<std::string_view, N + 1> all;
    std::ranges::copy(names, all.begin());
    all.back() = "scene";
    return all;
}
constexpr auto enumNames(AntiAliasing) { return orScene(enumNames(io::AntiAliasing{})); }
constexpr auto enumNames(SkyFrom) { return orScene(enumNames(io::SkyFrom{})); }
constexpr auto enumNames(ToneMap) { return orScene(enumNames(io::ToneMap{})); }
constexpr auto enumNames(Shading) { return orScene(enumNames(io::Shading{})); }
constexpr auto enumNames(GrassFrom) { return std::array<std::string_view, 2>{"blades", "seeds"}; }
constexpr auto enumNames(Culler) { return std::array<std::string_view, 3>{"auto", "cpu", "gpu"}; }
constexpr auto enumNames(GroundStages) { return std::array<std::string_view, 2>{"tessellation", "grid"}; }

void fields(auto& v, io::Of<Settings> auto& s)
{
    v("culling", s.culling, io::Hint{});
    v("culler", s.culler, io::Hint{});
    v("occlusion", s.occlusion, io::Hint{});
    v("lod", s.lod, io::Hint{});
    v("lod_pixels", s.lodPixels, io::Hint{.min = 0.25, .max = 16, .unit = "px"});
    v("shadows", s.shadows, io::Hint{});
    v("clouds", s.clouds, io::Hint{});
    v("fog", s.fog, io::Hint{});
    v("wind", s.wind, io::Hint{});
    v("water", s.water, io::Hint{});
    v("lamps", s.lamps, io::Hint{});
    v("particles", s.particles, io::Hint{});
    v("ao", s.ao, io::Hint{});
    v("ground_detail", s.groundDetail, io::Hint{});
    v("half_ao", s.halfOcclusion, io::Hint{});
    v("grass", s.grass, io::Hint{});
    v("grass_method", s.grassMethod, io::Hint{});
    v("most_blades", s.mostBlades, io::Hint{.min = 0, .max = 2'000'000});
    v("grass_distance", s.grassDistance, io::Hint{.min = 5, .max = 250, .unit = "m"});
    v("grass_density", s.grassDensity, io::Hint{.min = 0.05, .max = 1});
    v("shafts", s.shafts, io::Hint{});
    v("froxels", s.froxels, io::Hint{});
    v("bloom", s.bloom, io::Hint{});
    v("auto_exposure", s.autoExposure, io::Hint{});
    v("grading", s.grading, io::Hint{});
    v("vignette", s.vignette, io::Hint{});
    v("grain", s.grain, io::Hint{});
    v("dither", s.dither, io::Hint{});
    v("sky", s.sky, io::Hint{});
    v("cloud_kind", s.cloudKind, io::Hint{});
    v("aa", s.antiAliasing, io::Hint{});
    v("tonemap", s.toneMap, io::Hint{});
    v("shading", s.shading, io::Hint{});
    v("terrain", s.terrain, io::Hint{});
}

// For a picture of a scene: with what it chooses where nobody chose otherwise, and without what it has switched off.
inline Settings forScene(Settings settings, const io::Environment& scene)
{
    if (settings.sky == SkyFrom::Scene) settings.sky = SkyFrom(scene.sky.method);
    if (settings.toneMap == ToneMap::Scene) settings.toneMap = ToneMap(scene.grading.toneMap);
    if (settings.antiAliasing == AntiAliasing::Scene) settings.antiAliasing = AntiAliasing(scene.grading.antiAliasing);
    if (settings.shading == Shading::Scene) settings.shading = Shading(scene.grading.shading);
    if (scene.clouds.kind == io::CloudKind::Layer) settings.cloudKind = CloudKind::Layer;
    settings.clouds &= scene.clouds.on;
    settings.fog &= scene.fog.on;
    settings.shadows &= scene.shadows.on;
    settings.ao &= scene.occlusion.on;
    settings.dither &= scene.grading.dither;
    return settings;
}

inline io::Shadows capped(io::Shadows shadows, const Settings& settings)
{
    shadows.cascades = std::min(shadows.cascades, settings.mostCascades);
    shadows.resolution = std::min(shadows.resolution, settings.largestShadowMap);
    shadows.distance = std::min(shadows.distance, settings.farthestShadow);
    return shadows;
}

// What of the frame is shown in place of the finished picture.
enum class Show {
    Final, Albedo, Normal, Roughness, Depth, Position, Id, Ao, Shadow, Cascade, Luminance, Wireframe, Lod, Overdraw, Nodes,
    ShadowMaps, ShadowBoxes,             // the cascades' maps themselves, and where they lie in the world
    Contours, Slope, Grid, Layers, Tiles // of the ground
};
constexpr auto enumNames(Show)
{
    return std::array<std::string_view, 22>{"final",  "albedo",  "normal",    "roughness", "depth", "position", "id",    "ao",     "shadow", "cascade",
                                            "luminance", "wireframe", "lod",   "overdraw", "nodes", "shadow-maps", "shadow-boxes", "contours", "slope", "grid",   "layers", "tiles"};
}

} // namespace renderer
