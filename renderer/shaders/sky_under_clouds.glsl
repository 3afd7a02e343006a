// The light of a sky that clouds cover in part, in the mean: what air between the ground and them scatters.
#include "clouds.glsl"
#include "sky_light.glsl"

// Radiance under a closed cover: three times as bright overhead as at the horizon (Moon and Spencer 1942, CIE overcast sky).
vec3 overcastRadiance(float up)
{
    float gradation = (1.0 + 2.0 * clamp(up, 0.0, 1.0)) * (3.0 / 7.0);
    return skyLight.overcast.rgb * light.sunAbove * gradation + light.skyFloor;
}

vec3 skyUnderClouds(vec3 clear, float up)
{
    return mix(clear, overcastRadiance(up), clouds.cover * clouds.on);
}
