// Point and spot lights as shaders read them. Records and lists are buffer textures: software GL fetches a texel far faster
// than it reads a storage block.
#ifndef SHARED_LAMPS_H
#define SHARED_LAMPS_H
#include "shared.h"
SHARED_BEGIN

// The view is cut into tiles, and along its depth into slices; each of these clusters has a list of the lamps that reach it
// (Olsson et al., "Clustered Deferred and Forward Shading", 2012).
#define LAMP_TILES_X 16
#define LAMP_TILES_Y 9
#define LAMP_SLICES 24
#define LAMP_CLUSTERS (LAMP_TILES_X * LAMP_TILES_Y * LAMP_SLICES)

#define MOST_LAMPS 1024 // in view; of more the brightest
#define LAMP_RADIUS 0.05f // m, of every lamp: nothing is nearer than its glass, and highlights are its image

struct LampGrid {
    float sliceScale; float sliceBias; // slice = log2(view depth) * scale + bias
    float shadowTexel; uint unused;    // 1 / side of the shadow atlas
};
SHARED_STRUCT_END(LampGrid, 16)

// Four texels each.
struct LampRecord {
    vec3 place;     float range;     // from the eye, m; m
    vec3 intensity; float coneScale; // irradiance a metre away; share = cosine * scale + offset
    vec3 direction; float coneOffset;
    float firstFace; float faces;    // of its shadow maps: the first one's texel, and 0, 1 or 6 of them
    float texelAngle; float unused;  // width of their texels 1 m away, m
};
SHARED_STRUCT_END(LampRecord, 64)
#define LAMP_TEXELS 4

// Of a shadow map: four texels, behind all lamps.
struct LampFace {
    mat4 atlasFromLamp; // metres from the lamp to a place in the atlas and depth, before the division
};
SHARED_STRUCT_END(LampFace, 64)

// The inverse square with a smooth end at the range: Karis, "Real Shading in Unreal Engine 4" (2013), as glTF's
// KHR_lights_punctual has it.
SHARED_FUNCTION float lampFalloff(float distance2, float range)
{
    float share = distance2 / (range * range);
    float window = clamp(1.0f - share * share, 0.0f, 1.0f);
    return window * window / max(distance2, LAMP_RADIUS * LAMP_RADIUS);
}

SHARED_FUNCTION float lampCone(float cosine, float scale, float offset)
{
    float share = clamp(cosine * scale + offset, 0.0f, 1.0f);
    return share * share;
}

SHARED_END
#endif
