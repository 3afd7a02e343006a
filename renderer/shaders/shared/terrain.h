// The ground: where it lies, the patches it is drawn as, and what covers it.
#ifndef SHARED_TERRAIN_H
#define SHARED_TERRAIN_H
#include "shared.h"
SHARED_BEGIN

#define TERRAIN_QUADS 16 // along a side of a node's grid; even, and no more than what every tessellator makes of an edge
#define TERRAIN_LEVELS 16
#define TERRAIN_LAYERS 32

struct TerrainPatch {
    vec2 origin; float step; float morph; // texel of the first vertex; texels between vertices; as ChosenNode
    vec4 edges;
};
SHARED_STRUCT_END(TerrainPatch, 32)

// A rule is a product of six ramps clamp(value * slope + offset): where slope angle, altitude and flow rise into
// their range and fall out of it.
struct TerrainLayer {
    vec3 colour;      float repeats;     // linear factor; 1 / m
    vec4 slopeRamps;                     // rise: factor, offset; fall: factor, offset; of degrees
    vec4 altitudeRamps;                  // the same, of m
    vec4 flowRamps;                      // the same, of io::GroundFlow's values
    vec2 ragged;      float roughness; float colourLayer; // how far noise moves the borders, degrees and m; -1: no texture
    float normalLayer; float unused0; float unused1; float unused2;
};
SHARED_STRUCT_END(TerrainLayer, 96)

struct Terrain {
    vec2 lastTexel;    float metres;     int layers;   // size - 1; m per texel
    vec2 eyeTexel;     vec2 eyeRest;                   // the eye: a whole texel, and m from there on
    vec2 texelSize;    vec2 unused0;                   // 1 / size
    vec3 levelsFrom;   float eyeHeight;                // m, from the origin: the eye that the levels are chosen for; m
    float segmentAngle; int windows; int windowSide; float windowReach; // rad that a tessellated edge's segment takes at least; levels
                                                       // held as windows around the eye, 0: all of the map is there; samples; texels
    vec2 windowsFrom;  vec2 flowScale;                 // texel; cells of the flow a texel, over its size
    TerrainLayer layer[TERRAIN_LAYERS];
};
SHARED_STRUCT_END(Terrain, 3168)

SHARED_END
#endif
