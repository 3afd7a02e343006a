// What a surface mirrors of the sky.
#include "octahedron.glsl"
#include "shared/sky_mirror.h"
#include "sky_light.glsl"
#include "sky_tables.glsl"
#include "sky_under_clouds.glsl"

#ifdef STUDIO
vec3 skyMirrored(vec3 mirrored, vec3 normal, float roughness)
{
    return skyIrradiance(mix(mirrored, normal, roughness));
}
#else
layout(binding = SKY_MIRROR_UNIT) uniform sampler2D skyMirrorTable;

// Radiance to multiply by environmentBrdf(). The lobes of rough surfaces are as wide as the harmonics, which cost no lookup.
vec3 skyMirrored(vec3 mirrored, vec3 normal, float roughness)
{
    vec3 wide = skyIrradiance(mix(mirrored, normal, roughness));
    if (roughness >= SKY_MIRROR_ROUGHEST) return wide;
    // Off the mirrored direction towards the normal, as lobes of rough surfaces lean.
    vec3 towards = normalize(mix(mirrored, normal, roughness * roughness));
    vec2 place = octahedral(towards.xzy);
    float level = roughness / SKY_MIRROR_ROUGHEST * float(SKY_MIRROR_LEVELS - 1);
    float low = min(floor(level), float(SKY_MIRROR_LEVELS - 2));
    vec3 sharp = textureLod(skyMirrorTable, skyMirrorUv(place, low), 0.0).rgb;
    vec3 blurred = textureLod(skyMirrorTable, skyMirrorUv(place, low + 1.0), 0.0).rgb;
    vec3 clear = mix(sharp, blurred, level - low) * light.sunAbove + nightSky(towards.y);
    vec3 sky = skyUnderClouds(clear, towards.y); // which one, a surface does not show: their mean
    return mix(sky, wide, smoothstep(SKY_MIRROR_ROUGHEST - 0.15, SKY_MIRROR_ROUGHEST, roughness));
}
#endif
