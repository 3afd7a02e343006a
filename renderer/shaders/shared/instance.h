// One object of the world as the GPU keeps it. Views draw from copies of those that they see, as attributes of vertices.
#ifndef SHARED_INSTANCE_H
#define SHARED_INSTANCE_H
#include "shared.h"
SHARED_BEGIN

struct Instance {
    vec3 positionHigh; uint objectId; // the position as the sum of two floats, m
    vec3 positionLow;  uint drawn;    // flags, and in a view's copy what shared/drawn.h says
    vec4 axisX;                       // images of the model's axes, with scale
    vec4 axisY;
    vec4 axisZ;
};
SHARED_STRUCT_END(Instance, 80)
#define INSTANCE_WORDS 5u // of sixteen bytes

#define INSTANCE_SELECTED 1u

SHARED_END
#endif
