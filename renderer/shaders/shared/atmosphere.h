// The air: density, transmittance and phase functions, after Hillaire, "A Scalable and Production Ready Sky and
// Atmosphere Rendering Technique" (EGSR 2020), and the table mapping of Bruneton and Neyret (2008).
// Lengths in km, coefficients per km: float then resolves what matters at both ends.
#ifndef SHARED_ATMOSPHERE_H
#define SHARED_ATMOSPHERE_H
#include "shared.h"
SHARED_BEGIN

#define TRANSMITTANCE_WIDTH 256
#define TRANSMITTANCE_HEIGHT 64
#define MULTI_SCATTER_WIDTH 64  // sun
#define MULTI_SCATTER_HEIGHT 33 // altitude, and one row more: what the ground receives of the sky
#define AERIAL_SIZE 32          // azimuths, elevations and distances
#define AERIAL_REACH 128.0f     // km: from there on, things have become the sky behind them
#define SKY_VIEW_WIDTH 192
#define SKY_VIEW_HEIGHT 144

struct Atmosphere {
    vec3 rayleigh;      float rayleighHeight; // scattering at the ground, per km; km
    vec3 ozone;         float mieHeight;      // absorption at 25 km, per km; km
    float mieScattering; float mieExtinction; // at the ground, per km
    float mieG;         float groundAlbedo;
    float eyeAltitude;  float horizon;        // km above the ground, at least a metre; elevation of the horizon, radians
    float groundRadius; float airDepth;       // km; from the ground to where there is none
};
SHARED_STRUCT_END(Atmosphere, 64)

struct Medium { // at one altitude, per km
    vec3 rayleigh;
    float mieScattering;
    vec3 extinction;
};

SHARED_FUNCTION Medium mediumAt(Atmosphere air, float altitude)
{
    float rayleighDensity = exp(-altitude / air.rayleighHeight);
    float mieDensity = exp(-altitude / air.mieHeight);
    float ozoneDensity = max(0.0f, 1.0f - abs(altitude - 25.0f) / 15.0f);
    Medium medium;
    medium.rayleigh = air.rayleigh * rayleighDensity;
    medium.mieScattering = air.mieScattering * mieDensity;
    medium.extinction = medium.rayleigh + vec3(air.mieExtinction * mieDensity) + air.ozone * ozoneDensity;
    return medium;
}

// r^2 - ground^2 without the cancellation.
SHARED_FUNCTION float aboveGroundSquared(Atmosphere air, float altitude)
{
    return altitude * (2.0f * air.groundRadius + altitude);
}

// Altitude after `t` km along a ray that leaves `altitude` at the cosine `mu` from the zenith.
SHARED_FUNCTION float altitudeAlong(Atmosphere air, float altitude, float mu, float t)
{
    float r = air.groundRadius + altitude;
    float gained = t * (2.0f * r * mu + t);
    return altitude + gained / (sqrt(max(r * r + gained, 0.0f)) + r);
}

// Cosine from the zenith after `t` km, of a direction whose cosine was `mu` (or of another one: `nu` between them).
SHARED_FUNCTION float cosineAlong(Atmosphere air, float altitude, float muView, float muOther, float nu, float t)
{
    float r = air.groundRadius + altitude;
    float rt = air.groundRadius + altitudeAlong(air, altitude, muView, t);
    return clamp((r * muOther + t * nu) / rt, -1.0f, 1.0f);
}

SHARED_FUNCTION float horizonCosine(Atmosphere air, float altitude)
{
    return -sqrt(aboveGroundSquared(air, altitude)) / (air.groundRadius + altitude);
}

SHARED_FUNCTION float distanceToTop(Atmosphere air, float altitude, float mu)
{
    float r = air.groundRadius + altitude;
    float rest = (air.airDepth - altitude) * (2.0f * air.groundRadius + air.airDepth + altitude); // top^2 - r^2
    return max(0.0f, -r * mu + sqrt(max(r * r * mu * mu + rest, 0.0f)));
}

// Negative when the ray misses the ground.
SHARED_FUNCTION float distanceToGround(Atmosphere air, float altitude, float mu)
{
    float r = air.groundRadius + altitude;
    float discriminant = r * r * mu * mu - aboveGroundSquared(air, altitude);
    return mu >= 0.0f || discriminant < 0.0f ? -1.0f : -r * mu - sqrt(discriminant);
}

SHARED_FUNCTION float rayleighPhase(float cosine)
{
    return 3.0f / (16.0f * 3.14159265f) * (1.0f + cosine * cosine);
}

// Cornette and Shanks (1992).
SHARED_FUNCTION float miePhase(float g, float cosine)
{
    float g2 = g * g;
    float base = max(1.0f + g2 - 2.0f * g * cosine, 1e-6f);
    return 3.0f / (8.0f * 3.14159265f) * (1.0f - g2) * (1.0f + cosine * cosine) / ((2.0f + g2) * base * sqrt(base));
}

// Through the air from `altitude` to space, by the trapezoid rule on steps that grow with the square.
SHARED_FUNCTION vec3 integrateTransmittance(Atmosphere air, float altitude, float mu, int steps)
{
    float end = distanceToTop(air, altitude, mu);
    vec3 depth = vec3(0.0f);
    float before = 0.0f;
    vec3 extinctionBefore = mediumAt(air, altitude).extinction;
    for (int i = 1; i <= steps; ++i) {
        float s = float(i) / float(steps);
        float t = end * s * s;
        vec3 extinction = mediumAt(air, altitudeAlong(air, altitude, mu, t)).extinction;
        depth += (extinction + extinctionBefore) * (0.5f * (t - before));
        before = t;
        extinctionBefore = extinction;
    }
    return exp(-depth);
}

// Share of the sun's disc above the horizon that is seen from `altitude`.
SHARED_FUNCTION float sunAboveHorizon(Atmosphere air, float altitude, float muSun, float sunRadius)
{
    return smoothstep(-sunRadius, sunRadius, muSun - horizonCosine(air, altitude));
}

SHARED_FUNCTION vec2 transmittanceUv(Atmosphere air, float altitude, float mu)
{
    float toHorizon = sqrt(aboveGroundSquared(air, altitude));
    float longest = sqrt(aboveGroundSquared(air, air.airDepth));
    float shortest = air.airDepth - altitude;
    float d = distanceToTop(air, altitude, mu);
    float u = (d - shortest) / max(toHorizon + longest - shortest, 1e-4f);
    vec2 uv = vec2(clamp(u, 0.0f, 1.0f), toHorizon / longest);
    return (uv * vec2(TRANSMITTANCE_WIDTH - 1, TRANSMITTANCE_HEIGHT - 1) + 0.5f) /
           vec2(TRANSMITTANCE_WIDTH, TRANSMITTANCE_HEIGHT);
}

// The inverse: altitude and cosine of a texel of the transmittance table.
SHARED_FUNCTION vec2 transmittanceTexel(Atmosphere air, vec2 pixel)
{
    vec2 uv = (pixel - 0.5f) / vec2(TRANSMITTANCE_WIDTH - 1, TRANSMITTANCE_HEIGHT - 1);
    float longest = sqrt(aboveGroundSquared(air, air.airDepth));
    float toHorizon = uv.y * longest;
    float r = sqrt(air.groundRadius * air.groundRadius + toHorizon * toHorizon);
    float altitude = toHorizon * toHorizon / (r + air.groundRadius);
    float shortest = air.airDepth - altitude;
    float d = shortest + uv.x * (toHorizon + longest - shortest);
    float mu = d <= 0.0f ? 1.0f : (longest * longest - toHorizon * toHorizon - d * d) / (2.0f * r * d);
    return vec2(altitude, clamp(mu, -1.0f, 1.0f));
}

// The sun's axis is stretched around the horizon, where the light changes fastest: by the cube root.
SHARED_FUNCTION float multiScatterU(float muSun)
{
    float x = 0.5f + 0.5f * sign(muSun) * pow(abs(muSun), 1.0f / 3.0f);
    return (x * float(MULTI_SCATTER_WIDTH - 1) + 0.5f) / float(MULTI_SCATTER_WIDTH);
}

SHARED_FUNCTION vec2 multiScatterUv(Atmosphere air, float altitude, float muSun)
{
    float y = sqrt(clamp(altitude / air.airDepth, 0.0f, 1.0f));
    return vec2(multiScatterU(muSun), (y * float(MULTI_SCATTER_HEIGHT - 2) + 0.5f) / float(MULTI_SCATTER_HEIGHT));
}

// Where the irradiance of the sky on level ground is, over pi.
SHARED_FUNCTION vec2 groundIrradianceUv(float muSun)
{
    return vec2(multiScatterU(muSun), 1.0f - 0.5f / float(MULTI_SCATTER_HEIGHT));
}

// The inverse: altitude, cosine of the sun from the zenith, and 1 in the row of the ground.
SHARED_FUNCTION vec3 multiScatterTexel(Atmosphere air, vec2 pixel)
{
    float x = 2.0f * (pixel.x - 0.5f) / float(MULTI_SCATTER_WIDTH - 1) - 1.0f;
    float y = (pixel.y - 0.5f) / float(MULTI_SCATTER_HEIGHT - 2);
    bool ground = pixel.y > float(MULTI_SCATTER_HEIGHT - 1);
    return vec3(ground ? 0.0f : y * y * air.airDepth, x * x * x, ground ? 1.0f : 0.0f);
}

// The sky around the eye: u grows from the sun's azimuth to the opposite one, v from straight down to straight up,
// both crowded where the sky changes fastest.
SHARED_FUNCTION vec2 skyViewUv(float horizon, float elevation, float azimuthFromSun)
{
    float e = elevation - horizon;
    float span = e >= 0.0f ? 1.57079633f - horizon : 1.57079633f + horizon;
    float half_ = 0.5f * sqrt(clamp(abs(e) / span, 0.0f, 1.0f));
    // Each half keeps to its own rows, so that the ground never bleeds over the horizon.
    float rows = float(SKY_VIEW_HEIGHT);
    float v = e >= 0.0f ? 0.5f + (0.5f + 2.0f * half_ * (0.5f * rows - 1.0f)) / rows
                        : 0.5f - (0.5f + 2.0f * half_ * (0.5f * rows - 1.0f)) / rows;
    float u = pow(clamp(azimuthFromSun / 3.14159265f, 0.0f, 1.0f), 0.6f);
    return vec2((u * float(SKY_VIEW_WIDTH - 1) + 0.5f) / float(SKY_VIEW_WIDTH), v);
}

// The inverse: elevation and azimuth from the sun of a texel's centre.
SHARED_FUNCTION vec2 skyViewTexel(float horizon, vec2 pixel)
{
    float rows = float(SKY_VIEW_HEIGHT);
    bool above = pixel.y > 0.5f * rows;
    float fromMiddle = above ? pixel.y - 0.5f * rows : 0.5f * rows - pixel.y;
    float s = clamp((fromMiddle - 0.5f) / (0.5f * rows - 1.0f), 0.0f, 1.0f);
    float elevation = above ? horizon + s * s * (1.57079633f - horizon) : horizon - s * s * (1.57079633f + horizon);
    float u = clamp((pixel.x - 0.5f) / float(SKY_VIEW_WIDTH - 1), 0.0f, 1.0f);
    return vec2(elevation, 3.14159265f * pow(u, 1.0f / 0.6f));
}

// The air before things at a distance, around the eye: azimuth from the sun, elevation, distance. Slices lie with the square,
// the first at 0 m. `up` is the sine of the elevation.
SHARED_FUNCTION vec2 aerialUv(float up, float cosAzimuth)
{
    float u = sqrt(clamp(0.5f - 0.5f * cosAzimuth, 0.0f, 1.0f));
    float v = 0.5f + 0.5f * sign(up) * sqrt(abs(up));
    return (vec2(u, v) * float(AERIAL_SIZE - 1) + 0.5f) / float(AERIAL_SIZE);
}

// The inverse: sine of the elevation, cosine of the azimuth.
SHARED_FUNCTION vec2 aerialTexel(vec2 pixel)
{
    vec2 uv = (pixel - 0.5f) / float(AERIAL_SIZE - 1);
    float v = 2.0f * uv.y - 1.0f;
    return vec2(v * abs(v), 1.0f - 2.0f * uv.x * uv.x);
}

SHARED_FUNCTION float aerialDistance(float slice) // km
{
    float s = slice / float(AERIAL_SIZE - 1);
    return AERIAL_REACH * s * s;
}

SHARED_FUNCTION float aerialSlice(float distance_) // km
{
    return float(AERIAL_SIZE - 1) * sqrt(min(distance_ / AERIAL_REACH, 1.0f));
}

SHARED_END
#endif
