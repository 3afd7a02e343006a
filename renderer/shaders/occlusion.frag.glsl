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
const float kLeafShare = 0.4; // of what hides leaves: they let light through
const float kCrown = 0.93;    // what the leaves of a tree see in the mean

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

// How much of one side of a slice is hidden up to an elevation e over the surface: sin^2 e, and beyond the normal
// 2 - sin^2 e. This grows with the light that is lost, so that what counts by half takes half of it, whatever the view.
// What is beside the slice by rounding is moved into it along the surface.
float hiddenBy(ivec2 texel, vec3 centre, vec3 tangent, vec3 normal)
{
    ivec2 inside = clamp(texel, ivec2(0), pass.size - 1);
    vec3 delta = placeAt(inside, depthAt(inside)) - centre;
    float weight = texel == inside ? occlusionWeight(length(delta), pass.radius) : 0.0;
    float along = dot(delta, tangent);
    float above = max(dot(delta, normal), 0.0);
    float flat_ = along * along / max(along * along + above * above, 1e-12);
    return above > 0.0 ? weight * (along > 0.0 ? 1.0 - flat_ : 1.0 + flat_) : 0.0;
}

// The angle from the surface to the horizon.
float elevation(float hidden)
{
    float rest = 1.0 - hidden;
    return fastAcos(sign(rest) * sqrt(abs(rest)));
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
    if (depth <= 0.0 || reach < kNearest || (bits & SURFACE_UNLIT) != 0u) return;
    float shown = clamp(reach / kNearest - 1.0, 0.0, 1.0); // gone where it is not to be seen
    if ((bits & SURFACE_IMPOSTOR) != 0u) { // flat, it would stand in its own light
        result.x = (bits & SURFACE_LEAF) != 0u ? mix(1.0, kCrown, shown) : 1.0;
        return;
    }

    vec3 world = fromOctahedral(texelFetch(gbufferNormal, texel * STRIDE, 0).xy);
    vec3 normal = vec3(dot(world, view.right) * pass.axes.x, dot(world, view.up) * pass.axes.y, dot(world, view.forward));
    vec3 centre = placeAt(texel, depth);
    centre *= 0.9997; // towards the eye, or rounding would let planes hide themselves
    vec3 towardEye = -normalize(centre);

    float turn = float((((texel.x + texel.y) & 3) << 2) + (texel.x & 3)) * (1.0 / 16.0);
    float shift = float((texel.y - texel.x) & 3) * 0.25 + 0.125;
    float lost = 0.0;
    for (int slice = 0; slice < SLICES; ++slice) {
        float angle = (float(slice) + turn) * (kPi / float(SLICES));
        vec2 along = vec2(cos(angle), sin(angle));
        // The normal within the slice, as an angle from the eye's direction, and the surface's line in it.
        vec3 aside = vec3(along, 0.0) - towardEye * dot(along, towardEye.xy);
        aside *= inversesqrt(max(dot(aside, aside), 1e-8));
        vec2 projected = vec2(dot(normal, aside), dot(normal, towardEye));
        float share = max(length(projected), 1e-4);
        float sine = projected.x / share;
        float cosine = clamp(projected.y / share, 0.0, 1.0);
        float n = fastAcos(cosine) * (sine < 0.0 ? -1.0 : 1.0);
        vec3 tangent = aside * cosine - towardEye * sine;
        vec3 up = normal / share;

        vec2 hidden = vec2(0.0); // ahead and back
        for (int step_ = 0; step_ < STEPS; ++step_) {
            float s = (float(step_) + shift) * (1.0 / float(STEPS));
            ivec2 offset = ivec2(round(along * (kNearest + s * s * max(reach - kNearest, 0.0))));
            hidden.x = max(hidden.x, hiddenBy(texel + offset, centre, tangent, up));
            hidden.y = max(hidden.y, hiddenBy(texel - offset, centre, -tangent, up));
        }
        float h1 = max(n + 0.5 * kPi - elevation(hidden.x), 0.0); // no further than the eye, who sees past them
        float h0 = min(n - 0.5 * kPi + elevation(hidden.y), 0.0);
        // Counted from what this slice of an open plane sees, which is 1 in the mean over slices only.
        lost += share * (cosine + n * sine - arc(h0, n, cosine, sine) - arc(h1, n, cosine, sine));
    }
    float seen = 1.0 - lost / float(SLICES);
    seen = (bits & SURFACE_LEAF) != 0u ? mix(1.0, seen, kLeafShare) : seen;
    result.x = mix(1.0, seen, shown);
}
