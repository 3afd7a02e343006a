// The sun's light at a place of the air, from the table of transmittance: what sky_integral.h asks its includer for.
#include "light.glsl"
#include "shared/atmosphere.h"

layout(binding = TRANSMITTANCE_UNIT) uniform sampler2D transmittanceTable;

vec3 transmittanceToSpace(float altitude, float mu)
{
    return textureLod(transmittanceTable, transmittanceUv(light.atmosphere, altitude, mu), 0.0).rgb;
}

vec3 sunTransmittance(Atmosphere air, float altitude, float mu)
{
    return transmittanceToSpace(altitude, mu) * sunAboveHorizon(air, altitude, mu, light.sunRadius);
}
