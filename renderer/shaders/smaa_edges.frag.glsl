// Where brightness jumps, after Jimenez et al., "SMAA: Enhanced Subpixel Morphological Antialiasing" (2012), section 4.1.
// Red: between this pixel and the one to the left; green: and the one below.
#include "shared/bindings.h"

layout(binding = HISTORY_UNIT) uniform sampler2D image; // brightness in alpha
layout(location = 0) out vec2 edges;

const float kThreshold = 0.07;     // of brightness, 0..1
const float kAdaptation = 2.0;     // a jump half as high as the one beside it is not seen

float brightness(ivec2 pixel)
{
    return texelFetch(image, clamp(pixel, ivec2(0), textureSize(image, 0) - 1), 0).a;
}

void main()
{
    ivec2 p = ivec2(gl_FragCoord.xy);
    float own = brightness(p);
    float left = brightness(p - ivec2(1, 0)), below = brightness(p - ivec2(0, 1));
    vec2 jump = abs(own - vec2(left, below));
    edges = step(kThreshold, jump);
    if (edges.x + edges.y == 0.0) discard;
    float right = abs(own - brightness(p + ivec2(1, 0))), above = abs(own - brightness(p + ivec2(0, 1)));
    float further = abs(left - brightness(p - ivec2(2, 0))), deeper = abs(below - brightness(p - ivec2(0, 2)));
    float highest = max(max(max(jump.x, jump.y), max(right, above)), max(further, deeper));
    edges *= step(highest, kAdaptation * jump);
    if (edges.x + edges.y == 0.0) discard;
}
