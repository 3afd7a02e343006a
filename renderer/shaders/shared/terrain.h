// The ground: where it lies, how its levels of detail morph, and what covers it.
#ifndef SHARED_TERRAIN_H
#define SHARED_TERRAIN_H
#include "shared.h"
SHARED_BEGIN

#define TERRAIN_QUADS 32 // along a side of a node's grid
#define TERRAIN_LEVELS 16
#define TERRAIN_LAYERS 32

struct TerrainPatch {
    vec2 origin; // texel of the first vertex
    float step;  // texels between vertices
    float level;
};
SHARED_STRUCT_END(TerrainPatch, 16)

// A rule is a product of four ramps clamp(value * slope + offset): where slope angle and altitude rise into their
// range and fall out of it.
struct TerrainLayer {
    vec3 colour;      float repeats;     // linear factor; 1 / m
    vec4 slopeRamps;                     // rise: factor, offset; fall: factor, offset; of degrees
    vec4 altitudeRamps;                  // the same, of m
    vec2 ragged;      float roughness; float colourLayer; // how far noise moves the borders, degrees and m; -1: no texture
    float normalLayer; float unused0; float unused1; float unused2;
};
SHARED_STRUCT_END(TerrainLayer, 80)

struct Terrain {
    vec2 lastTexel;   float metres;     float eyeAbove; // size - 1; m per texel; m, of that eye over the ground
    vec2 eyeInTerrain; vec2 texelSize;  // eye from the origin, m; 1 / size
    float eyeHeight;  int layers; vec2 levelsFrom; // m; from the origin, m: the eye that the levels are chosen for
    vec4 morph[TERRAIN_LEVELS];         // x: distance where it begins, y: 1 / its length
    TerrainLayer layer[TERRAIN_LAYERS];
};
SHARED_STRUCT_END(Terrain, 2864)

SHARED_END
#endif
