// The light that the air scatters into a ray. The includer says how light reaches a point of the air:
//     vec3 sunTransmittance(Atmosphere air, float altitude, float muSun)   - 0 in the earth's shadow
//     vec3 multipleScattering(Atmosphere air, float altitude, float muSun) - per unit of scattering coefficient
// from tables in a shader, by integration in a test.
#ifndef SHARED_SKY_INTEGRAL_H
#define SHARED_SKY_INTEGRAL_H
#include "atmosphere.h"
SHARED_BEGIN

struct SkyRay {
    vec3 radiance;      // per unit of sun irradiance, 1/sr
    vec3 transmittance; // to the end of the ray
    float hit;          // 1: it ends on the ground
};

// Of the light that haze scatters this share goes on nearly straight; for all orders above the first it counts as not scattered
// at all, and the rest as scattered evenly (similarity of Joseph, Wiscombe and Weinman 1976, with an even remainder).
SHARED_FUNCTION float straightOn(Atmosphere air)
{
    return max(air.mieG, 0.0f);
}

// To `end` km. `nu` is the cosine between the ray and the sun. Steps grow with the square of their number, and the light of a
// step is integrated against its own extinction. `orders`: 0 for the first order of scattering alone, 1 for all.
SHARED_FUNCTION SkyRay integrateSkyTo(Atmosphere air, float altitude, float muView, float muSun, float nu, float end, float orders, int steps)
{
    float phaseRayleigh = rayleighPhase(nu);
    float phaseMie = miePhase(air.mieG, nu);
    float onward = orders * straightOn(air);
    SkyRay ray;
    ray.radiance = vec3(0.0f);
    ray.transmittance = vec3(1.0f);
    ray.hit = 0.0f;
    for (int i = 0; i < steps; ++i) {
        float s0 = float(i) / float(steps);
        float s1 = float(i + 1) / float(steps);
        float from = end * s0 * s0;
        float to = end * s1 * s1;
        float sm = 0.5f * (s0 + s1);
        float t = end * sm * sm;
        float h = max(altitudeAlong(air, altitude, muView, t), 0.0f);
        float mu = cosineAlong(air, altitude, muView, muSun, nu, t);
        Medium medium = mediumAt(air, h);
        vec3 source = (medium.rayleigh * phaseRayleigh + vec3(medium.mieScattering * phaseMie)) * sunTransmittance(air, h, mu);
        source += (medium.rayleigh + vec3(medium.mieScattering * (1.0f - onward))) * multipleScattering(air, h, mu) * orders;
        vec3 extinction = max(medium.extinction - vec3(medium.mieScattering * onward), vec3(1e-9f));
        vec3 stepTransmittance = exp(-extinction * (to - from));
        ray.radiance += ray.transmittance * source * (vec3(1.0f) - stepTransmittance) / extinction;
        ray.transmittance *= stepTransmittance;
    }
    return ray;
}

// To the ground or to the end of the air.
SHARED_FUNCTION SkyRay integrateSky(Atmosphere air, float altitude, float muView, float muSun, float nu, float orders, int steps)
{
    float ground = distanceToGround(air, altitude, muView);
    float end = ground >= 0.0f ? ground : distanceToTop(air, altitude, muView);
    SkyRay ray = integrateSkyTo(air, altitude, muView, muSun, nu, end, orders, steps);
    ray.hit = ground >= 0.0f ? 1.0f : 0.0f;
    return ray;
}

SHARED_END
#endif
