// How much of the sun the clouds let through, around the eye: what surfaces look up instead of the field itself.
#include "clouds.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out float through;

void main()
{
    vec2 place = light.cloudMap.xy + (uv - 0.5) * CLOUD_MAP_METRES;
    through = 1.0 - 0.75 * cloudCover(cloudField(place, 2.0)) * light.cloudsOn;
}
