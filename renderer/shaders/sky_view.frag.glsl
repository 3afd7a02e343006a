// Table: the clear sky around the eye, and the lit ground of the planet below the horizon.
#include "light.glsl"
#include "shared/atmosphere.h"

layout(binding = TRANSMITTANCE_UNIT) uniform sampler2D transmittanceTable;
layout(binding = MULTI_SCATTER_UNIT) uniform sampler2D multiScatterTable;
layout(location = 0) out vec4 radiance;

vec3 sunTransmittance(Atmosphere air, float altitude, float mu)
{
    return textureLod(transmittanceTable, transmittanceUv(altitude, mu), 0.0).rgb *
           sunAboveHorizon(altitude, mu, light.sunRadius);
}
vec3 multipleScattering(Atmosphere air, float altitude, float mu)
{
    return textureLod(multiScatterTable, multiScatterUv(altitude, mu), 0.0).rgb;
}

#include "shared/sky_integral.h"

void main()
{
    Atmosphere air = light.atmosphere;
    vec2 place = skyViewTexel(air.horizon, gl_FragCoord.xy);
    float muView = sin(place.x);
    float muSun = light.towardSun.y;
    float nu = muView * muSun + cos(place.x) * sqrt(max(1.0 - muSun * muSun, 0.0)) * cos(place.y);

    SkyRay sky = integrateSky(air, air.eyeAltitude, muView, muSun, nu, 32);
    if (sky.hit > 0.5) {
        float t = distanceToGround(air.eyeAltitude, muView);
        float mu = cosineAlong(air.eyeAltitude, muView, muSun, nu, t);
        // The sky lights the ground too; pi times the scattered light overhead stands for its irradiance.
        vec3 irradiance = sunTransmittance(air, 0.0, mu) * max(mu, 0.0) +
                          3.14159265 * multipleScattering(air, 0.0, mu);
        sky.radiance += sky.transmittance * irradiance * air.groundAlbedo / 3.14159265;
    }
    radiance = vec4(sky.radiance, 1.0);
}
