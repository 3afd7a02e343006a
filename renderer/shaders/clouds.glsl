// One layer of clouds on a shell over the planet, a field of noise that drifts with the wind.
#include "light.glsl"

layout(binding = NOISE_UNIT) uniform sampler2D noiseField;

const float kCloudTile = 11000.0; // m, one repeat of the field

// How far the field is above the edge of clouds; 1 in the thick of them.
float cloudField(vec2 place, float lod)
{
    vec2 uv = place * (1.0 / kCloudTile);
    float billows = textureLod(noiseField, uv, lod).r;
    float broad = textureLod(noiseField, uv.yx * 0.31 + 0.37, lod - 1.7).b; // wide gaps and gatherings
    float fine = textureLod(noiseField, uv * 4.7 + 0.11, lod + 2.2).g;
    float shape = billows * 0.62 + broad * 0.38 - (1.0 - fine) * 0.13;
    return (shape - light.cloudEdge) / light.cloudWidth + 0.5;
}

// Share of the light that a cloud takes away straight through it.
float cloudCover(float field)
{
    float x = clamp(field, 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x);
}
