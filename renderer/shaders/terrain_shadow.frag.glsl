// The ground in shadow maps, where it has holes.
#include "terrain.glsl"
#include "hole.glsl"

layout(binding = COVER_UNIT) uniform MAP_TEXTURE coverMap;

layout(location = 0) in vec3 place;

void main()
{
    if (inHole(coverMap, place.xy)) discard;
}
