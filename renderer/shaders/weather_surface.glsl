// What rain and snow make of surfaces that face up.
#include "clouds.glsl"
#include "view.glsl"

layout(binding = NOISE_UNIT) uniform sampler2D noiseField;

const float kPatches = 1.0 / 211.0; // repeats of the noise in a metre
const vec3 kSnow = vec3(0.86, 0.89, 0.93);

// How much of the sky's water or snow a surface catches: nothing of it on walls and overhangs.
float catches(vec3 normal)
{
    return smoothstep(0.3, 0.75, normal.y);
}

// In the world's metres. Whole repeats are taken off the eye first, so that little is lost of what is added.
vec2 weatherPlace(vec3 relative)
{
    return fract(view.eyeHigh.xz * kPatches) / kPatches + view.eyeLow.xz + relative.xz;
}

// Wet: what is porous soaks up water and gets darker, a film makes it smooth (Lagarde, "Water drop 3b", 2013). Under snow: white
// and rough. Both come in patches until there is enough of them.
void weatherSurface(inout vec3 baseColour, inout float roughness, inout float metallic, vec3 normal, vec3 relative)
{
    if (clouds.wet + clouds.snow <= 0.0 || relative.y < clouds.water) return;
    float up = catches(normal);
    if (up <= 0.0) return;
    vec2 place = weatherPlace(relative) * kPatches;
    float lod = log2(max(length(relative) * view.pixelAngle * kPatches * float(textureSize(noiseField, 0).x), 0.01));
    float patches = textureLod(noiseField, place, lod).b * 0.4 + textureLod(noiseField, place * 7.0, lod + 2.8).a * 0.35 +
                    textureLod(noiseField, place.yx * 60.0, lod + 5.9).g * 0.25;
    patches = clamp(patches * 1.8 - 0.4, 0.0, 1.0); // its values keep to the middle

    float wet = clamp(clouds.wet * 1.4 - patches * 0.4, 0.0, 1.0) * up;
    float porous = clamp((roughness - 0.4) / 0.4, 0.0, 1.0) * (1.0 - metallic);
    baseColour *= mix(1.0, 0.6, wet * porous);
    float film = mix(0.2, 0.65, porous); // what soaks it up keeps little of it on top
    roughness = mix(roughness, min(roughness, mix(0.75, film, smoothstep(0.45, 0.65, patches))), wet);

    float snow = clamp((clouds.snow * 1.3 - patches) / 0.3, 0.0, 1.0) * up;
    baseColour = mix(baseColour, kSnow, snow);
    roughness = mix(roughness, 0.65, snow);
    metallic *= 1.0 - snow;
}
