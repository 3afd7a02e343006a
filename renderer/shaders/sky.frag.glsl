// The sky where nothing stands before it: scattered light, sun, moon and stars, clouds. All but those bodies is smooth: it may be
// made at a lower resolution first (DOME) and looked up then (FROM_DOME).
#include "fog.glsl"
#include "shared/bindings.h"
#include "shared/atmosphere.h"
#include "sky_tables.glsl"
#include "view.glsl"
#include "clouds_layer.glsl"
#include "sky_under_clouds.glsl"
#ifdef MOON
#include "moon.glsl"
#endif
#ifdef STARS
#include "stars.glsl"
#endif
#ifdef INTEGRAL
#include "air_light.glsl"
#endif

layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 ray;
layout(location = 0) out vec4 radiance;
#ifdef FROM_DOME
layout(binding = IMAGE_UNIT) uniform sampler2D dome; // radiance; share of what stands behind that comes through

// As a cubic B-spline by four bilinear taps (Sigg and Hadwiger, "Fast Third-Order Texture Filtering", GPU Gems 2): between its few
// pixels edges of clouds would be stairs.
vec4 domeAt(vec2 place)
{
    vec2 size = vec2(textureSize(dome, 0));
    vec2 at = place * size - 0.5;
    vec2 f = fract(at);
    vec2 f2 = f * f, f3 = f2 * f;
    vec2 w0 = (1.0 - f) * (1.0 - f) * (1.0 - f) * (1.0 / 6.0);
    vec2 w1 = (4.0 - 6.0 * f2 + 3.0 * f3) * (1.0 / 6.0);
    vec2 w3 = f3 * (1.0 / 6.0);
    vec2 low = w0 + w1, high = 1.0 - low;
    vec2 a = (floor(at) - 0.5 + w1 / low) / size, b = (floor(at) + 1.5 + w3 / high) / size;
    return mix(mix(textureLod(dome, a, 0.0), textureLod(dome, vec2(b.x, a.y), 0.0), high.x),
               mix(textureLod(dome, vec2(a.x, b.y), 0.0), textureLod(dome, b, 0.0), high.x), high.y);
}
#endif

// What the air and the planet let through from outside.
vec3 throughToSpace(vec3 direction)
{
    float altitude = light.atmosphere.eyeAltitude;
    return transmittanceToSpace(altitude, direction.y) * step(horizonCosine(light.atmosphere, altitude), direction.y);
}

// The disc's mean radiance is its irradiance over its solid angle; the limb is darker (Hestroffer and Magnan 1998).
vec3 sunDisc(vec3 direction)
{
    float angle = acos(clamp(dot(direction, heavens.towardSun), -1.0, 1.0));
    float soft = view.pixelAngle * 0.75;
    float inside = 1.0 - smoothstep(light.sunRadius - soft, light.sunRadius + soft, angle);
    float r = clamp(angle / light.sunRadius, 0.0, 1.0);
    float mu = sqrt(1.0 - r * r);
    vec3 limb = pow(vec3(mu + 1e-3), vec3(0.397, 0.503, 0.652));
    vec3 mean = vec3(2.0) / (vec3(0.397, 0.503, 0.652) + 2.0);
    return light.sunAbove * throughToSpace(direction) * limb / mean * (inside / light.sunSolidAngle);
}


#ifndef FROM_DOME
// The clear sky, per unit of sun irradiance.
vec3 clearSky(vec3 direction, float azimuth)
{
#ifdef INTEGRAL // for comparison: the first order alone, integrated for each pixel
    return skyAlong(light.atmosphere, light.atmosphere.eyeAltitude, direction.y, heavens.towardSun.y,
                    dot(direction, heavens.towardSun), 0.0, 48);
#else
    return skyView(azimuth, asin(clamp(direction.y, -1.0, 1.0)));
#endif
}

vec4 domeTowards(vec3 direction)
{
    float azimuth = azimuthFromSun(direction);
    vec3 sky = clearSky(direction, azimuth) * light.sunAbove + nightSky(direction.y);
    sky = skyBehindClouds(sky, direction.y);
    vec4 colour = vec4(sky, 1.0);
#ifdef CLOUDS
    if (direction.y > 0.0) colour = withClouds(sky, direction);
#endif

    // Haze over the sky has the sky's own colour: it hides sun and clouds. Below the horizon the ray ends on the
    // planet's ground.
    float reach = direction.y < 0.0 ? min(light.atmosphere.eyeAltitude * 1000.0 / -direction.y, 1e5)
                                    : min(50.0 * light.fogHeight / max(direction.y, 1e-5), 1e6); // above 50 of its heights there is none
    vec3 level = skyView(azimuth, max(asin(clamp(direction.y, -1.0, 1.0)), 0.0)) * light.sunAbove + nightSky(max(direction.y, 0.0));
    float through = light.fogDensity > 0.0 ? fogTransmittance(direction * reach) : 1.0;
    return mix(vec4(skyUnderClouds(level, direction.y) * light.fogTint, 0.0), colour, through);
}
#endif

void main()
{
    vec3 direction = normalize(ray);
#ifdef FROM_DOME
    vec4 behind = domeAt(uv);
#else
    vec4 behind = domeTowards(direction);
#endif
#ifdef DOME
    radiance = behind;
#else
    vec3 bodies = sunDisc(direction);
#ifdef STARS
    bodies += stars(direction);
#endif
#ifdef MOON
    vec4 moon = moonDisc(direction);
    bodies = mix(bodies, moon.rgb * throughToSpace(direction), moon.a);
#endif
    radiance = vec4(min(behind.rgb + bodies * behind.a, vec3(60000.0)), 1.0);
#endif
}
