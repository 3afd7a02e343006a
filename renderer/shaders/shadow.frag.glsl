// Cut-out leaves cast shadows with holes.
#include "shared/bindings.h"

layout(binding = BASE_COLOUR_UNIT) uniform sampler2DArray baseColours;
layout(location = 0) in vec2 uvBase;
layout(location = 2) flat in vec3 cutout;

void main()
{
    float alpha = texture(baseColours, vec3(uvBase, max(cutout.x, 0.0))).a * cutout.z;
    if (cutout.x >= 0.0 && alpha < cutout.y) discard;
}
