// The light of a sky that clouds cover in part, in the mean: what air between the ground and them scatters.
#include "clouds.glsl"
#include "sky_light.glsl"

// Radiance under a closed cover: three times as bright overhead as at the horizon (Moon and Spencer 1942, CIE overcast sky).
vec3 overcastRadiance(float up)
{
    float gradation = (1.0 + 2.0 * clamp(up, 0.0, 1.0)) * (3.0 / 7.0);
    return skyLight.overcast.rgb * light.sunAbove * gradation + light.skyFloor;
}

// Share of the sky over the eye that clouds take: what lies under them, an eye above them does not see.
float cloudsOverhead()
{
    return clouds.cover * clouds.on * smoothstep(0.0, 500.0, clouds.base);
}

// Towards the horizon and below it one looks along air that clouds shade; higher up, through the gaps between them.
vec3 skyBehindClouds(vec3 clear, float up)
{
    float shaded = 1.0 - smoothstep(0.0, 0.06, up);
    return mix(clear, overcastRadiance(0.0), shaded * cloudsOverhead());
}

vec3 skyUnderClouds(vec3 clear, float up)
{
    return mix(clear, overcastRadiance(up), cloudsOverhead());
}
