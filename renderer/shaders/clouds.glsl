// One layer of clouds on a shell over the planet, a field of noise that drifts with the wind.
#include "light.glsl"

layout(binding = NOISE_UNIT) uniform sampler2D noiseField;

const float kCloudTile = 11000.0; // m, one repeat of the field

// Thickness of the cloud over a place of the field, 0 to 1.
float cloudThickness(vec2 place, float lod)
{
    vec2 uv = place * (1.0 / kCloudTile);
    float billows = textureLod(noiseField, uv, lod).r;
    float broad = textureLod(noiseField, uv.yx * 0.31 + 0.37, lod).b; // wide gaps and gatherings
    float fine = textureLod(noiseField, uv * 4.7 + 0.11, lod).g;
    float shape = billows * 0.62 + broad * 0.38 - (1.0 - fine) * 0.13;
    float edge = mix(0.74, 0.18, light.cloudCoverage);
    return smoothstep(edge, edge + 0.06 + 0.5 * light.cloudSoftness, shape);
}

// Share of the sun that reaches a place under the clouds.
float cloudShadow(vec3 relative)
{
    float climb = light.cloudAltitude - relative.y;
    vec2 place = light.cloudOrigin + relative.xz + light.towardSun.xz * (climb / max(light.towardSun.y, 0.12));
    float shade = 1.0 - 0.72 * cloudThickness(place, 2.0);
    return light.cloudsOn > 0.0 && climb > 0.0 ? mix(1.0, shade, light.cloudsOn) : 1.0;
}
