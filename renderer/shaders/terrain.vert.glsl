// The ground as instanced grids. An odd vertex moves to the even one before it while its node turns into its parent: CDLOD,
// Strugar, "Continuous Distance-Dependent Level of Detail" (2010), but by nodes and edges (terrain_choice.h), not by distance.
#include "terrain_surface.glsl"

layout(location = 0) in vec2 inGrid; // 0 .. TERRAIN_QUADS
layout(location = 1) in vec4 inPatch; // TerrainPatch: origin, step, morph
layout(location = 2) in vec4 inEdges;

invariant gl_Position;

layout(location = 0) out vec3 place; // texel x, z; height, m
#ifdef LEVELS
layout(location = 1) flat out float level;
#endif

void main()
{
    // Corners are even, so no vertex that moves lies on two edges.
    float k = inPatch.w;
    k = inGrid.x == 0.0 ? inEdges.x : k;
    k = inGrid.y == 0.0 ? inEdges.y : k;
    k = inGrid.x == float(TERRAIN_QUADS) ? inEdges.z : k;
    k = inGrid.y == float(TERRAIN_QUADS) ? inEdges.w : k;
    k = max(k, 0.0);

    vec2 odd = fract(inGrid * 0.5) * 2.0;
    vec2 own = min(inPatch.xy + inGrid * inPatch.z, terrain.lastTexel);
    vec2 coarse = min(inPatch.xy + (inGrid - odd) * inPatch.z, terrain.lastTexel);
    vec2 texel = mix(own, coarse, k);
    float stride = strideOf(inPatch.z);
    float height = mix(heightAt(own, stride), heightAt(coarse, stride), k);

    gl_Position = clipPosition(texel, height);
    place = vec3(texel, height);
#ifdef LEVELS
    level = log2(inPatch.z);
#endif
}
