// Each field of the world, said once. Files, the inspector, --set, get/set and the undo names all read these lists.
//
// A visitor is called as v(key, value, hint). It is written once for all types: a value for which fields() exists
// is a section and is visited in turn; anything else is a bool, int, float, double, std::string, glm vector, enum
// (with enumNames()), or a std::vector of those.
#pragma once

#include "io/scene/camera.h"
#include "io/scene/environment.h"
#include "io/scene/object.h"
#include "io/scene/template.h"
#include "io/scene/terrain.h"

#include <array>
#include <concepts>
#include <limits>
#include <string_view>
#include <type_traits>

namespace io {

enum class Style { Plain, Colour, Path, Logarithmic };

struct Hint {
    double min = std::numeric_limits<double>::lowest(); // a value outside is an error in a file, clamped in a panel
    double max = std::numeric_limits<double>::max();
    const char* unit = "";
    Style style = Style::Plain;
    bool optional = false; // a text that is not written while it is empty
};

// `T` itself or `const T`, so that one list serves readers and writers.
template <class T, class Base>
concept Of = std::same_as<std::remove_const_t<T>, Base>;

constexpr auto enumNames(SunMode) { return std::array<std::string_view, 2>{"time", "manual"}; }
constexpr auto enumNames(Collision) { return std::array<std::string_view, 4>{"none", "box", "mesh", "capsule"}; }
constexpr auto enumNames(DrawPath) { return std::array<std::string_view, 2>{"batched", "direct"}; }

void fields(auto& v, Of<Sun> auto& s)
{
    v("mode", s.mode, Hint{});
    v("azimuth", s.azimuth, Hint{.min = -360, .max = 360, .unit = "deg"});
    v("elevation", s.elevation, Hint{.min = -90, .max = 90, .unit = "deg"});
    v("irradiance", s.irradiance, Hint{.min = 0, .max = 1000});
    v("angular_diameter", s.angularDiameter, Hint{.min = 0.05, .max = 20, .unit = "deg"});
}

void fields(auto& v, Of<Sky> auto& s)
{
    v("rayleigh", s.rayleigh, Hint{.min = 0, .max = 200, .unit = "1e-6/m"});
    v("rayleigh_height", s.rayleighHeight, Hint{.min = 100, .max = 50000, .unit = "m"});
    v("mie_scattering", s.mieScattering, Hint{.min = 0, .max = 200, .unit = "1e-6/m"});
    v("mie_extinction", s.mieExtinction, Hint{.min = 0, .max = 250, .unit = "1e-6/m"});
    v("mie_height", s.mieHeight, Hint{.min = 50, .max = 20000, .unit = "m"});
    v("mie_g", s.mieG, Hint{.min = -0.99, .max = 0.99});
    v("ozone", s.ozone, Hint{.min = 0, .max = 50, .unit = "1e-6/m"});
    v("ground_albedo", s.groundAlbedo, Hint{.min = 0, .max = 1});
    v("ambient", s.ambient, Hint{.min = 0, .max = 10});
}

void fields(auto& v, Of<Clouds> auto& c)
{
    v("coverage", c.coverage, Hint{.min = 0, .max = 1});
    v("altitude", c.altitude, Hint{.min = 100, .max = 20000, .unit = "m"});
    v("softness", c.softness, Hint{.min = 0.01, .max = 1});
    v("speed", c.speed, Hint{.min = 0, .max = 200, .unit = "m/s"});
    v("direction", c.direction, Hint{.min = -360, .max = 360, .unit = "deg"});
}

void fields(auto& v, Of<Wind> auto& w)
{
    v("speed", w.speed, Hint{.min = 0, .max = 60, .unit = "m/s"});
    v("direction", w.direction, Hint{.min = -360, .max = 360, .unit = "deg"});
    v("gustiness", w.gustiness, Hint{.min = 0, .max = 1});
}

void fields(auto& v, Of<Fog> auto& f)
{
    v("density", f.density, Hint{.min = 0, .max = 0.1, .unit = "1/m", .style = Style::Logarithmic});
    v("height", f.height, Hint{.min = 1, .max = 20000, .unit = "m", .style = Style::Logarithmic});
    v("base", f.base, Hint{.min = -10000, .max = 10000, .unit = "m"});
    v("tint", f.tint, Hint{.min = 0, .max = 4, .style = Style::Colour});
}

void fields(auto& v, Of<Shadows> auto& s)
{
    v("cascades", s.cascades, Hint{.min = 1, .max = 4});
    v("distance", s.distance, Hint{.min = 10, .max = 5000, .unit = "m"});
    v("lambda", s.lambda, Hint{.min = 0, .max = 1});
    v("resolution", s.resolution, Hint{.min = 256, .max = 8192});
    v("softness", s.softness, Hint{.min = 0, .max = 4, .unit = "texels"});
    v("bias", s.bias, Hint{.min = 0, .max = 8, .unit = "texels"});
}

void fields(auto& v, Of<Environment> auto& e)
{
    v("time", e.time, Hint{.min = 0, .max = 24, .unit = "h"});
    v("day_of_year", e.dayOfYear, Hint{.min = 1, .max = 366});
    v("latitude", e.latitude, Hint{.min = -90, .max = 90, .unit = "deg"});
    v("exposure", e.exposure, Hint{.min = -20, .max = 20, .unit = "EV"});
    v("sun", e.sun, Hint{});
    v("sky", e.sky, Hint{});
    v("clouds", e.clouds, Hint{});
    v("wind", e.wind, Hint{});
    v("fog", e.fog, Hint{});
    v("shadows", e.shadows, Hint{});
}

void fields(auto& v, Of<TerrainLayer> auto& l)
{
    v("name", l.name, Hint{});
    v("texture", l.texture, Hint{.style = Style::Path});
    v("normal_texture", l.normalTexture, Hint{.style = Style::Path});
    v("colour", l.colour, Hint{.min = 0, .max = 4, .style = Style::Colour});
    v("roughness", l.roughness, Hint{.min = 0, .max = 1});
    v("metres", l.metres, Hint{.min = 0.05, .max = 10000, .unit = "m"});
    v("slope", l.slope, Hint{.min = 0, .max = 90, .unit = "deg"});
    v("altitude", l.altitude, Hint{.min = -100000, .max = 100000, .unit = "m"});
    v("flow", l.flow, Hint{.min = 0, .max = 1});
    v("blend", l.blend, Hint{.min = 0.001, .max = 1});
}

void fields(auto& v, Of<Terrain> auto& t)
{
    v("height_map", t.heightMap, Hint{.style = Style::Path});
    v("cover_map", t.coverMap, Hint{.style = Style::Path, .optional = true});
    v("metres_per_texel", t.metresPerTexel, Hint{.min = 0.001, .max = 10000, .unit = "m"});
    v("origin", t.origin, Hint{.min = -1e7, .max = 1e7, .unit = "m"});
    v("min_height", t.minHeight, Hint{.min = -1e5, .max = 1e5, .unit = "m"});
    v("max_height", t.maxHeight, Hint{.min = -1e5, .max = 1e5, .unit = "m"});
    v("layers", t.layers, Hint{});
}

void fields(auto& v, Of<Camera> auto& c)
{
    v("name", c.name, Hint{});
    v("eye", c.eye, Hint{.min = -1e7, .max = 1e7, .unit = "m"});
    v("yaw", c.yaw, Hint{.min = -1e6, .max = 1e6, .unit = "deg"});
    v("pitch", c.pitch, Hint{.min = -90, .max = 90, .unit = "deg"});
    v("fov", c.fov, Hint{.min = 1, .max = 170, .unit = "deg"});
}

void fields(auto& v, Of<PathKey> auto& k)
{
    v("time", k.time, Hint{.min = 0, .max = 1e6, .unit = "s"});
    v("eye", k.eye, Hint{.min = -1e7, .max = 1e7, .unit = "m"});
    v("yaw", k.yaw, Hint{.min = -1e6, .max = 1e6, .unit = "deg"});
    v("pitch", k.pitch, Hint{.min = -90, .max = 90, .unit = "deg"});
    v("fov", k.fov, Hint{.min = 1, .max = 170, .unit = "deg"});
}

void fields(auto& v, Of<CameraPath> auto& p)
{
    v("name", p.name, Hint{});
    v("keys", p.keys, Hint{});
}

// A template's name is its file's, so it is not among the fields of the file.
void fields(auto& v, Of<Template> auto& t)
{
    v("category", t.category, Hint{});
    v("model", t.model, Hint{.style = Style::Path});
    v("marker_size", t.markerSize, Hint{.min = 0.01, .max = 1000, .unit = "m"});
    v("yaw", t.yaw, Hint{.min = -360, .max = 360, .unit = "deg"});
    v("scale", t.scale, Hint{.min = 0.001, .max = 1000});
    v("tilt", t.tilt, Hint{.min = 0, .max = 90, .unit = "deg"});
    v("align_to_ground", t.alignToGround, Hint{});
    v("sink", t.sink, Hint{.min = -100, .max = 100, .unit = "m"});
    v("collision", t.collision, Hint{});
    v("footprint", t.footprint, Hint{.min = 0, .max = 1000, .unit = "m"});
    v("cast_shadow", t.castShadow, Hint{});
    v("impostor", t.impostor, Hint{});
    v("draw_path", t.drawPath, Hint{});
    v("wind", t.wind, Hint{.min = 0, .max = 1});
}

void fields(auto& v, Of<Transform> auto& t)
{
    v("position", t.position, Hint{.min = -1e7, .max = 1e7, .unit = "m"});
    v("rotation", t.rotation, Hint{.min = -1e6, .max = 1e6, .unit = "deg"});
    v("scale", t.scale, Hint{.min = -1e6, .max = 1e6});
}

// The id is the object's name in the file and never edited. The template is written by name, the transform inline.
void fields(auto& v, Of<Object> auto& o)
{
    v("template", o.templateId, Hint{});
    v("name", o.name, Hint{});
    fields(v, o.transform);
    v("parent", o.parent, Hint{});
}

} // namespace io
