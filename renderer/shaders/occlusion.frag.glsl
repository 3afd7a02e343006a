// How much of the sky each pixel sees past what stands near it: horizons searched along slices of the picture, and the
// arc between them weighed by the cosine in closed form (Jimenez et al., "Practical Realtime Strategies for Accurate
// Indirect Occlusion", 2016). Pixels of a 4 x 4 tile search in different directions; the blur that follows takes the mean.
// View space here: x right, y up, z away from the eye.
#include "gbuffer_in.glsl"
#include "shared/occlusion.h"
#include "view.glsl"

layout(std140, binding = PASS_BINDING) uniform PassBlock { OcclusionPass pass; };
layout(location = 0) out vec2 result; // share of the sky that is seen, depth

const float kPi = 3.14159265;
const float kNearest = 1.3; // pixels, to the first place looked at
const float kLeafShare = 0.5; // of what hides leaves: they let light through

vec3 placeAt(ivec2 texel, float depth)
{
    return vec3(vec2(texel) * pass.scale + pass.bias, 1.0) * (view.near / max(depth, 1e-7));
}

float depthAt(ivec2 texel)
{
    return texelFetch(gbufferDepth, texel * STRIDE, 0).r;
}

float fastAcos(float x) // within 7e-5 of the angle
{
    float a = abs(x);
    float angle = sqrt(1.0 - a) * (1.5707288 + a * (-0.2121144 + a * (0.0742610 - 0.0187293 * a)));
    return x < 0.0 ? kPi - angle : angle;
}

// Raises the cosine of a horizon to that of a place, as far as that counts.
float raised(float horizon, float lowest, vec3 centre, vec3 towardEye, ivec2 texel)
{
    ivec2 inside = clamp(texel, ivec2(0), pass.size - 1);
    vec3 delta = placeAt(inside, depthAt(inside)) - centre;
    float length2 = max(dot(delta, delta), 1e-8);
    float inverse_ = inversesqrt(length2);
    float weight = texel == inside ? occlusionWeight(length2 * inverse_, pass.radius) : 0.0;
    return max(horizon, mix(lowest, dot(delta, towardEye) * inverse_, weight));
}

float arc(float horizon, float n, float cosine, float sine) // of one side
{
    return 0.25 * (cosine + 2.0 * horizon * sine - cos(2.0 * horizon - n));
}

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy);
    float depth = depthAt(texel);
    result = vec2(1.0, depth * OCCLUSION_DEPTH_SCALE);
    uint bits = surfaceBits(texelFetch(gbufferSurface, texel * STRIDE, 0));
    float reach = min(pass.radius * pass.pixels * depth / view.near, pass.most); // pixels
    // Impostors are flat: they would stand in their own light.
    if (depth <= 0.0 || reach < kNearest || (bits & (SURFACE_IMPOSTOR | SURFACE_UNLIT)) != 0u) return;

    vec3 world = fromOctahedral(texelFetch(gbufferNormal, texel * STRIDE, 0).xy);
    vec3 normal = vec3(dot(world, view.right) * pass.axes.x, dot(world, view.up) * pass.axes.y, dot(world, view.forward));
    vec3 centre = placeAt(texel, depth);
    centre *= 0.9997; // towards the eye, or rounding would let planes hide themselves
    vec3 towardEye = -normalize(centre);

    float turn = float((((texel.x + texel.y) & 3) << 2) + (texel.x & 3)) * (1.0 / 16.0);
    float shift = float((texel.y - texel.x) & 3) * 0.25 + 0.125;
    float seen = 0.0;
    for (int slice = 0; slice < SLICES; ++slice) {
        float angle = (float(slice) + turn) * (kPi / float(SLICES));
        vec2 along = vec2(cos(angle), sin(angle));
        // The normal within the slice, as an angle from the eye's direction.
        vec3 tangent = vec3(along, 0.0) - towardEye * dot(along, towardEye.xy);
        vec3 axis = normalize(cross(tangent, towardEye));
        vec3 projected = normal - axis * dot(normal, axis);
        float share = max(length(projected), 1e-4);
        float cosine = clamp(dot(projected, towardEye) / share, 0.0, 1.0);
        float n = fastAcos(cosine) * (dot(tangent, projected) < 0.0 ? -1.0 : 1.0);
        float sine = sin(n);

        vec2 horizons = vec2(-sine, sine); // cosines: the surface's own plane
        vec2 lowest = horizons;
        for (int step_ = 0; step_ < STEPS; ++step_) {
            float s = (float(step_) + shift) * (1.0 / float(STEPS));
            ivec2 offset = ivec2(round(along * (kNearest + s * s * max(reach - kNearest, 0.0))));
            horizons.x = raised(horizons.x, lowest.x, centre, towardEye, texel + offset);
            horizons.y = raised(horizons.y, lowest.y, centre, towardEye, texel - offset);
        }
        float h0 = -fastAcos(clamp(horizons.y, -1.0, 1.0));
        float h1 = fastAcos(clamp(horizons.x, -1.0, 1.0));
        h0 = n + clamp(h0 - n, -0.5 * kPi, 0.5 * kPi);
        h1 = n + clamp(h1 - n, -0.5 * kPi, 0.5 * kPi);
        seen += share * (arc(h0, n, cosine, sine) + arc(h1, n, cosine, sine));
    }
    seen *= 1.0 / float(SLICES);
    seen = (bits & SURFACE_LEAF) != 0u ? mix(1.0, seen, kLeafShare) : seen;
    result.x = mix(1.0, seen, clamp(reach / kNearest - 1.0, 0.0, 1.0)); // gone where it is not to be seen
}
