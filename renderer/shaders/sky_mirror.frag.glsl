// Table: the clear sky, and the planet's ground below it, blurred by the lobes of five roughnesses: the first sum of the split one
// (Karis, "Real Shading in Unreal Engine 4", 2013), for a surface that is looked at from straight above.
#include "octahedron.glsl"
#include "shared/sky_mirror.h"
#include "sky_tables.glsl"

layout(location = 0) out vec4 radiance;

const int kSamples = 16;

void main()
{
    float level = floor(gl_FragCoord.y / float(SKY_MIRROR_SIZE));
    vec2 texel = vec2(gl_FragCoord.x, gl_FragCoord.y - level * float(SKY_MIRROR_SIZE)) - 0.5;
    vec3 n = fromOctahedral(texel / float(SKY_MIRROR_SIZE - 1) * 2.0 - 1.0).xzy;
    float roughness = skyMirrorRoughness(level);
    float alpha = roughness * roughness;
    if (level < 0.5) {
        radiance = vec4(skyView(n), 1.0);
        return;
    }
    vec3 side = normalize(abs(n.y) < 0.9 ? cross(n, vec3(0.0, 1.0, 0.0)) : cross(n, vec3(1.0, 0.0, 0.0)));
    vec3 third = cross(n, side);
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int i = 0; i < kSamples; ++i) { // half vectors as GGX spreads them, on a spiral
        float u = (float(i) + 0.5) / float(kSamples);
        float cosine = sqrt((1.0 - u) / (1.0 + (alpha * alpha - 1.0) * u));
        float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
        float turn = 2.39996323 * float(i);
        vec3 h = n * cosine + (side * cos(turn) + third * sin(turn)) * sine;
        vec3 l = 2.0 * dot(n, h) * h - n;
        float nol = dot(n, l);
        if (nol <= 0.0) continue;
        sum += skyView(l) * nol;
        weights += nol;
    }
    radiance = vec4(sum / max(weights, 1e-3), 1.0);
}
