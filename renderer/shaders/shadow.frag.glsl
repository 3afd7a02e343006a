// Cut-out leaves cast shadows with holes. One unfiltered texel of the fitting mip decides: the map's own filter
// smooths the rest, and shadow maps have many texels to fill.
#include "shared/bindings.h"

layout(binding = BASE_COLOUR_UNIT) uniform sampler2DArray baseColours;
layout(location = 0) in vec2 uvBase;
layout(location = 2) flat in vec3 cutout; // layer, cutoff, alpha factor

void main()
{
    vec2 size = vec2(textureSize(baseColours, 0).xy);
    vec2 dx = dFdx(uvBase) * size;
    vec2 dy = dFdy(uvBase) * size;
    float mip = floor(0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), 1.0)));
    mip = min(mip, float(textureQueryLevels(baseColours) - 1));
    vec2 place = fract(uvBase) * size * exp2(-mip);
    float alpha = texelFetch(baseColours, ivec3(place, max(cutout.x, 0.0)), int(mip)).a * cutout.z;
    if (cutout.x >= 0.0 && alpha < cutout.y) discard;
}
