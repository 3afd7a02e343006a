// The sky where nothing stands before it: scattered light, the sun's disc, clouds.
#include "clouds.glsl"
#include "shared/atmosphere.h"
#include "sky_tables.glsl"
#include "view.glsl"

layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 ray;
layout(location = 0) out vec4 radiance;

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

#ifdef CLOUDS
// Mixes the cloud layer over `sky`.
vec3 withClouds(vec3 sky, vec3 disc, vec3 direction)
{
    // Where the ray meets the shell: r sin(e) is the height of the chord's middle.
    const float kPlanet = 6360000.0;
    float rise = kPlanet * direction.y;
    float above = light.cloudAltitude;
    float t = sqrt(max(rise * rise + 2.0 * kPlanet * above + above * above, 0.0)) - rise;
    vec2 place = light.cloudOrigin + direction.xz * t;
    float lod = log2(max(t * view.pixelAngle / max(direction.y, 0.05) / 21.5, 1.0)) * 0.8;

    float thickness = cloudThickness(place, lod);
    vec2 sunward = light.towardSun.xz / max(light.towardSun.y, 0.25);
    float shade1 = cloudThickness(place + sunward * 160.0, lod + 0.5);
    float shade2 = cloudThickness(place + sunward * 420.0, lod + 1.0);
    float sunDepth = thickness * 1.2 + shade1 * 1.6 + shade2 * 1.4;

    float opacity = 1.0 - exp(-thickness * 5.0);
    float nu = dot(direction, light.towardSun);
    float forwards = miePhase(0.6, nu) * 1.3 + miePhase(0.85, nu) * 0.12;
    vec3 direct = light.sunAtClouds * (exp(-sunDepth * 1.3) * (0.19 + forwards) + exp(-sunDepth * 0.33) * 0.12);
    vec3 around = skyRadiance(normalize(vec3(direction.x * 0.3, 0.9, direction.z * 0.3))) * (0.9 - 0.25 * thickness) +
                  light.sunIrradiance * 0.03;
    vec3 cloud = direct + around;

    // Far clouds sink into the haze of the sky behind them.
    float haze = exp(-t / 38000.0) * smoothstep(0.004, 0.07, direction.y);
    float visible = opacity * haze * light.cloudsOn;
    return mix(sky, cloud, visible) + disc * pow(1.0 - visible, 3.0);
}
#endif

void main()
{
    vec3 direction = normalize(ray);
    vec3 sky = skyRadiance(direction);
    vec3 disc = sunDisc(direction);
#ifdef CLOUDS
    vec3 colour = direction.y > 0.0 && light.cloudAltitude > 0.0 ? withClouds(sky, disc, direction) : sky + disc;
#else
    vec3 colour = sky + disc;
#endif
    radiance = vec4(min(colour, vec3(60000.0)), 1.0);
}
