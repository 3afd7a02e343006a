// The ground in shadow maps, where it has holes.
#include "shared/bindings.h"

#include "hole.glsl"

layout(binding = COVER_UNIT) uniform sampler2D coverMap;

layout(location = 0) in vec3 place;

void main()
{
    if (inHole(coverMap, place.xy)) discard;
}
