// Haze that thins out with height: optical depth in closed form, the sky's own light as its colour.
#include "sky_light.glsl"
#include "sky_tables.glsl"
#include "sky_under_clouds.glsl"

// What is left of light that comes from `relative`.
float fogTransmittance(vec3 relative)
{
    float x = clamp(relative.y / light.fogHeight, -60.0, 1e6);
    float share = abs(x) < 1e-3 ? 1.0 - 0.5 * x : (1.0 - exp(-x)) / x;
    return exp(-light.fogDensity * length(relative) * share);
}

// Near haze is lit from all around, and by the sky well over the horizon; haze that hides what is behind it takes the colour
// of the sky that would be seen there.
vec3 fogColour(vec3 direction, float distance_)
{
    float near = exp(-distance_ * max(1.0 / 1600.0, light.fogDensity));
    vec3 towards = normalize(vec3(direction.x, max(direction.y, 0.1 * near), direction.z));
    vec3 around = skyLight.haze.rgb * light.sunAbove + light.skyFloor * 2.76;
    return mix(skyUnderClouds(skyRadiance(towards), towards.y), around, 0.65 * near) * light.fogTint;
}
