// How much of the sun the clouds let through to the ground around the eye, along the light to where it leaves their base.
#include "cloud_field.glsl"
#include "clouds_volume.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out float through;

#ifdef VOLUME
const int kSteps = 64;
const int kRays = 3; // along a side of a texel
float march(vec2 relative, float offset)
{
    float metres = clouds.thickness * length(vec3(clouds.sunward, 1.0)) / float(kSteps);
    float tau = 0.0;
    for (int i = 0; i < kSteps && tau < 6.0; ++i) {
        float h = (float(i) + offset) / float(kSteps);
        vec2 aside = clouds.sunward * (h * clouds.thickness);
        tau += cloudExtinction(vec3(relative + aside, 0.0).xzy, h, clouds.mapLod, true) * metres;
    }
    return exp(-tau);
}

// The mean over a texel, in which an edge may lie.
float straight(vec2 relative)
{
    const float kTexel = CLOUD_MAP_METRES / float(CLOUD_MAP_SIZE);
    float sum = 0.0;
    for (int i = 0; i < kRays * kRays; ++i) {
        vec2 aside = (vec2(i % kRays, i / kRays) + 0.5) / float(kRays) - 0.5;
        sum += march(relative + aside * kTexel, (float(i * 4 % 9) + 0.5) / 9.0);
    }
    return sum / float(kRays * kRays);
}
#else
float straight(vec2 relative)
{
    float thick = cloudThickness(cloudField(cloudPlace(relative), clouds.mapLod)) * clouds.on;
    return mix(1.0, exp(-0.1 * clouds.density * clouds.thickness), thick);
}
#endif

void main()
{
    through = 1.0 - clouds.shadow * (1.0 - straight(clouds.map.xy + (uv - 0.5) * CLOUD_MAP_METRES));
}
