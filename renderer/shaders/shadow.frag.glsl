// Cut-out leaves cast shadows with holes. One unfiltered texel of the fitting mip decides: the map's own filter
// smooths the rest, and shadow maps have many texels to fill.
#include "shared/bindings.h"

layout(binding = BASE_COLOUR_UNIT) uniform sampler2DArray baseColours;
layout(location = 0) in vec2 uvBase;
layout(location = 2) flat in vec3 cutout; // layer, cutoff, alpha factor

const int kSmallest = 3; // log2 of texels across: of fewer all would pass, or none

void main()
{
    vec2 size = vec2(textureSize(baseColours, 0).xy);
    vec2 dx = dFdx(uvBase) * size;
    vec2 dy = dFdy(uvBase) * size;
    float texels = max(max(dot(dx, dx), dot(dy, dy)), 1.0); // squared
    int last = max(textureQueryLevels(baseColours) - 1 - kSmallest, 0);
    int mip = min(((floatBitsToInt(texels) >> 23) - 127) >> 1, last); // half of log2, rounded down
    vec2 place = fract(uvBase) * size * intBitsToFloat((127 - mip) << 23);
    float alpha = texelFetch(baseColours, ivec3(place, max(cutout.x, 0.0)), mip).a * cutout.z;
    if (cutout.x >= 0.0 && alpha < cutout.y) discard;
}
