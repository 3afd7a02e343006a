// One camera for one frame. Relative means: metres from the eye, in the world's axes.
#ifndef SHARED_VIEW_H
#define SHARED_VIEW_H
#include "shared.h"
SHARED_BEGIN

struct View {
    mat4 clipFromRelative; // of the camera, or of a shadow cascade
    vec3 eyeHigh;  float time;      // the eye as the sum of two floats, m; s, as of Wind
    vec3 eyeLow;   float near;      // m
    vec3 forward;  float exposure;  // unit; factor, 2^EV
    vec3 right;    float pixelAngle; // half the picture's width and height at distance 1; radians that a pixel
    vec3 up;       float eyeHeight;  // covers at the centre; m, as one float
    ivec2 size;    vec2 texel;      // pixels, 1 / size
    vec2 jitter;   vec2 unused;     // by which clipFromRelative moves the picture, of its half size
};
SHARED_STRUCT_END(View, 176)

SHARED_END
#endif
