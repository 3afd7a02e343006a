// The sky where nothing stands before it: scattered light, the sun's disc, clouds. All but the disc and the stars is smooth:
// it may be made at a lower resolution first (DOME) and looked up then (FROM_DOME).
#include "fog.glsl"
#include "octahedron.glsl"
#include "shared/bindings.h"
#include "shared/atmosphere.h"
#include "sky_tables.glsl"
#include "view.glsl"
#include "clouds_layer.glsl"
#include "sky_under_clouds.glsl"

layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 ray;
layout(location = 0) out vec4 radiance;
#ifdef FROM_DOME
layout(binding = IMAGE_UNIT) uniform sampler2D dome; // radiance; share of what stands behind that comes through
#endif

// The disc's mean radiance is its irradiance over its solid angle; the limb is darker (Hestroffer and Magnan 1998).
vec3 sunDisc(vec3 direction)
{
    float angle = acos(clamp(dot(direction, light.towardSun), -1.0, 1.0));
    float soft = view.pixelAngle * 0.75;
    float inside = 1.0 - smoothstep(light.sunRadius - soft, light.sunRadius + soft, angle);
    float r = clamp(angle / light.sunRadius, 0.0, 1.0);
    float mu = sqrt(1.0 - r * r);
    vec3 limb = pow(vec3(mu + 1e-3), vec3(0.397, 0.503, 0.652));
    vec3 mean = vec3(2.0) / (vec3(0.397, 0.503, 0.652) + 2.0);
    float altitude = light.atmosphere.eyeAltitude;
    vec3 through = transmittanceToSpace(altitude, direction.y) * step(horizonCosine(altitude), direction.y);
    return light.sunAbove * through * limb / mean * (inside / light.sunSolidAngle);
}

#ifdef STARS
// One star in some cells of a grid over the octahedron of directions.
vec3 stars(vec3 direction)
{
    const float kCells = 170.0;
    vec2 place = octahedral(direction.xzy) * kCells;
    vec2 cell = floor(place);
    uvec2 c = uvec2(ivec2(cell) + 4096);
    uint h = (c.x * 0x8da6b343u) ^ (c.y * 0xd8163841u);
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h ^= h >> 13;
    vec2 centre = cell + 0.15 + 0.7 * vec2(h & 0xffu, (h >> 8) & 0xffu) / 255.0;
    float magnitude = float((h >> 16) & 0xffu) / 255.0;
    float reach = 1.5 * view.pixelAngle * kCells / 1.57; // about a pixel
    float glow = max(1.0 - length(place - centre) / max(reach, 0.05), 0.0);
    vec3 tint = mix(vec3(1.0, 0.85, 0.7), vec3(0.75, 0.85, 1.0), float(h >> 24) / 255.0);
    return tint * light.skyFloor.g * 60.0 * pow(magnitude, 14.0) * glow * smoothstep(0.0, 0.2, direction.y);
}
#endif

#ifndef FROM_DOME
vec4 domeTowards(vec3 direction)
{
    float azimuth = azimuthFromSun(direction);
    vec3 sky = skyView(azimuth, asin(clamp(direction.y, -1.0, 1.0))) * light.sunAbove + nightSky(direction.y);
    sky = skyBehindClouds(sky, direction.y);
    vec4 colour = vec4(sky, 1.0);
#ifdef CLOUDS
    if (direction.y > 0.0) colour = withClouds(sky, direction);
#endif

    // Haze over the sky has the sky's own colour: it hides sun and clouds. Below the horizon the ray ends on the
    // planet's ground.
    float reach = direction.y < 0.0 ? min(light.atmosphere.eyeAltitude * 1000.0 / -direction.y, 1e5) : 1e6;
    vec3 level = skyView(azimuth, max(asin(clamp(direction.y, -1.0, 1.0)), 0.0)) * light.sunAbove + nightSky(max(direction.y, 0.0));
    float through = light.fogDensity > 0.0 ? fogTransmittance(direction * reach) : 1.0;
    return mix(vec4(skyUnderClouds(level, direction.y) * light.fogTint, 0.0), colour, through);
}
#endif

void main()
{
    vec3 direction = normalize(ray);
#ifdef FROM_DOME
    vec4 behind = textureLod(dome, uv, 0.0);
#else
    vec4 behind = domeTowards(direction);
#endif
#ifdef DOME
    radiance = behind;
#else
    vec3 disc = sunDisc(direction);
#ifdef STARS
    disc += stars(direction);
#endif
    radiance = vec4(min(behind.rgb + disc * behind.a, vec3(60000.0)), 1.0);
#endif
}
