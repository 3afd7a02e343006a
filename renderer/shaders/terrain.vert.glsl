// The ground as instanced grids: CDLOD, Strugar, "Continuous Distance-Dependent Level of Detail" (2010). The distance
// that morphs is measured along the ground, so that two nodes that share an edge agree on it whatever their heights.
#include "terrain.glsl"
#include "view.glsl"

layout(binding = HEIGHTS_UNIT) uniform sampler2D heights;

layout(location = 0) in vec2 inGrid; // 0 .. TERRAIN_QUADS
layout(location = 1) in vec4 inPatch; // TerrainPatch

invariant gl_Position;

layout(location = 0) out vec3 place; // texel x, z; height, m
#ifdef LEVELS
layout(location = 1) flat out float level;
#endif

float heightAt(vec2 texel)
{
    return texelFetch(heights, ivec2(texel), 0).r;
}

void main()
{
    vec2 own = min(inPatch.xy + inGrid * inPatch.z, terrain.lastTexel);
    vec2 fromEye = own * terrain.metres - terrain.levelsFrom;
    float distance_ = sqrt(dot(fromEye, fromEye) + terrain.eyeAbove * terrain.eyeAbove);
    vec4 morph = terrain.morph[int(inPatch.w)];
    float k = clamp((distance_ - morph.x) * morph.y, 0.0, 1.0);

    vec2 odd = fract(inGrid * 0.5) * 2.0;
    vec2 coarse = min(inPatch.xy + (inGrid - odd) * inPatch.z, terrain.lastTexel);
    vec2 texel = mix(own, coarse, k);
    float height = mix(heightAt(own), heightAt(coarse), k);

    vec2 flat_ = texel * terrain.metres - terrain.eyeInTerrain;
    vec3 relative = vec3(flat_.x, height - terrain.eyeHeight, flat_.y);
    gl_Position = view.clipFromRelative * vec4(relative, 1.0);
    place = vec3(texel, height);
#ifdef LEVELS
    level = inPatch.w;
#endif
}
