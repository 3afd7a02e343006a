// The moon's disc: a sphere lit by the sun, after Lommel and Seeliger, which the dust of the moon follows better than Lambert:
// a full moon is as bright at its edge as in its middle. Seas are two scales of noise.
#include "heavens.glsl"
#include "shared/bindings.h"
#include "view.glsl"

layout(binding = NOISE_UNIT) uniform sampler2D moonNoise;

// Radiance outside the air, and how much of what stands behind the disc covers.
vec4 moonDisc(vec3 direction)
{
    vec3 m = heavens.towardMoon;
    vec3 aside = direction - m * dot(direction, m);
    float r = length(aside) / sin(heavens.moonRadius);
    float soft = 0.75 * view.pixelAngle / heavens.moonRadius;
    float cover = (1.0 - smoothstep(1.0 - soft, 1.0 + soft, r)) * step(0.0, dot(direction, m));
    if (cover <= 0.0) return vec4(0.0);
    vec3 across = aside / max(length(aside), 1e-6);
    float inside = min(r, 1.0);
    float facing = sqrt(1.0 - inside * inside);
    vec3 normal = normalize(across * inside - m * facing); // of the sphere, towards the eye
    float lit = max(dot(normal, heavens.moonLitFrom), 0.0);
    float bright = 2.0 * lit / max(lit + facing, 0.05);

    vec3 pole = heavens.equatorFromWorld[2].xyz;
    vec3 right = normalize(cross(m, pole));
    vec2 face = vec2(dot(normal, right), dot(normal, cross(right, m)));
    float seas = textureLod(moonNoise, face * 0.085 + vec2(0.31, 0.77), 2.0).r * 0.65 +
                 textureLod(moonNoise, face * 0.24 + vec2(0.13, 0.42), 1.0).r * 0.35;
    float albedo = mix(0.62, 1.12, smoothstep(0.42, 0.60, seas));
    const float kEarthshine = 0.004;
    return vec4(heavens.moonRadiance * (albedo * (bright + kEarthshine)), cover);
}
