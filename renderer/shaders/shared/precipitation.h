// Rain and snow of one frame: drops and flakes in two boxes around the eye that what leaves on one side enters on the other.
#ifndef SHARED_PRECIPITATION_H
#define SHARED_PRECIPITATION_H
#include "shared.h"
SHARED_BEGIN

#define PRECIPITATION_NEAR 7.0f  // m, sides of the boxes
#define PRECIPITATION_WIDE 24.0f

struct Precipitation {
    vec3 fall;      float exposure; // m/s, of the mean, with the wind; s that a streak lasts
    vec4 movedNear;                 // what both boxes have moved relative to the eye, m within them; time of flutter, s
    vec4 movedWide;
    int drops;      int snow;       // those of each box; not 0: flakes
    float size;     float opacity;  // m across; of one
};
SHARED_STRUCT_END(Precipitation, 64)

SHARED_END
#endif
