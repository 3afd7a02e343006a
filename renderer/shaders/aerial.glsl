// The air before what is far away, from the sky's own table: it takes light away and adds its own, so that what is farther
// still becomes the sky. Wants AERIAL; without it, nothing is changed.
#include "heavens.glsl"
#include "light.glsl"
#include "sky_tables.glsl"
#include "sky_under_clouds.glsl"

#ifdef AERIAL
layout(binding = AERIAL_UNIT) uniform sampler2DArray aerialTable;

const float kClear = 0.04; // km, before which the air changes less than a picture can hold: nothing is looked up there

// Optical depth of a layer that thins out with height, over `along` km from `altitude` to `rise` km above it, per unit of
// coefficient at the ground. The world is flat.
float airDepthAlong(float altitude, float rise, float along, float height)
{
    float x = rise / height;
    float share = abs(x) < 1e-3 ? 1.0 - 0.5 * x : (1.0 - exp(-x)) / x;
    return exp(-altitude / height) * share * along;
}

// Light that the air scatters towards the eye before a place `distance_` km away.
vec3 airLight(vec3 direction, float distance_)
{
    float across = max(dot(direction.xz, direction.xz) * dot(heavens.towardSun.xz, heavens.towardSun.xz), 1e-12);
    vec2 place = aerialUv(direction.y, dot(direction.xz, heavens.towardSun.xz) * inversesqrt(across));
    float slice = aerialSlice(distance_);
    // Before the first slice light grows evenly with the distance.
    float near = min(distance_ / aerialDistance(1.0), 1.0);
    float low = clamp(floor(slice), 1.0, float(AERIAL_SIZE - 2));
    vec3 nearer = textureLod(aerialTable, vec3(place, low), 0.0).rgb;
    vec3 farther = textureLod(aerialTable, vec3(place, low + 1.0), 0.0).rgb;
    return mix(nearer, farther, clamp(slice - low, 0.0, 1.0)) * near;
}
#endif

struct AirBefore {
    vec3 through; // share of light that is left
    vec3 light;   // that is added
};

// Before what lies at `relative`, m from the eye.
AirBefore airTo(vec3 relative)
{
    AirBefore before = AirBefore(vec3(1.0), vec3(0.0));
#ifdef AERIAL
    Atmosphere air = light.atmosphere;
    float metres = length(relative);
    float away = metres * (heavens.aerial * 1e-3); // km
    if (away < kClear) return before;
    float rise = max(relative.y * 1e-3, -air.eyeAltitude);
    vec3 depth = air.rayleigh * airDepthAlong(air.eyeAltitude, rise, away, air.rayleighHeight) +
                 vec3(air.mieExtinction * airDepthAlong(air.eyeAltitude, rise, away, air.mieHeight));
    vec3 direction = relative / max(metres, 1e-3);
    before.through = exp(-depth);
    // Under a closed cover of clouds air is lit by them, not by sun and sky.
    vec3 clear = airLight(direction, away) * light.sunAbove + nightSky(0.0) * (vec3(1.0) - before.through) * 0.5;
    before.light = mix(clear, overcastRadiance(0.0) * (vec3(1.0) - before.through), cloudsOverhead());
#endif
    return before;
}

// What is seen of `lit`.
vec3 throughAir(vec3 lit, vec3 relative)
{
    AirBefore air = airTo(relative);
    return lit * air.through + air.light;
}
