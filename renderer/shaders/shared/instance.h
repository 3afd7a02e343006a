// One object of the world as the GPU keeps it, read as texels of four words.
#ifndef SHARED_INSTANCE_H
#define SHARED_INSTANCE_H
#include "shared.h"
SHARED_BEGIN

struct Instance {
    vec3 positionHigh; uint objectId; // the position as the sum of two floats, m
    vec3 positionLow;  uint unused;
    vec4 axisX;                       // images of the model's axes, with scale
    vec4 axisY;
    vec4 axisZ;
};
SHARED_STRUCT_END(Instance, 80)
#define INSTANCE_TEXELS 5

#define INSTANCE_SELECTED 1u

SHARED_END
#endif
