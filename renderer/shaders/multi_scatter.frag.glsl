// Table: light of all orders above the first, per unit of scattering coefficient, as if scattered evenly
// (Hillaire 2020, equations 5 to 10).
#include "light.glsl"
#include "shared/atmosphere.h"

layout(binding = TRANSMITTANCE_UNIT) uniform sampler2D transmittanceTable;
layout(location = 0) out vec4 scattered;

const int kDirections = 64;
const int kSteps = 20;

vec3 sunTransmittance(Atmosphere air, float altitude, float mu)
{
    return textureLod(transmittanceTable, transmittanceUv(altitude, mu), 0.0).rgb *
           sunAboveHorizon(altitude, mu, light.sunRadius);
}

void main()
{
    Atmosphere air = light.atmosphere;
    vec2 place = multiScatterTexel(gl_FragCoord.xy);
    float altitude = max(place.x, 0.0005);
    float muSun = place.y;
    vec3 sun = vec3(sqrt(max(1.0 - muSun * muSun, 0.0)), muSun, 0.0);

    vec3 second = vec3(0.0); // light scattered twice
    vec3 share = vec3(0.0);  // what one more scattering passes on
    for (int i = 0; i < kDirections; ++i) {
        float cosine = 1.0 - (2.0 * float(i) + 1.0) / float(kDirections);
        float turn = 2.39996323 * float(i); // golden angle
        float sine = sqrt(1.0 - cosine * cosine);
        vec3 direction = vec3(sine * cos(turn), cosine, sine * sin(turn));
        float nu = dot(direction, sun);

        float ground = distanceToGround(altitude, direction.y);
        float end = ground >= 0.0 ? ground : distanceToTop(altitude, direction.y);
        vec3 through = vec3(1.0);
        for (int step = 0; step < kSteps; ++step) {
            float s0 = float(step) / float(kSteps);
            float s1 = float(step + 1) / float(kSteps);
            float t = end * 0.25 * (s0 + s1) * (s0 + s1);
            float dt = end * (s1 * s1 - s0 * s0);
            float h = max(altitudeAlong(altitude, direction.y, t), 0.0);
            float mu = cosineAlong(altitude, direction.y, muSun, nu, t);
            Medium medium = mediumAt(air, h);
            vec3 scattering = medium.rayleigh + vec3(medium.mieScattering);
            vec3 stepThrough = exp(-medium.extinction * dt);
            vec3 inStep = through * (vec3(1.0) - stepThrough) / max(medium.extinction, vec3(1e-9));
            second += inStep * scattering * sunTransmittance(air, h, mu) / (4.0 * 3.14159265);
            share += inStep * scattering;
            through *= stepThrough;
        }
        if (ground >= 0.0) {
            float mu = cosineAlong(altitude, direction.y, muSun, nu, ground);
            second += through * sunTransmittance(air, 0.0, mu) * max(mu, 0.0) * air.groundAlbedo / 3.14159265;
        }
    }
    second /= float(kDirections);
    share /= float(kDirections);
    scattered = vec4(second / (vec3(1.0) - share), 1.0);
}
