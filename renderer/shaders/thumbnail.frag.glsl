// Four pixels of the studio's picture to one of the thumbnail.
#include "shared/bindings.h"
#include "shared/tone_map.h"

layout(binding = IMAGE_UNIT) uniform sampler2D image;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main()
{
    ivec2 first = ivec2(gl_FragCoord.xy) * 2;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i)
        sum += toneMapNeutral(texelFetch(image, first + ivec2(i & 1, i >> 1), 0).rgb);
    colour = vec4(encodeSrgb(clamp(sum * 0.25, vec3(0.0), vec3(1.0))), 1.0);
}
