// How much of the sun the clouds let through to the ground around the eye, along the light to where it leaves their base.
#include "cloud_field.glsl"
#include "clouds_volume.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out float through;

#ifdef VOLUME
const int kSteps = 20;
float straight(vec2 relative)
{
    float tau = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        float h = (float(i) + 0.5) / float(kSteps);
        vec2 aside = clouds.sunward * (h * clouds.thickness);
        tau += cloudExtinction(vec3(relative + aside, 0.0).xzy, h, clouds.mapLod, false);
    }
    float metres = clouds.thickness * length(vec3(clouds.sunward, 1.0)) / float(kSteps);
    return exp(-tau * metres);
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
