// Light shafts: what shadows take out of the light in fog.
#ifndef SHARED_SHAFTS_H
#define SHARED_SHAFTS_H
#include "shared.h"

#define SHAFTS_WIDTH 160 // froxels: along the picture, across it, and in slices that grow with the square of their distance
#define SHAFTS_HEIGHT 90
#define SHAFTS_SLICES 64
#define SHAFTS_PIXELS 4  // along a side of one on the screen's form

SHARED_BEGIN

struct Shafts {
    vec2 sun;       float strength; float range; // where it stands in the picture, 0..1 within it; share that is taken; m, of froxels
    float clouds;   float unused0;               // share that is taken by those, on the screen's form
    float unused1;  float unused2;
};
SHARED_STRUCT_END(Shafts, 32)

SHARED_END
#endif
