// At places around the eye: what the map of shadows says, and a march towards the sun over the ground that a texel covers.
#include "cloud_field.glsl"
#include "cloud_shadow.glsl"
#include "clouds_layer.glsl"
#include "clouds_volume.glsl"
#include "view.glsl"

layout(location = 0) out vec4 value;

float march(vec3 relative)
{
    vec2 base = relative.xz + clouds.sunward * (clouds.base - relative.y);
    const int kSteps = 120;
    float tau = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        float h = (float(i) + 0.5) / float(kSteps);
        vec2 at = base + clouds.sunward * (h * clouds.thickness);
        tau += cloudExtinction(vec3(at.x, 0.0, at.y), h, 0.0, true);
    }
    return exp(-tau * clouds.thickness * length(vec3(clouds.sunward, 1.0)) / float(kSteps));
}

void main()
{
    vec2 pixel = floor(gl_FragCoord.xy);
    vec3 relative = vec3(pixel.x * 977.0, fract(pixel.x * 0.37 + pixel.y * 0.71) * 300.0 - 100.0, pixel.y * 1013.0) - vec3(4700.0, 0.0, 4900.0);
    const float kTexel = CLOUD_MAP_METRES / float(CLOUD_MAP_SIZE);
    vec2 texels = ((relative.xz - clouds.sunward * relative.y) / CLOUD_MAP_METRES + clouds.map.zw) * float(CLOUD_MAP_SIZE);
    relative.xz += (floor(texels) + 0.5 - texels) * kTexel; // to the middle of one
    float sum = 0.0;
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 5; ++x) {
            vec2 offset = (vec2(x, y) + 0.5) / 5.0 - 0.5;
            sum += march(relative + vec3(offset.x, 0.0, offset.y) * kTexel);
        }
    value = vec4(cloudShadow(relative), 1.0 - clouds.shadow * (1.0 - sum / 25.0), march(relative), 1.0);
}
