// How the renderer draws: switches and choices that belong to a person and a machine, never to a world.
// Keys are those of --set render.KEY.
#pragma once

#include "io/scene/fields.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace renderer {

enum class AntiAliasing { Off, Fxaa };
enum class ToneMap { Agx, Neutral, Aces, Reinhard };
enum class Shading { Pbr, BlinnPhong };
enum class GroundStages { Tessellation, Grid }; // how the ground's vertices are made
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
    AntiAliasing antiAliasing = AntiAliasing::Fxaa;
    ToneMap toneMap = ToneMap::Agx;
    Shading shading = Shading::Pbr;
    GroundStages terrain = GroundStages::Grid; // set by --quality

    float lodPixels = 1; // how far a coarser level may stray from the full model, in pixels, or texels of a shadow map; set by --quality
    float meshLeeway = 1; // so many times as far may meshes in the picture, but not impostors, flat as they are; set by --quality
    int skyPixels = 1;   // pixels along a side of one of the sky's, but for sun and stars; set by --quality

    // Caps on the shadows that a scene asks for: what a machine can bear, set by --quality.
    int mostCascades = 4;
    int largestShadowMap = 8192;    // texels along a side
    float farthestShadow = 1e6f;    // m
    bool operator==(const Settings&) const = default;
};

constexpr auto enumNames(AntiAliasing) { return std::array<std::string_view, 2>{"off", "fxaa"}; }
constexpr auto enumNames(ToneMap) { return std::array<std::string_view, 4>{"agx", "neutral", "aces", "reinhard"}; }
constexpr auto enumNames(Culler) { return std::array<std::string_view, 3>{"auto", "cpu", "gpu"}; }
constexpr auto enumNames(GroundStages) { return std::array<std::string_view, 2>{"tessellation", "grid"}; }
constexpr auto enumNames(Shading) { return std::array<std::string_view, 2>{"pbr", "blinn-phong"}; }

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
    v("aa", s.antiAliasing, io::Hint{});
    v("tonemap", s.toneMap, io::Hint{});
    v("shading", s.shading, io::Hint{});
    v("terrain", s.terrain, io::Hint{});
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
    Contours, Slope, Grid, Layers, Tiles // of the ground
};
constexpr auto enumNames(Show)
{
    return std::array<std::string_view, 20>{"final",  "albedo",  "normal",    "roughness", "depth", "position", "id",    "ao",     "shadow", "cascade",
                                            "luminance", "wireframe", "lod",   "overdraw", "nodes", "contours", "slope", "grid",   "layers", "tiles"};
}

} // namespace renderer
