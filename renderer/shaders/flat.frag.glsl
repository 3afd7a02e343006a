// One colour: edges, heat of overdraw, levels of detail.
#include "shared/bindings.h"

layout(std140, binding = PASS_BINDING) uniform PassBlock { vec4 colour; };
layout(location = 0) out vec4 outColour;
#ifdef LEVELS
layout(location = 1) flat in float level;
#endif

void main()
{
    outColour = colour;
#ifdef LEVELS
    outColour.rgb = 0.5 + 0.5 * cos(6.2831853 * (level * 0.17 + vec3(0.3, 0.63, 0.97)));
#endif
}
