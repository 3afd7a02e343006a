// Table: the clear sky around the eye, and the lit ground of the planet below the horizon.
#include "air_light.glsl"
#include "heavens.glsl"

layout(location = 0) out vec4 radiance;

void main()
{
    Atmosphere air = light.atmosphere;
    vec2 place = skyViewTexel(air.horizon, gl_FragCoord.xy);
    float muView = sin(place.x);
    float muSun = heavens.towardSun.y;
    float nu = muView * muSun + cos(place.x) * sqrt(max(1.0 - muSun * muSun, 0.0)) * cos(place.y);
    radiance = vec4(skyAlong(air, air.eyeAltitude, muView, muSun, nu, 1.0, 32), 1.0);
}
