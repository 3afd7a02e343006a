// The sky as a rough surface mirrors it: an octahedron of directions, zenith in the middle, at five roughnesses, one under the other.
// Edges of each lie at the middle of texels, so that a bilinear look never leaves its level.
#ifndef SHARED_SKY_MIRROR_H
#define SHARED_SKY_MIRROR_H
#include "shared.h"
SHARED_BEGIN

#define SKY_MIRROR_SIZE 48   // texels along a side of each level
#define SKY_MIRROR_LEVELS 5
#define SKY_MIRROR_ROUGHEST 0.7f // of the last level; rougher ones are the harmonics'

SHARED_FUNCTION float skyMirrorRoughness(float level)
{
    return SKY_MIRROR_ROUGHEST * level / float(SKY_MIRROR_LEVELS - 1);
}

SHARED_FUNCTION vec2 skyMirrorUv(vec2 octahedral_, float level)
{
    vec2 inside = (octahedral_ * 0.5f + 0.5f) * float(SKY_MIRROR_SIZE - 1) + 0.5f;
    return vec2(inside.x, inside.y + level * float(SKY_MIRROR_SIZE)) / vec2(SKY_MIRROR_SIZE, SKY_MIRROR_SIZE * SKY_MIRROR_LEVELS);
}

SHARED_END
#endif
