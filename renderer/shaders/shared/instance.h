// One object of the world as the GPU keeps it. Views draw from copies of those that they see, as attributes of vertices.
#ifndef SHARED_INSTANCE_H
#define SHARED_INSTANCE_H
#include "shared.h"
SHARED_BEGIN

struct Instance {
    vec3 positionHigh; uint objectId; // the position as the sum of two floats, m
    vec3 positionLow;  uint drawn;    // flags, and in a view's copy what shared/drawn.h says
    vec4 axisX;                       // images of the model's axes, with scale. The fourth words are of what sways: how
    vec4 axisY;                       // freely, 0..1; the plant's height, m; 1 / the model's height. In a view's copy the
    vec4 axisZ;                       // first two say how far its top gives way, m, x and z.
};
SHARED_STRUCT_END(Instance, 80)
#define INSTANCE_WORDS 5u // of sixteen bytes

#define INSTANCE_SELECTED 1u

SHARED_END
#endif
