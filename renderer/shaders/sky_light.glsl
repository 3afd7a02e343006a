#include "light.glsl"

layout(std140, binding = SKY_LIGHT_BINDING) uniform SkyLightBlock { SkyLight skyLight; };

// Irradiance of the sky over pi.
vec3 skyIrradiance(vec3 n)
{
    vec3 e = skyLight.irradiance[0].rgb * 0.282095;
    e += (skyLight.irradiance[1].rgb * n.y + skyLight.irradiance[2].rgb * n.z + skyLight.irradiance[3].rgb * n.x) * 0.488603;
    e += (skyLight.irradiance[4].rgb * (n.x * n.y) + skyLight.irradiance[5].rgb * (n.y * n.z) +
          skyLight.irradiance[7].rgb * (n.x * n.z)) * 1.092548;
    e += skyLight.irradiance[6].rgb * (0.315392 * (3.0 * n.z * n.z - 1.0));
    e += skyLight.irradiance[8].rgb * (0.546274 * (n.x * n.x - n.y * n.y));
    // By night more than stars give: as an eye that is used to the dark sees it.
    return max(e, vec3(0.0)) * light.sunAbove + light.skyFloor * (2.2 + 1.4 * n.y);
}
