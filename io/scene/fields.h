// Each field of the world, said once. Files, the inspector, --set, get/set and the undo names all read these lists.
//
// A visitor is called as v(key, value, hint). It is written once for all types: a value for which fields() exists
// is a section and is visited in turn; anything else is a bool, int, float, double, std::string, glm vector, enum
// (with enumNames()), or a std::vector of those.
#pragma once

#include "io/scene/camera.h"
#include "io/scene/environment.h"
#include "io/scene/grass.h"
#include "io/scene/object.h"
#include "io/scene/scatter.h"
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
    bool optional = false; // not written while it is as empty as a new one
};

// `T` itself or `const T`, so that one list serves readers and writers.
template <class T, class Base>
concept Of = std::same_as<std::remove_const_t<T>, Base>;

constexpr auto enumNames(SunMode) { return std::array<std::string_view, 2>{"time", "manual"}; }
constexpr auto enumNames(Clock) { return std::array<std::string_view, 2>{"solar", "zone"}; }
constexpr auto enumNames(Splits) { return std::array<std::string_view, 2>{"practical", "manual"}; }
constexpr auto enumNames(ShadowFilter) { return std::array<std::string_view, 3>{"pcf3", "pcf5", "pcf7"}; }
constexpr auto enumNames(SkyFrom) { return std::array<std::string_view, 2>{"tables", "integral"}; }
constexpr auto enumNames(CloudKind) { return std::array<std::string_view, 2>{"layer", "volume"}; }
constexpr auto enumNames(Shading) { return std::array<std::string_view, 2>{"pbr", "blinn-phong"}; }
constexpr auto enumNames(ToneMap) { return std::array<std::string_view, 4>{"agx", "neutral", "aces", "reinhard"}; }
constexpr auto enumNames(AntiAliasing) { return std::array<std::string_view, 4>{"off", "fxaa", "smaa", "taa"}; }
constexpr auto enumNames(LightKind) { return std::array<std::string_view, 3>{"none", "point", "spot"}; }
constexpr auto enumNames(ParticleKind) { return std::array<std::string_view, 4>{"none", "fire", "smoke", "dust"}; }
constexpr auto enumNames(Collision) { return std::array<std::string_view, 5>{"none", "box", "mesh", "capsule", "hull"}; }
constexpr auto enumNames(Footprint) { return std::array<std::string_view, 4>{"none", "radius", "box", "mesh"}; }
constexpr auto enumNames(SoundGroup) { return std::array<std::string_view, 4>{"effects", "ambience", "music", "steps"}; }
constexpr auto enumNames(SoundWeather) { return std::array<std::string_view, 4>{"any", "dry", "wet", "storm"}; }
constexpr auto enumNames(TriggerShape) { return std::array<std::string_view, 3>{"none", "box", "sphere"}; }
constexpr auto enumNames(TriggerDo) { return std::array<std::string_view, 6>{"play_sound", "come_to_look", "show", "hide", "teleport", "message"}; }
constexpr auto enumNames(PlayerShape) { return std::array<std::string_view, 2>{"capsule", "swept_box"}; }
constexpr auto enumNames(PlayerEye) { return std::array<std::string_view, 2>{"first", "third"}; }
constexpr auto enumNames(DrawPath) { return std::array<std::string_view, 2>{"batched", "direct"}; }

void fields(auto& v, Of<Sun> auto& s)
{
    v("mode", s.mode, Hint{});
    v("azimuth", s.azimuth, Hint{.min = -360, .max = 360, .unit = "deg"});
    v("elevation", s.elevation, Hint{.min = -90, .max = 90, .unit = "deg"});
    v("irradiance", s.irradiance, Hint{.min = 0, .max = 1000, .unit = "x"});
    v("angular_diameter", s.angularDiameter, Hint{.min = 0.05, .max = 20, .unit = "deg"});
}

void fields(auto& v, Of<Moon> auto& m)
{
    v("mode", m.mode, Hint{});
    v("azimuth", m.azimuth, Hint{.min = -360, .max = 360, .unit = "deg"});
    v("elevation", m.elevation, Hint{.min = -90, .max = 90, .unit = "deg"});
    v("phase", m.phase, Hint{.min = 0, .max = 1});
    v("brightness", m.brightness, Hint{.min = 0, .max = 100});
    v("angular_diameter", m.angularDiameter, Hint{.min = 0.05, .max = 20, .unit = "deg"});
}

void fields(auto& v, Of<Sky> auto& s)
{
    v("method", s.method, Hint{});
    v("rayleigh", s.rayleigh, Hint{.min = 0, .max = 200, .unit = "1e-6/m", .style = Style::Logarithmic});
    v("rayleigh_height", s.rayleighHeight, Hint{.min = 100, .max = 50000, .unit = "m", .style = Style::Logarithmic});
    v("mie_scattering", s.mieScattering, Hint{.min = 0, .max = 200, .unit = "1e-6/m", .style = Style::Logarithmic});
    v("mie_extinction", s.mieExtinction, Hint{.min = 0, .max = 250, .unit = "1e-6/m", .style = Style::Logarithmic});
    v("mie_height", s.mieHeight, Hint{.min = 50, .max = 20000, .unit = "m", .style = Style::Logarithmic});
    v("mie_g", s.mieG, Hint{.min = -0.99, .max = 0.99});
    v("ozone", s.ozone, Hint{.min = 0, .max = 50, .unit = "1e-6/m", .style = Style::Logarithmic});
    v("ground_albedo", s.groundAlbedo, Hint{.min = 0, .max = 1});
    v("planet_radius", s.planetRadius, Hint{.min = 100, .max = 100000, .unit = "km"});
    v("air_depth", s.airDepth, Hint{.min = 10, .max = 1000, .unit = "km"});
    v("ambient", s.ambient, Hint{.min = 0, .max = 10});
    v("aerial", s.aerial, Hint{.min = 0, .max = 50});
    v("stars", s.stars, Hint{.min = 0, .max = 100});
}

void fields(auto& v, Of<Clouds> auto& c)
{
    v("on", c.on, Hint{});
    v("kind", c.kind, Hint{});
    v("coverage", c.coverage, Hint{.min = 0, .max = 1});
    v("altitude", c.altitude, Hint{.min = 100, .max = 20000, .unit = "m", .style = Style::Logarithmic});
    v("softness", c.softness, Hint{.min = 0.01, .max = 1});
    v("speed", c.speed, Hint{.min = 0, .max = 200, .unit = "m/s"});
    v("direction", c.direction, Hint{.min = -360, .max = 360, .unit = "deg"});
    v("size", c.size, Hint{.min = 500, .max = 200000, .unit = "m", .style = Style::Logarithmic});
    v("change", c.change, Hint{.min = 0, .max = 100});
    v("thickness", c.thickness, Hint{.min = 10, .max = 10000, .unit = "m", .style = Style::Logarithmic});
    v("density", c.density, Hint{.min = 0, .max = 1, .unit = "1/m", .style = Style::Logarithmic});
    v("shadow", c.shadow, Hint{.min = 0, .max = 1});
    v("seed", c.seed, Hint{.min = 0, .max = 1e6});
}

void fields(auto& v, Of<Weather> auto& w)
{
    v("rain", w.rain, Hint{.min = 0, .max = 50, .unit = "mm/h", .style = Style::Logarithmic});
    v("snow", w.snow, Hint{.min = 0, .max = 10, .unit = "mm/h", .style = Style::Logarithmic});
}

void fields(auto& v, Of<Wind> auto& w)
{
    v("speed", w.speed, Hint{.min = 0, .max = 60, .unit = "m/s"});
    v("direction", w.direction, Hint{.min = -360, .max = 360, .unit = "deg"});
    v("gustiness", w.gustiness, Hint{.min = 0, .max = 1});
}

void fields(auto& v, Of<Fog> auto& f)
{
    v("on", f.on, Hint{});
    v("density", f.density, Hint{.min = 0, .max = 0.1, .unit = "1/m", .style = Style::Logarithmic});
    v("height", f.height, Hint{.min = 1, .max = 20000, .unit = "m", .style = Style::Logarithmic});
    v("base", f.base, Hint{.min = -10000, .max = 10000, .unit = "m"});
    v("tint", f.tint, Hint{.min = 0, .max = 4, .style = Style::Colour});
    v("shafts", f.shafts, Hint{.min = 0, .max = 1});
}

void fields(auto& v, Of<Water> auto& w)
{
    v("on", w.on, Hint{});
    v("level", w.level, Hint{.min = -1e5, .max = 1e5, .unit = "m"});
    v("colour", w.colour, Hint{.min = 0, .max = 4, .style = Style::Colour});
    v("clarity", w.clarity, Hint{.min = 0.05, .max = 200, .unit = "m", .style = Style::Logarithmic});
    v("waves", w.waves, Hint{.min = 0, .max = 20, .unit = "m"});
    v("wavelength", w.wavelength, Hint{.min = 0.5, .max = 500, .unit = "m", .style = Style::Logarithmic});
    v("foam", w.foam, Hint{.min = 0, .max = 1});
}

void fields(auto& v, Of<Shadows> auto& s)
{
    v("on", s.on, Hint{});
    v("cascades", s.cascades, Hint{.min = 1, .max = 6});
    v("distance", s.distance, Hint{.min = 10, .max = 5000, .unit = "m", .style = Style::Logarithmic});
    v("splits", s.splits, Hint{});
    v("lambda", s.lambda, Hint{.min = 0, .max = 1});
    v("end_1", s.end1, Hint{.min = 1, .max = 5000, .unit = "m", .style = Style::Logarithmic});
    v("end_2", s.end2, Hint{.min = 1, .max = 5000, .unit = "m", .style = Style::Logarithmic});
    v("end_3", s.end3, Hint{.min = 1, .max = 5000, .unit = "m", .style = Style::Logarithmic});
    v("end_4", s.end4, Hint{.min = 1, .max = 5000, .unit = "m", .style = Style::Logarithmic});
    v("end_5", s.end5, Hint{.min = 1, .max = 5000, .unit = "m", .style = Style::Logarithmic});
    v("resolution", s.resolution, Hint{.min = 256, .max = 8192, .unit = "texels"});
    v("filter", s.filter, Hint{});
    v("softness", s.softness, Hint{.min = 0, .max = 4});
    v("contact", s.contact, Hint{});
    v("blend", s.blend, Hint{.min = 0, .max = 0.5});
    v("fade", s.fade, Hint{.min = 0, .max = 0.5});
    v("bias", s.bias, Hint{.min = 0, .max = 8, .unit = "texels"});
    v("depth_bias", s.depthBias, Hint{.min = 0, .max = 16, .unit = "texels"});
}

void fields(auto& v, Of<Occlusion> auto& o)
{
    v("on", o.on, Hint{});
    v("radius", o.radius, Hint{.min = 0.05, .max = 50, .unit = "m", .style = Style::Logarithmic});
    v("strength", o.strength, Hint{.min = 0, .max = 4});
}

void fields(auto& v, Of<AutoExposure> auto& a)
{
    v("on", a.on, Hint{});
    v("compensation", a.compensation, Hint{.min = -10, .max = 10, .unit = "EV"});
    v("lowest", a.lowest, Hint{.min = -20, .max = 20, .unit = "EV"});
    v("highest", a.highest, Hint{.min = -20, .max = 20, .unit = "EV"});
    v("seconds", a.seconds, Hint{.min = 0, .max = 60, .unit = "s"});
    v("darkness", a.darkness, Hint{.min = 0, .max = 1});
}

void fields(auto& v, Of<Grading> auto& g)
{
    v("bloom", g.bloom, Hint{.min = 0, .max = 1});
    v("temperature", g.temperature, Hint{.min = 1500, .max = 20000, .unit = "K"});
    v("tint", g.tint, Hint{.min = -1, .max = 1});
    v("contrast", g.contrast, Hint{.min = 0.25, .max = 4});
    v("saturation", g.saturation, Hint{.min = 0, .max = 2});
    v("vignette", g.vignette, Hint{.min = 0, .max = 1});
    v("grain", g.grain, Hint{.min = 0, .max = 1});
    v("dither", g.dither, Hint{});
    v("tone_map", g.toneMap, Hint{});
    v("anti_aliasing", g.antiAliasing, Hint{});
    v("shading", g.shading, Hint{});
}

void fields(auto& v, Of<Environment> auto& e)
{
    v("time", e.time, Hint{.min = 0, .max = 24, .unit = "h"});
    v("clock", e.clock, Hint{});
    v("time_zone", e.timeZone, Hint{.min = -14, .max = 14, .unit = "h"});
    v("day_of_year", e.dayOfYear, Hint{.min = 1, .max = 366});
    v("year", e.year, Hint{.min = 1900, .max = 2100});
    v("latitude", e.latitude, Hint{.min = -90, .max = 90, .unit = "deg"});
    v("longitude", e.longitude, Hint{.min = -180, .max = 180, .unit = "deg"});
    v("day_speed", e.daySpeed, Hint{.min = 0, .max = 86400, .unit = "x", .style = Style::Logarithmic});
    v("day_runs", e.dayRuns, Hint{});
    v("exposure", e.exposure, Hint{.min = -20, .max = 20, .unit = "EV"});
    v("auto_exposure", e.autoExposure, Hint{});
    v("sun", e.sun, Hint{});
    v("moon", e.moon, Hint{});
    v("sky", e.sky, Hint{});
    v("clouds", e.clouds, Hint{});
    v("weather", e.weather, Hint{});
    v("wind", e.wind, Hint{});
    v("fog", e.fog, Hint{});
    v("water", e.water, Hint{});
    v("shadows", e.shadows, Hint{});
    v("occlusion", e.occlusion, Hint{});
    v("grading", e.grading, Hint{});
}

void fields(auto& v, Of<TerrainLayer> auto& l)
{
    v("name", l.name, Hint{});
    v("texture", l.texture, Hint{.style = Style::Path});
    v("normal_texture", l.normalTexture, Hint{.style = Style::Path});
    v("roughness_texture", l.roughnessTexture, Hint{.style = Style::Path, .optional = true});
    v("height_texture", l.heightTexture, Hint{.style = Style::Path, .optional = true});
    v("colour", l.colour, Hint{.min = 0, .max = 4, .style = Style::Colour});
    v("roughness", l.roughness, Hint{.min = 0, .max = 1});
    v("metres", l.metres, Hint{.min = 0.05, .max = 10000, .unit = "m"});
    v("slope", l.slope, Hint{.min = 0, .max = 90, .unit = "deg"});
    v("altitude", l.altitude, Hint{.min = -100000, .max = 100000, .unit = "m"});
    v("flow", l.flow, Hint{.min = 0, .max = 1});
    v("blend", l.blend, Hint{.min = 0.001, .max = 1});
    v("steps", l.steps, Hint{.style = Style::Path, .optional = true});
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

void fields(auto& v, Of<GrassKind> auto& k)
{
    v("name", k.name, Hint{});
    v("plant", k.plant, Hint{.optional = true});
    v("density", k.density, Hint{.min = 0, .max = kMostGrass, .unit = "1/m2"});
    v("height", k.height, Hint{.min = 0.01, .max = 6, .unit = "m"});
    v("width", k.width, Hint{.min = 0.001, .max = 0.3, .unit = "m", .style = Style::Logarithmic});
    v("root_colour", k.rootColour, Hint{.min = 0, .max = 1, .style = Style::Colour});
    v("tip_colour", k.tipColour, Hint{.min = 0, .max = 1, .style = Style::Colour});
    v("variety", k.variety, Hint{.min = 0, .max = 1});
    v("ground_colour", k.groundColour, Hint{.min = 0, .max = 1});
    v("bend", k.bend, Hint{.min = 0, .max = 1});
    v("clump", k.clump, Hint{.min = 0, .max = 1});
    v("clump_size", k.clumpSize, Hint{.min = 0.1, .max = 20, .unit = "m", .style = Style::Logarithmic});
    v("wind", k.wind, Hint{.min = 0, .max = 1});
    v("slope", k.slope, Hint{.min = 0, .max = 90, .unit = "deg"});
    v("altitude", k.altitude, Hint{.min = -100000, .max = 100000, .unit = "m"});
    v("above_water", k.aboveWater, Hint{.min = -100000, .max = 100000, .unit = "m"});
}

void fields(auto& v, Of<Grass> auto& g)
{
    v("map", g.map, Hint{.style = Style::Path, .optional = true});
    v("metres_per_texel", g.metresPerTexel, Hint{.min = 0.05, .max = 100, .unit = "m"});
    v("origin", g.origin, Hint{.min = -1e7, .max = 1e7, .unit = "m"});
    v("kinds", g.kinds, Hint{});
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
    v("look_at", p.lookAt, Hint{.optional = true});
    v("target", p.target, Hint{.min = -1e7, .max = 1e7, .unit = "m", .optional = true});
}

void fields(auto& v, Of<LightSource> auto& l)
{
    v("kind", l.kind, Hint{});
    v("colour", l.colour, Hint{.min = 0, .max = 4, .style = Style::Colour});
    v("intensity", l.intensity, Hint{.min = 0, .max = 10000, .style = Style::Logarithmic});
    v("range", l.range, Hint{.min = 0.1, .max = 1000, .unit = "m", .style = Style::Logarithmic});
    v("inner", l.inner, Hint{.min = 0, .max = 89, .unit = "deg"});
    v("outer", l.outer, Hint{.min = 1, .max = 89, .unit = "deg"});
    v("offset", l.offset, Hint{.min = -1000, .max = 1000, .unit = "m"});
    v("cast_shadow", l.castShadow, Hint{});
}

void fields(auto& v, Of<ParticleSource> auto& p)
{
    v("kind", p.kind, Hint{});
    v("rate", p.rate, Hint{.min = 0, .max = 2000, .unit = "1/s"});
    v("life", p.life, Hint{.min = 0.05, .max = 120, .unit = "s"});
    v("size", p.size, Hint{.min = 0.005, .max = 100, .unit = "m", .style = Style::Logarithmic});
    v("rise", p.rise, Hint{.min = -50, .max = 50, .unit = "m/s"});
    v("spread", p.spread, Hint{.min = 0, .max = 100, .unit = "m"});
    v("colour", p.colour, Hint{.min = 0, .max = 4, .style = Style::Colour});
    v("offset", p.offset, Hint{.min = -1000, .max = 1000, .unit = "m"});
}

void fields(auto& v, Of<Body> auto& b)
{
    v("dynamic", b.dynamic, Hint{});
    v("mass", b.mass, Hint{.min = 0.01, .max = 1e6, .unit = "kg", .style = Style::Logarithmic});
    v("friction", b.friction, Hint{.min = 0, .max = 10});
    v("bounce", b.bounce, Hint{.min = 0, .max = 1});
}

void fields(auto& v, Of<FalloffKey> auto& k)
{
    v("at", k.at, Hint{.min = 0, .max = 1});
    v("level", k.level, Hint{.min = 0, .max = 1});
}

void fields(auto& v, Of<SoundSource> auto& s)
{
    v("file", s.file, Hint{.style = Style::Path});
    v("group", s.group, Hint{});
    v("volume", s.volume, Hint{.min = 0, .max = 8});
    v("radius", s.radius, Hint{.min = 0.1, .max = 1e6, .unit = "m", .style = Style::Logarithmic});
    v("falloff", s.falloff, Hint{.optional = true});
    v("loop", s.loop, Hint{});
    v("flat", s.flat, Hint{});
    v("occluded", s.occluded, Hint{});
    v("hours", s.hours, Hint{.min = 0, .max = 24, .unit = "h"});
    v("weather", s.weather, Hint{});
    v("offset", s.offset, Hint{.min = -1000, .max = 1000, .unit = "m"});
}

void fields(auto& v, Of<TriggerAction> auto& a)
{
    v("action", a.action, Hint{});
    v("what", a.what, Hint{});
    v("seconds", a.seconds, Hint{.min = 0, .max = 3600, .unit = "s"});
}

void fields(auto& v, Of<Trigger> auto& t)
{
    v("shape", t.shape, Hint{});
    v("size", t.size, Hint{.min = 0.01, .max = 1e6, .unit = "m"});
    v("once", t.once, Hint{});
    v("actions", t.actions, Hint{.optional = true});
}

void fields(auto& v, Of<PlayerStart> auto& p)
{
    v("start", p.start, Hint{});
    v("shape", p.shape, Hint{});
    v("eye", p.eye, Hint{});
    v("height", p.height, Hint{.min = 0.2, .max = 20, .unit = "m"});
    v("radius", p.radius, Hint{.min = 0.05, .max = 5, .unit = "m"});
    v("eye_height", p.eyeHeight, Hint{.min = 0.1, .max = 20, .unit = "m"});
    v("crouched", p.crouched, Hint{.min = 0.1, .max = 20, .unit = "m"});
    v("camera", p.camera, Hint{.min = -50, .max = 50, .unit = "m"});
    v("behind", p.behind, Hint{.min = 0.2, .max = 50, .unit = "m"});
    v("walk", p.walk, Hint{.min = 0.1, .max = 100, .unit = "m/s"});
    v("run", p.run, Hint{.min = 0.1, .max = 100, .unit = "m/s"});
    v("creep", p.creep, Hint{.min = 0.1, .max = 100, .unit = "m/s"});
    v("swim", p.swim, Hint{.min = 0.1, .max = 100, .unit = "m/s"});
    v("fly", p.fly, Hint{.min = 0.1, .max = 1000, .unit = "m/s", .style = Style::Logarithmic});
    v("jump", p.jump, Hint{.min = 0, .max = 100, .unit = "m"});
    v("step", p.step, Hint{.min = 0, .max = 5, .unit = "m"});
    v("slope", p.slope, Hint{.min = 0, .max = 89, .unit = "deg"});
    v("mass", p.mass, Hint{.min = 1, .max = 10000, .unit = "kg"});
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
    v("body", t.body, Hint{.optional = true});
    v("steps", t.steps, Hint{.style = Style::Path, .optional = true});
    v("footprint_shape", t.footprintShape, Hint{});
    v("footprint", t.footprint, Hint{.min = 0, .max = 1000, .unit = "m"});
    v("cast_shadow", t.castShadow, Hint{});
    v("impostor", t.impostor, Hint{});
    v("draw_path", t.drawPath, Hint{});
    v("wind", t.wind, Hint{.min = 0, .max = 1});
    v("light", t.light, Hint{});
    v("particles", t.particles, Hint{});
    v("sound", t.sound, Hint{.optional = true});
    v("trigger", t.trigger, Hint{.optional = true});
    v("player", t.player, Hint{.optional = true});
}

void fields(auto& v, Of<Transform> auto& t)
{
    v("position", t.position, Hint{.min = -1e7, .max = 1e7, .unit = "m"});
    v("rotation", t.rotation, Hint{.min = -1e6, .max = 1e6, .unit = "deg"});
    v("scale", t.scale, Hint{.min = -1e6, .max = 1e6});
}

void fields(auto& v, Of<Species> auto& s)
{
    v("template", s.templateName, Hint{});
    v("weight", s.weight, Hint{.min = 0, .max = 1000});
    v("scale", s.scale, Hint{.min = 0.001, .max = 1000});
    v("spacing", s.spacing, Hint{.min = 0, .max = 1000, .unit = "m", .style = Style::Logarithmic});
}

void fields(auto& v, Of<ScatterLayer> auto& l)
{
    v("id", l.id, Hint{.min = 1, .max = kHighestScatterId});
    v("name", l.name, Hint{});
    v("rule", l.rule, Hint{});
    v("species", l.species, Hint{});
    v("density", l.density, Hint{.min = 0, .max = 100, .unit = "1/m2", .style = Style::Logarithmic});
    v("spacing", l.spacing, Hint{.min = 0, .max = 1000, .unit = "m", .style = Style::Logarithmic});
    v("scale", l.scale, Hint{.min = 0.001, .max = 1000});
    v("yaw", l.yaw, Hint{.min = -360, .max = 360, .unit = "deg"});
    v("tilt", l.tilt, Hint{.min = 0, .max = 90, .unit = "deg"});
    v("sink", l.sink, Hint{.min = -100, .max = 100, .unit = "m"});
    v("align", l.align, Hint{.min = 0, .max = 1});
    v("slope", l.slope, Hint{.min = 0, .max = 90, .unit = "deg"});
    v("altitude", l.altitude, Hint{.min = -100000, .max = 100000, .unit = "m"});
    v("ground", l.ground, Hint{.optional = true});
    v("clearance", l.clearance, Hint{.min = 0, .max = 1000, .unit = "m", .style = Style::Logarithmic});
    v("meshes", l.meshes, Hint{});
    v("shown", l.shown, Hint{});
    v("seed", l.seed, Hint{.min = 0, .max = 4294967295.0});
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
