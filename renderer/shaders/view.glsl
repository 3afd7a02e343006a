#include "shared/bindings.h"
#include "shared/view.h"

layout(std140, binding = VIEW_BINDING) uniform ViewBlock { View view; };

// From the eye to what a pixel shows. `ray` has length 1 along the camera's axis.
vec3 relativeFromDepth(vec3 ray, float depth)
{
    return ray * (view.near / depth);
}

// Noise that differs most between neighbours (Jimenez 2014), for dithering.
float interleavedNoise(vec2 pixel)
{
    return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
}
