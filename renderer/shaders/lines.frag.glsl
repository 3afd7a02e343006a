// Compares with the picture's depth itself: the picture it draws on carries none.
#include "shared/bindings.h"

layout(binding = GBUFFER_DEPTH_UNIT) uniform sampler2D gbufferDepth;
layout(location = 0) in vec4 colour;
layout(location = 1) noperspective in float across;
layout(location = 2) noperspective in float depth;
layout(location = 3) flat in float onTop;
layout(location = 0) out vec4 outColour;

void main()
{
    float stored = texelFetch(gbufferDepth, ivec2(gl_FragCoord.xy), 0).r;
    // A thousandth nearer, so that a line on a surface shows.
    if (onTop < 0.5 && depth * 1.002 < stored) discard;
    outColour = vec4(colour.rgb, colour.a * clamp(1.6 - abs(across), 0.0, 1.0));
}
