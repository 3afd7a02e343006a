// Grass: what grows in a cell of a grid fixed to the world, and what a frame needs to find it. One text for C++ and GLSL.
#ifndef SHARED_GRASS_H
#define SHARED_GRASS_H
#include "shared.h"
#include "wind.h"
SHARED_BEGIN

#define GRASS_CELL 0.125f     // m, along a side; one plant at most grows in each, so 64 a square metre
#define GRASS_TILE 16         // places along a side of a tile
#define GRASS_KINDS 16
#define GRASS_LEVELS 8        // of tiles: each has a quarter of the plants of the one before
#define GRASS_SHAPES 3        // of blades: 15, 7 and 3 vertices
#define GRASS_BUNDLE 32       // blades that are drawn as one instance
#define GRASS_GROUP 64        // plants that are placed together
#define GRASS_PRESSERS 16

struct GrassBlade {
    vec3 root; uint size;          // relative to the eye, m; halves: height and width, m
    uint bend; uint look;          // halves: the angle that it bends by from root to tip, along x and z; bytes: which way it faces, kind, tone, age
    uint ground; uint slope;       // the ground's colour as square roots; its normal, x and z
};
SHARED_STRUCT_END(GrassBlade, 32)

struct GrassKind {
    vec3 rootColour; float groundColour; // linear; share of the ground's own
    vec3 tipColour;  float variety;
    vec2 height;     float width; float density; // m; m; plants a cell
    vec2 steepness;  vec2 altitude;  // cosines of the steepest and the flattest slope; m
    vec2 aboveWater; float bend; float wind; // m; 0..1; 0..1
    float clump;     float clumpSize; uint plant; float perHeight; // 0..1; m; 0: blades, else 1 + the place of its plants; 1 / their model's height
};
SHARED_STRUCT_END(GrassKind, 96)

struct GrassTile { // places are 1 << level cells apart
    ivec2 cell; int level; uint heights; // the first; halves: of the lowest and the highest ground, from the eye, m
};
SHARED_STRUCT_END(GrassTile, 16)

struct GrassFound { // a plant, before anyone knows how it looks
    uint cell; // two 16 bits, from the eye's
    uint what; // kind 4 bits, level 3, whether it is in the next level too 1, height's factor 8
};
SHARED_STRUCT_END(GrassFound, 8)

struct GrassFrame {
    ivec2 eyeCell;   vec2 eyeRest;     // the cell that the eye is over, and m from its corner
    vec2 mapFrom;    uint plantRoom; int looksAhead; // world x and z of the map's texel (0, 0), m; of a kind's; 1: what is out of view is left out
    vec2 mapSize;    float mapTexel;   float eyeHeight; // texels; m; m
    float full;      float distance;   float water; int pressers; // m: to there all grow; to there some do; of the water's level
    uint most;       uint room;        float density; float shapeAngle; // plants; of a shape; share; radians of height from which 15 vertices show
    float tintScale; uint foundRoom; float kept; uint unused0; // GroundTint::scale(); plants; Grass::kept()
    Wind wind;
    vec4 presser[GRASS_PRESSERS];      // relative to the eye, m; radius, m
    vec4 pressed[GRASS_PRESSERS / 4];  // strengths
    GrassKind kind[GRASS_KINDS];
};
SHARED_STRUCT_END(GrassFrame, 2000)

struct GrassCounts {
    uint groups, groupsY, groupsZ; // of GRASS_GROUP threads for what was found: the arguments of an indirect dispatch
    uint found;
    uint taken;               // plants in view, also those that are too many
    uint drawn;
    uint shape[GRASS_SHAPES]; // blades
    uint plants[GRASS_KINDS]; // of models
};
SHARED_STRUCT_END(GrassCounts, 100)

struct GrassPart { // of a model that grows, one draw
    uint firstIndex, indexCount, plants, unused0; // the place of its plants
};
SHARED_STRUCT_END(GrassPart, 16)

// Jarzynski and Olano, "Hash Functions for GPU Rendering" (2020): pcg3d.
SHARED_FUNCTION uvec3 grassHash(uvec3 v)
{
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.x ^= v.x >> 16u;
    v.y ^= v.y >> 16u;
    v.z ^= v.z >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

// The one cell that stands for a block of them, 1 << level along a side: one of those that stand for its quarters.
SHARED_FUNCTION ivec2 grassCell(ivec2 block, int level)
{
    for (int l = level; l > 0; --l) {
        uint pick = grassHash(uvec3(uint(block.x), uint(block.y), uint(l))).x >> 30u;
        block = block * 2 + ivec2(int(pick & 1u), int(pick >> 1u));
    }
    return block;
}

// Along a blade of a shape.
SHARED_FUNCTION int grassSegments(int shape)
{
    return shape == 0 ? 7 : shape == 1 ? 3 : 1;
}

// Of a bundle of that shape: triangles of its strips. They lie one shape after the other.
SHARED_FUNCTION int grassIndices(int shape)
{
    return (grassSegments(shape) * 2 - 1) * 3 * GRASS_BUNDLE;
}

SHARED_FUNCTION int grassFirstIndex(int shape)
{
    int first = 0;
    for (int s = 0; s < shape; ++s)
        first += grassIndices(s);
    return first;
}

// From where on a level's places grow, m.
SHARED_FUNCTION float grassFrom(int level, float full)
{
    return level == 0 ? 0.0f : full * float(1 << (level - 1));
}

SHARED_END
#endif
