// Ambient occlusion: what the search for horizons and its filters ask.
#ifndef SHARED_OCCLUSION_H
#define SHARED_OCCLUSION_H
#include "shared.h"
SHARED_BEGIN

// What is nearer than this share of the radius hides all that it covers; from there to the radius ever less of it.
#define OCCLUSION_FULL 0.4f

// Few places are looked at, so some of what hides is missed: the power that makes up for it against rays (tests/gl/test_occlusion.cpp).
#define OCCLUSION_POWER 1.4f

#define OCCLUSION_DEPTH_SCALE 1000.0f // of reversed depth beside the occlusion: half floats hold it to the horizon

struct OcclusionPass {
    float radius;   float strength;  // m; power on what is seen
    float pixels;   float most;      // of the occlusion's own picture that 1 m spans 1 m away; that the radius may span
    vec2 scale;     vec2 bias;       // view x and y at depth 1 of a pixel of that picture
    vec2 axes;      vec2 unused;     // 1 / length of view.right and of view.up
    ivec2 step;     ivec2 size;      // to the next pixel of a blur; of that picture
};
SHARED_STRUCT_END(OcclusionPass, 64)

// How much of its direction something so far away hides.
SHARED_FUNCTION float occlusionWeight(float distance_, float radius)
{
    return clamp((radius - distance_) / (radius * (1.0f - OCCLUSION_FULL)), 0.0f, 1.0f);
}

SHARED_END
#endif
