// A streak for each drop, along the way that it falls in the time that an eye takes; a small quad for each flake.
#include "haze.glsl"
#include "lighting.glsl"
#ifdef LAMPS
#include "lamps.glsl"
#endif
#include "shared/particles.h"
#include "shared/precipitation.h"

layout(std140, binding = PARTICLES_BINDING) uniform PrecipitationBlock { Precipitation falling; };

layout(location = 0) out vec2 corner;       // -1..1
layout(location = 1) flat out vec4 light_;  // radiance, opacity
layout(location = 2) flat out vec4 fog;     // what it adds, and what is left; so near there is no air to speak of
layout(location = 3) flat out vec2 shape;   // of a flake: how it is turned, and how ragged it is

void main()
{
    bool wide = gl_InstanceID >= falling.drops;
    uint seed = uint(gl_InstanceID) * 2654435761u + 17u;
    float side = wide ? PRECIPITATION_WIDE : PRECIPITATION_NEAR;
    vec3 moved = (wide ? falling.movedWide : falling.movedNear).xyz;
    vec3 own = vec3(particleRandom(seed, 0u), particleRandom(seed, 1u), particleRandom(seed, 2u)) * side;
    bool snow = falling.snow != 0;
    if (snow) { // flakes swing; whole turns in the period of time
        float time = falling.movedNear.w * 6.2831853;
        float slow = floor(64.0 + particleRandom(seed, 3u) * 256.0) / 1024.0;
        float phase = particleRandom(seed, 4u) * 6.2831853;
        own += vec3(sin(time * slow + phase), 0.3 * sin(time * slow * 2.0 + phase), cos(time * slow + 2.0 * phase)) * 0.35;
    }
    vec3 at = mod(own + moved, side) - 0.5 * side;
    float away = max(length(at), 0.05);
    vec3 toEye = -at / away;
    float size = falling.size * (0.6 + 0.8 * particleRandom(seed, 5u));
    float pixel = away * view.pixelAngle;
    float drawn = max(size, snow ? 1.6 * pixel : 1.0 * pixel);

    vec3 along = snow ? normalize(view.up) : normalize(falling.fall);
    vec3 across = normalize(cross(along, toEye) + vec3(1e-5, 0.0, 0.0));
    if (snow) along = cross(toEye, across);
    float reach = snow ? 0.5 * drawn : 0.5 * length(falling.fall) * falling.exposure * (0.7 + 0.6 * particleRandom(seed, 6u));
    corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1);
    vec3 relative = at + across * (corner.x * 0.5 * drawn) + along * (corner.y * reach);
    gl_Position = view.clipFromRelative * vec4(relative, 1.0);

    // A drop shows the sky upside down, a flake is white. What is thinner than a pixel covers less of it.
    vec3 sky = skyIrradiance(vec3(0.0, 1.0, 0.0)) * light.ambient;
    float ahead = pow(clamp(-dot(toEye, light.towardSun), 0.0, 1.0), 8.0);
    float seen = sunVisibility(at, toEye), clear = 1.0;
#ifdef CLOUD_SHADOWS
    clear = cloudShadow(at);
#endif
    vec3 sun = sunAt(at), direct = sun * (seen * clear);
    vec3 clouds = sun * (0.06 * (1.0 - clear)); // lit by the sun from above, they are the sky that a drop shows
    vec3 lit = snow ? 0.85 * (0.75 * sky + 0.12 * direct) : sky * 1.1 + clouds + direct * (0.03 + 0.6 * ahead);
    float thin = size / drawn;
    float ends = smoothstep(snow ? 0.15 : 1.5, snow ? 0.6 : 5.0, away) * (1.0 - smoothstep(0.38 * side, 0.5 * side, away));
    light_ = vec4(lit, falling.opacity * ends * (snow ? max(thin * thin, 0.15) : thin));
    shape = snow ? vec2(particleRandom(seed, 7u) * 6.2831853, particleRandom(seed, 8u)) : vec2(0.0, -1.0);
    vec4 clip = view.clipFromRelative * vec4(at, 1.0);
    vec2 place = clip.xy / max(clip.w, view.near) * 0.5 + 0.5;
#ifdef LAMPS
    light_.rgb += lampsAround(at, clamp(place, 0.0, 1.0) / view.texel, 0.1) * (snow ? 0.1 : 0.05);
#endif
    Haze haze = hazeBefore(at, place);
    fog = vec4(max(haze.light, vec3(0.0)), haze.through.g);
}
