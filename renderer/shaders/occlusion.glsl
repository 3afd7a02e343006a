// Ambient occlusion as lighting reads it, at the picture's resolution or at half of it.
#include "shared/bindings.h"
#include "shared/occlusion.h"

layout(binding = AMBIENT_OCCLUSION_UNIT) uniform sampler2D ambientOcclusion; // share of the sky, depth

float occlusionAt(ivec2 pixel, float depth)
{
#ifdef HALF_OCCLUSION
    // The four around, by nearness on the screen and in depth.
    ivec2 low = pixel >> 1;
    vec2 between = vec2(low + 1) / vec2(textureSize(ambientOcclusion, 0));
    vec4 seen = textureGather(ambientOcclusion, between, 0);
    vec4 depths = textureGather(ambientOcclusion, between, 1);
    vec2 f = vec2(pixel & 1) * 0.5;
    vec4 w = vec4((1.0 - f.x) * f.y, f.x * f.y, f.x * (1.0 - f.y), (1.0 - f.x) * (1.0 - f.y));
    w /= 0.01 + abs(depths * (1.0 / (OCCLUSION_DEPTH_SCALE * depth)) - 1.0);
    return dot(seen, w) / (w.x + w.y + w.z + w.w);
#else
    return texelFetch(ambientOcclusion, pixel, 0).r;
#endif
}
