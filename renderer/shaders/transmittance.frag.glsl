// Table: what reaches space of light that leaves an altitude at an angle.
#include "light.glsl"
#include "shared/atmosphere.h"

layout(location = 0) out vec4 transmittance;

void main()
{
    vec2 place = transmittanceTexel(light.atmosphere, gl_FragCoord.xy);
    transmittance = vec4(integrateTransmittance(light.atmosphere, place.x, place.y, 40), 1.0);
}
