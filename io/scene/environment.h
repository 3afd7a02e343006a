// Light and air of a scene. Every value is a field of the environment file, of the Environment panel and of --set.
#pragma once

#include "io/scene/extra.h"

#include <glm/glm.hpp>

namespace io {

enum class SunMode { Time, Manual };

struct Sun {
    SunMode mode = SunMode::Time;
    float azimuth = 135;        // degrees clockwise from north (-Z); used when manual
    float elevation = 40;       // degrees above the horizon; used when manual
    glm::vec3 irradiance{1};    // linear RGB above the atmosphere
    float angularDiameter = 0.53f; // degrees
    bool operator==(const Sun&) const = default;
};

// Earth's atmosphere after Hillaire 2020, with Mie extinction 4.44e-6 /m (Bruneton's albedo 0.9).
struct Sky {
    glm::vec3 rayleigh{5.802f, 13.558f, 33.1f}; // scattering at sea level, 1e-6 per m
    float rayleighHeight = 8000;                // scale height, m
    float mieScattering = 3.996f;               // 1e-6 per m
    float mieExtinction = 4.44f;                // 1e-6 per m
    float mieHeight = 1200;                     // scale height, m
    float mieG = 0.8f;                          // asymmetry of the Cornette-Shanks phase
    glm::vec3 ozone{0.650f, 1.881f, 0.085f};    // absorption at 25 km, 1e-6 per m
    float groundAlbedo = 0.3f;
    float ambient = 1;                          // factor on the light that the sky gives to surfaces
    bool operator==(const Sky&) const = default;
};

struct Clouds {
    float coverage = 0.35f; // share of the sky, 0..1
    float altitude = 2500;  // m
    float softness = 0.25f; // width of a cloud's edge, 0..1
    float speed = 12;       // m/s
    float direction = 70;   // degrees clockwise from north that they drift towards
    bool operator==(const Clouds&) const = default;
};

struct Wind {
    float speed = 3;         // m/s, in the mean; 0: nothing sways
    float direction = 70;    // degrees clockwise from north that it blows towards
    float gustiness = 0.4f;  // share of the speed by which gusts and lulls differ from it, 0..1
    bool operator==(const Wind&) const = default;
};

struct Fog {
    float density = 0.00012f; // extinction at height `base`, per m
    float height = 220;       // scale height over which it thins out, m
    float base = 0;           // m
    glm::vec3 tint{1};        // factor on the sky's colour that it takes
    bool operator==(const Fog&) const = default;
};

struct Shadows {
    int cascades = 4;       // 1..4
    float distance = 350;   // m, end of the last cascade
    float lambda = 0.85f;   // 0 uniform splits, 1 logarithmic
    int resolution = 2048;  // texels along a side of each cascade
    float softness = 1;     // PCF radius, texels
    float bias = 1;         // normal offset, texels
    bool operator==(const Shadows&) const = default;
};

struct Environment {
    float time = 10.5f;   // hours, local solar time
    int dayOfYear = 172;  // 1..366
    float latitude = 49;  // degrees, north positive
    float exposure = 3.3f; // EV: the picture is multiplied by 2^exposure before tone mapping
    Sun sun;
    Sky sky;
    Clouds clouds;
    Wind wind;
    Fog fog;
    Shadows shadows;
    Extra extra;

    bool operator==(const Environment&) const = default;
};

// Unit vector towards the sun, from the hour, the day and the latitude or by hand.
glm::dvec3 towardSun(const Environment& environment);

} // namespace io
