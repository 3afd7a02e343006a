// How a model lies in the pictures that stand for it where it is small: a square of frames, seen from directions that a
// hemisphere unfolded to an octahedron's square gives. After Brucks, "Octahedral Impostors" (2018).
#ifndef SHARED_IMPOSTOR_H
#define SHARED_IMPOSTOR_H
#include "shared.h"
SHARED_BEGIN

#define IMPOSTOR_FRAMES 8        // along a side
#define IMPOSTOR_FRAME_TEXELS 64 // along a side of a frame
#define IMPOSTOR_MIPS 5          // the last one has 4 texels a frame
#define IMPOSTOR_FILL 0.9375f    // of a frame's side that the sphere takes, so that neighbours stay apart in mips

// From the model's centre to where a frame was seen from; `grid` counts frames from 0. None of them looks straight down.
SHARED_FUNCTION vec3 frameDirection(vec2 grid)
{
    vec2 e = grid * (2.0f / float(IMPOSTOR_FRAMES - 1)) - 1.0f;
    vec2 p = vec2(e.x + e.y, e.x - e.y) * 0.5f;
    return normalize(vec3(p.x, 1.0f - abs(p.x) - abs(p.y), p.y));
}

// The inverse, for directions that do not look down.
SHARED_FUNCTION vec2 frameGrid(vec3 direction)
{
    vec2 p = vec2(direction.x, direction.z) / (abs(direction.x) + abs(direction.y) + abs(direction.z));
    return (vec2(p.x + p.y, p.x - p.y) + 1.0f) * (0.5f * float(IMPOSTOR_FRAMES - 1));
}

SHARED_FUNCTION vec3 frameRight(vec3 direction)
{
    return normalize(vec3(direction.z, 0.0f, -direction.x));
}

SHARED_END
#endif
