// Light and air of a scene. Every value is a field of the environment file, of the Environment panel and of --set.
#pragma once

#include "io/scene/extra.h"

#include <glm/glm.hpp>

namespace io {

enum class SunMode { Time, Manual };
enum class Clock { Solar, Zone };         // what `time` counts: the sun's own hours, or those of a time zone
enum class Splits { Practical, Manual };  // where cascades end: by lambda, or each by hand
enum class ShadowFilter { Pcf3, Pcf5, Pcf7 };
enum class SkyFrom { Tables, Integral };    // many scatterings by tables, or one by a numerical integral for each pixel
enum class CloudKind { Layer, Volume };     // volume: where the machine can bear them, else a layer
enum class Shading { Pbr, BlinnPhong };
enum class ToneMap { Agx, Neutral, Aces, Reinhard };
enum class AntiAliasing { Off, Fxaa, Smaa, Taa };

struct Sun {
    SunMode mode = SunMode::Time;
    float azimuth = 135;        // degrees clockwise from north (-Z); used when manual
    float elevation = 40;       // degrees above the horizon; used when manual
    glm::vec3 irradiance{1};    // linear RGB above the atmosphere, as a factor: radiances are per unit of it
    float angularDiameter = 0.53f; // degrees
    bool operator==(const Sun&) const = default;
};

struct Moon {
    SunMode mode = SunMode::Time;
    float azimuth = 315;           // degrees clockwise from north; used when manual
    float elevation = 35;          // degrees above the horizon; used when manual
    float phase = 0.5f;            // 0 new, 0.25 first quarter, 0.5 full, 0.75 last quarter; used when manual
    float brightness = 1;          // factor on its light
    float angularDiameter = 0.52f; // degrees
    bool operator==(const Moon&) const = default;
};

// Earth's atmosphere after Hillaire 2020, with Mie extinction 4.44e-6 /m (Bruneton's albedo 0.9).
struct Sky {
    SkyFrom method = SkyFrom::Tables;
    glm::vec3 rayleigh{5.802f, 13.558f, 33.1f}; // scattering at sea level, 1e-6 per m
    float rayleighHeight = 8000;                // scale height, m
    float mieScattering = 3.996f;               // 1e-6 per m
    float mieExtinction = 4.44f;                // 1e-6 per m
    float mieHeight = 1200;                     // scale height, m
    float mieG = 0.8f;                          // asymmetry of the Cornette-Shanks phase
    glm::vec3 ozone{0.650f, 1.881f, 0.085f};    // absorption at 25 km, 1e-6 per m
    float groundAlbedo = 0.3f;
    float planetRadius = 6360;                  // km
    float airDepth = 100;                       // km from the ground to where there is none
    float ambient = 1;                          // factor on the light that the sky gives to surfaces
    float aerial = 1;                           // factor on distances, for the air before what is far away; 0: none
    float stars = 1;                            // factor on the light of stars
    bool operator==(const Sky&) const = default;
};

struct Clouds {
    bool on = true;
    CloudKind kind = CloudKind::Volume;
    float coverage = 0.35f; // share of the sky, 0..1
    float altitude = 2500;  // m
    float softness = 0.25f; // width of a cloud's edge, 0..1
    float speed = 12;       // m/s
    float direction = 70;   // degrees clockwise from north that they drift towards
    float size = 11000;     // m, after which the pattern repeats
    float change = 1;       // factor on how fast they change their shape while they drift
    float thickness = 1400; // m from the base, of clouds that are volumes
    float density = 0.04f;  // extinction in the thick of one, per m
    float shadow = 1;       // share of the sun that a thick cloud takes from the ground
    int seed = 0;
    bool operator==(const Clouds&) const = default;
};

struct Wind {
    float speed = 3;         // m/s, in the mean; 0: nothing sways
    float direction = 70;    // degrees clockwise from north that it blows towards
    float gustiness = 0.4f;  // share of the speed by which gusts and lulls differ from it, 0..1
    bool operator==(const Wind&) const = default;
};

struct Fog {
    bool on = true;
    float density = 0.00012f; // extinction at height `base`, per m
    float height = 220;       // scale height over which it thins out, m
    float base = 0;           // m
    glm::vec3 tint{1};        // factor on the sky's colour that it takes
    float shafts = 1;         // how much of the light in it is cut out by shadows: 0 none, 1 all
    bool operator==(const Fog&) const = default;
};

struct Shadows {
    bool on = true;
    int cascades = 4;       // 1..6
    float distance = 350;   // m, end of the last cascade
    Splits splits = Splits::Practical;
    float lambda = 0.85f;   // 0 uniform splits, 1 logarithmic
    float end1 = 15, end2 = 45, end3 = 110, end4 = 250, end5 = 600; // m, of all cascades but the last; used when manual
    int resolution = 2048;  // texels along a side of each cascade
    ShadowFilter filter = ShadowFilter::Pcf3;
    float softness = 1;     // factor on the filter's reach
    bool contact = false;   // sharp where a shadow begins, softer away from what throws it; the two nearest cascades
    float blend = 0.1f;     // share of a cascade over which it turns into the next
    float fade = 0.08f;     // share of the distance over which shadows end
    float bias = 1;         // normal offset, texels
    float depthBias = 1;    // towards the sun, texels
    bool operator==(const Shadows&) const = default;
};

struct Weather {
    float rain = 0; // mm an hour
    float snow = 0; // mm of water an hour
    bool operator==(const Weather&) const = default;
};

// Of lakes and the sea: one level in all of the world, where the ground lies lower.
struct Water {
    bool on = false;
    float level = 0;                            // m
    glm::vec3 colour{0.012f, 0.045f, 0.05f};    // of what the water itself scatters, linear
    float clarity = 4;                          // m after which a third of the light is left
    float waves = 0.25f;                        // m, of the highest from trough to crest
    float wavelength = 14;                      // m, of the longest
    float foam = 0.5f;                          // how much lies along shores
    bool operator==(const Water&) const = default;
};

struct Occlusion {
    bool on = true;
    float radius = 2;   // m
    float strength = 1; // power on the share of the sky that is seen
    bool operator==(const Occlusion&) const = default;
};

// Exposure from what is in view: middle grey for the mean of its logarithms, without the darkest and brightest parts.
struct AutoExposure {
    bool on = false;
    float compensation = 0;     // EV
    float lowest = -4;          // EV, of the exposure that may be chosen
    float highest = 12;         // EV
    float seconds = 1;          // after which two thirds of a change are made
    float darkness = 0.3f;      // share, in EV, that stays of what a scene is darker than a day: night is not to look like noon
    bool operator==(const AutoExposure&) const = default;
};

// What happens to the finished light: lens and film.
struct Grading {
    float bloom = 0.04f;       // share of light that the lens scatters
    float temperature = 6500;  // K, of the light that is to look white
    float tint = 0;            // -1 green .. 1 magenta
    float contrast = 1;        // around middle grey
    float saturation = 1;
    float vignette = 0.15f;    // how much darker the corners are
    float grain = 0;
    bool dither = true;        // against bands where the picture changes slowly
    ToneMap toneMap = ToneMap::Agx;
    AntiAliasing antiAliasing = AntiAliasing::Fxaa;
    Shading shading = Shading::Pbr; // of surfaces
    bool operator==(const Grading&) const = default;
};

struct Environment {
    float time = 10.5f;   // hours
    Clock clock = Clock::Solar;
    float timeZone = 0;   // hours from UTC, east positive; used with Clock::Zone
    int dayOfYear = 172;  // 1..366
    int year = 2026;
    float latitude = 49;  // degrees, north positive
    float longitude = 0;  // degrees, east positive
    float daySpeed = 60;  // seconds of the world in each second while the day runs
    bool dayRuns = false; // while somebody plays
    float exposure = 3.3f; // EV: the picture is multiplied by 2^exposure before tone mapping
    AutoExposure autoExposure;
    Sun sun;
    Moon moon;
    Sky sky;
    Clouds clouds;
    Weather weather;
    Wind wind;
    Fog fog;
    Water water;
    Shadows shadows;
    Occlusion occlusion;
    Grading grading;
    Extra extra;

    bool operator==(const Environment&) const = default;
};

// Unit vector towards the sun, from the hour, the day and the latitude or by hand.
glm::dvec3 towardSun(const Environment& environment);

// So many hours of the clock later, also on another day or in another year.
Environment hoursLater(Environment environment, double hours);

} // namespace io
