// Into how many segments each edge of a patch is cut: half as many when the node has turned into its parent (terrain_choice.h), and
// never shorter on screen than a segment should be, by the sphere that has the edge as its diameter. Only the edge's two ends enter,
// in one order, so that both sides agree to the last bit.
#include "terrain_surface.glsl"

layout(vertices = 1) out;

layout(location = 0) in vec4 patchIn[];
layout(location = 1) in vec4 edgesIn[];
layout(location = 0) patch out vec4 patchOut;

const float kMost = float(TERRAIN_QUADS);

vec3 cornerAt(vec2 corner)
{
    vec2 texel = min(patchIn[0].xy + corner * (patchIn[0].z * kMost), terrain.lastTexel);
    vec2 flat_ = texel * terrain.metres;
    return vec3(flat_.x, heightAt(texel, strideOf(patchIn[0].z)), flat_.y);
}

float shown(vec3 a, vec3 b) // segments that the edge from a to b is long enough for
{
    float diameter = distance(a, b);
    float away = max(distance((a + b) * 0.5, terrain.levelsFrom), diameter * 0.5);
    return max(diameter / (away * terrain.segmentAngle), 2.0);
}

float segments(float morph, float shown_)
{
    // Where levels meet, both sides cut at the coarser one's vertices: in all of its own, in half of the finer one's. Beside a patch
    // of the finest level may lie a grid, which has all of its own.
    bool meets = morph < 0.0 || morph == 1.0 || patchIn[0].z == 1.0;
    float own = kMost * (1.0 - 0.5 * max(morph, 0.0));
    return meets ? own : min(own, shown_);
}

void main()
{
    vec3 low = cornerAt(vec2(0.0)), right = cornerAt(vec2(1.0, 0.0)), below = cornerAt(vec2(0.0, 1.0)), high = cornerAt(vec2(1.0));
    vec4 shown_ = vec4(shown(low, below), shown(low, right), shown(right, high), shown(below, high));
    vec4 edges = edgesIn[0];
    gl_TessLevelOuter[0] = segments(edges.x, shown_.x);
    gl_TessLevelOuter[1] = segments(edges.y, shown_.y);
    gl_TessLevelOuter[2] = segments(edges.z, shown_.z);
    gl_TessLevelOuter[3] = segments(edges.w, shown_.w);
    float inner = min(kMost * (1.0 - 0.5 * patchIn[0].w), max(max(shown_.x, shown_.y), max(shown_.z, shown_.w)));
    gl_TessLevelInner[0] = inner;
    gl_TessLevelInner[1] = inner;
    patchOut = patchIn[0];
}
