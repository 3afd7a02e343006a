// What rain and snow make of surfaces that face up.
#include "clouds.glsl"
#include "view.glsl"

layout(binding = NOISE_UNIT) uniform sampler2D noiseField;

const float kPatches = 1.0 / 23.0; // repeats of the noise in a metre
const vec3 kSnow = vec3(0.86, 0.89, 0.93);

// How much of the sky's water or snow a surface catches: nothing of it on walls and overhangs.
float catches(vec3 normal)
{
    return smoothstep(0.3, 0.75, normal.y);
}

// Wet: what is porous soaks up water and gets darker, a film makes it smooth (Lagarde, "Water drop 3b", 2013). Under snow: white
// and rough. Both come in patches until there is enough of them. `place` is in the world's metres, as far as floats go.
void weatherSurface(inout vec3 baseColour, inout float roughness, inout float metallic, vec3 normal, vec2 place)
{
    if (clouds.wet + clouds.snow <= 0.0) return;
    float up = catches(normal);
    if (up <= 0.0) return;
    float patches = textureLod(noiseField, place * kPatches, 0.0).b * 0.6 + textureLod(noiseField, place * (kPatches * 5.0), 0.0).a * 0.4;

    float wet = clamp(clouds.wet * 1.4 - patches * 0.4, 0.0, 1.0) * up;
    float porous = clamp((roughness - 0.4) / 0.4, 0.0, 1.0) * (1.0 - metallic);
    baseColour *= mix(1.0, 0.45, wet * porous);
    roughness = mix(roughness, min(roughness, mix(0.5, 0.15, smoothstep(0.45, 0.6, patches))), wet);

    float snow = clamp((clouds.snow * 1.3 - patches) / 0.3, 0.0, 1.0) * up;
    baseColour = mix(baseColour, kSnow, snow);
    roughness = mix(roughness, 0.65, snow);
    metallic *= 1.0 - snow;
}

vec2 weatherPlace(vec3 relative)
{
    // Whole repeats taken off the eye first, so that little is lost of what is added.
    vec2 eye = fract(view.eyeHigh.xz * kPatches) / kPatches + view.eyeLow.xz;
    return eye + relative.xz;
}
