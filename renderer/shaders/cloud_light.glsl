// What a cloud sends to the eye, and what the air before it leaves of that.
#include "shared/clouds.h"
#include "sky_tables.glsl"
#include "sky_under_clouds.glsl"

// Radiance of a place in a cloud that hides all behind it. Optical depths: towards the sun, and to the cloud's top and base.
vec3 cloudSource(float tauSun, float powder, float tauTop, float tauBase, float cosine)
{
    float sunHeight = max(light.towardSun.y, 0.0);
    vec3 sky = skyLight.clear.rgb * light.sunAbove;
    float open = 1.0 - clouds.cover * (1.0 - clouds.through);
    vec3 ground = (clouds.sun * (sunHeight / 3.14159265) + sky) * (clouds.albedo * open);
    return clouds.sun * cloudSunlight(tauSun, powder, cosine) + sky * (0.75 * throughCloud(tauTop)) +
           ground * (0.5 * throughCloud(tauBase)) + light.skyFloor * 0.7;
}

// Transmittance of the clear air over `metres` between heights `below` and `above`, km: exponential layers in closed form.
vec3 airBefore(float metres, float below, float above)
{
    Atmosphere air = light.atmosphere;
    vec2 height = vec2(air.rayleighHeight, air.mieHeight);
    vec2 lower = exp(-below / height);
    vec2 upper = exp(-above / height);
    float rise = above - below;
    vec2 mean = abs(rise) < 0.01 ? lower : (lower - upper) * height / rise;
    return exp(-(air.rayleigh * mean.x + vec3(air.mieExtinction * mean.y)) * (metres * 1e-3));
}

// Of a cloud at a distance, `hiding` a share of what is behind it: its light through the air, `haze` letting a share of it through,
// and what those scatter.
vec3 throughAir(vec3 radiance, float hiding, vec3 direction, float metres, float rise, float haze)
{
    float eye = light.atmosphere.eyeAltitude;
    vec3 left = airBefore(metres, eye, max(eye + rise * 1e-3, 0.0));
    vec3 front = skyUnderClouds(skyRadiance(normalize(vec3(direction.x, max(direction.y, 0.01), direction.z))), direction.y);
    return mix(front * hiding, radiance * left + front * ((1.0 - left) * hiding), haze);
}
