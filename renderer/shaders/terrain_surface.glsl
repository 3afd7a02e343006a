// Where a point of the ground lies: shared by the vertex stages that draw it.
#include "terrain.glsl"
#include "view.glsl"

layout(binding = HEIGHTS_UNIT) uniform MAP_TEXTURE heights;

// Texels between the samples that a node with vertices so many texels apart is drawn from.
float strideOf(float step)
{
#ifdef WINDOWS
    return min(step, exp2(float(terrain.windows - 1)));
#else
    return 1.0;
#endif
}

// Of a texel that lies on the stride, or is the map's last.
float heightAt(vec2 texel, float stride)
{
#ifdef WINDOWS
    return texelFetch(heights, windowTexel(ivec2(ceil(texel / stride)), int(log2(stride) + 0.5)), 0).r;
#else
    return texelFetch(heights, ivec2(texel), 0).r;
#endif
}

vec4 clipPosition(vec2 texel, float height)
{
    vec2 flat_ = (texel - terrain.eyeTexel) * terrain.metres - terrain.eyeRest;
    return view.clipFromRelative * vec4(flat_.x, height - terrain.eyeHeight, flat_.y, 1.0);
}
