// All orders of scattering, from the tables: what sky_integral.h asks its includer for.
#include "sun_through_air.glsl"

layout(binding = MULTI_SCATTER_UNIT) uniform sampler2D multiScatterTable;

vec3 multipleScattering(Atmosphere air, float altitude, float mu)
{
    return textureLod(multiScatterTable, multiScatterUv(air, altitude, mu), 0.0).rgb;
}

#include "shared/sky_integral.h"

// The sky, or the planet's ground where the ray meets it. `orders`: 0 for the first order of scattering alone, 1 for all.
vec3 skyAlong(Atmosphere air, float altitude, float muView, float muSun, float nu, float orders, int steps)
{
    SkyRay sky = integrateSky(air, altitude, muView, muSun, nu, orders, steps);
    if (sky.hit > 0.5) {
        float mu = cosineAlong(air, altitude, muView, muSun, nu, distanceToGround(air, altitude, muView));
        vec3 received = sunTransmittance(air, 0.0, mu) * (max(mu, 0.0) / 3.14159265) +
                        textureLod(multiScatterTable, groundIrradianceUv(mu), 0.0).rgb * orders;
        sky.radiance += sky.transmittance * received * air.groundAlbedo;
    }
    return sky.radiance;
}
