// The sun's light behind the air at a place's own height, not the eye's: peaks keep it when the valleys have lost it.
#include "light.glsl"
#include "view.glsl"

vec3 sunAt(vec3 relative)
{
    float place = sunPlaceOf(view.eyeHeight + relative.y);
    int below = min(int(place), SUN_HEIGHTS - 2);
    return mix(light.sunAt[below].rgb, light.sunAt[below + 1].rgb, place - float(below));
}
