// Where a point of the ground lies: shared by the vertex stages that draw it.
#include "terrain.glsl"
#include "view.glsl"

layout(binding = HEIGHTS_UNIT) uniform sampler2D heights;

float heightAt(vec2 texel)
{
    return texelFetch(heights, ivec2(texel), 0).r;
}

vec4 clipPosition(vec2 texel, float height)
{
    vec2 flat_ = texel * terrain.metres - terrain.eyeInTerrain;
    return view.clipFromRelative * vec4(flat_.x, height - terrain.eyeHeight, flat_.y, 1.0);
}
