// Table: light of all orders above the first, per unit of scattering coefficient, as if it came evenly from all around.
// Two passes: the light of the sun scattered once, gathered; then what that gives when scattered again (FROM_TABLE). From
// there on each order is a like share of the one before, which closes the sum (Hillaire 2020, equations 5 to 10, but begun an
// order later, so that light finds its way around the edge of the planet's shadow). The last row is what level ground receives.
#include "light.glsl"
#include "sun_through_air.glsl"

layout(binding = MULTI_SCATTER_UNIT) uniform sampler2D scatteredOnce;
layout(location = 0) out vec4 scattered;

vec3 multipleScattering(Atmosphere air, float altitude, float mu) { return vec3(0.0); }
#include "shared/sky_integral.h"

const int kDirections = 64;
const int kSteps = 20;

// Light that reaches a place of the air, and leaves it towards `nu` from the sun: of the sun, or of the air around.
vec3 leaving(Atmosphere air, Medium medium, float altitude, float mu, float nu)
{
    float even = 1.0 - straightOn(air);
#ifdef FROM_TABLE
    return (medium.rayleigh + vec3(medium.mieScattering * even)) *
           textureLod(scatteredOnce, multiScatterUv(air, altitude, mu), 0.0).rgb;
#else
    return (medium.rayleigh * rayleighPhase(nu) + vec3(medium.mieScattering * even * miePhase(air.mieG, nu))) *
           sunTransmittance(air, altitude, mu);
#endif
}

vec3 onGround(Atmosphere air, float mu) // irradiance over pi
{
#ifdef FROM_TABLE
    return textureLod(scatteredOnce, groundIrradianceUv(mu), 0.0).rgb;
#else
    return sunTransmittance(air, 0.0, mu) * max(mu, 0.0) / 3.14159265;
#endif
}

void main()
{
    Atmosphere air = light.atmosphere;
    vec3 place = multiScatterTexel(air, gl_FragCoord.xy);
    bool ground = place.z > 0.5;
    float altitude = max(place.x, 0.0005);
    float muSun = place.y;
    vec3 sun = vec3(sqrt(max(1.0 - muSun * muSun, 0.0)), muSun, 0.0);
    float even = 1.0 - straightOn(air);

    vec3 gathered = vec3(0.0);
    vec3 share = vec3(0.0); // what one more scattering passes on
    for (int i = 0; i < kDirections; ++i) {
        float cosine = 1.0 - (2.0 * float(i) + 1.0) / float(kDirections);
        float turn = 2.39996323 * float(i); // golden angle
        float sine = sqrt(1.0 - cosine * cosine);
        vec3 direction = vec3(sine * cos(turn), cosine, sine * sin(turn));
        float nu = dot(direction, sun);

        float toGround = distanceToGround(air, altitude, direction.y);
        float end = toGround >= 0.0 ? toGround : distanceToTop(air, altitude, direction.y);
        vec3 through = vec3(1.0), along = vec3(0.0), passed = vec3(0.0);
        for (int step = 0; step < kSteps; ++step) {
            float s0 = float(step) / float(kSteps);
            float s1 = float(step + 1) / float(kSteps);
            float t = end * 0.25 * (s0 + s1) * (s0 + s1);
            float dt = end * (s1 * s1 - s0 * s0);
            float h = max(altitudeAlong(air, altitude, direction.y, t), 0.0);
            float mu = cosineAlong(air, altitude, direction.y, muSun, nu, t);
            Medium medium = mediumAt(air, h);
            vec3 extinction = max(medium.extinction - vec3(medium.mieScattering * (1.0 - even)), vec3(1e-9));
            vec3 stepThrough = exp(-extinction * dt);
            vec3 inStep = through * (vec3(1.0) - stepThrough) / extinction;
            along += inStep * leaving(air, medium, h, mu, nu);
            passed += inStep * (medium.rayleigh + vec3(medium.mieScattering * even));
            through *= stepThrough;
        }
        if (toGround >= 0.0)
            along += through * air.groundAlbedo * onGround(air, cosineAlong(air, altitude, direction.y, muSun, nu, toGround));
        // Over the sphere, or over the cosine of the upper half of it.
        gathered += along * (ground ? 4.0 * max(direction.y, 0.0) : 1.0);
        share += passed;
    }
    gathered /= float(kDirections);
    share = min(share / float(kDirections), vec3(0.95));
#ifdef FROM_TABLE
    vec2 here = ground ? groundIrradianceUv(muSun) : multiScatterUv(air, place.x, muSun);
    scattered = vec4(textureLod(scatteredOnce, here, 0.0).rgb + gathered / (vec3(1.0) - share), 1.0);
#else
    scattered = vec4(gathered, 1.0);
#endif
}
