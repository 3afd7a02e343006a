// A line as a quad on the screen, two pixels wide with soft sides.
#include "view.glsl"

layout(location = 0) in vec3 inFrom; // relative
layout(location = 1) in vec3 inTo;
layout(location = 2) in vec4 inColour;
layout(location = 3) in float inOnTop;

layout(location = 0) out vec4 colour;
layout(location = 1) noperspective out float across; // pixels from the line's middle
layout(location = 2) noperspective out float depth;
layout(location = 3) flat out float onTop;

void main()
{
    const float kReach = 2.0; // pixels: half the line and its soft side
    vec4 from = view.clipFromRelative * vec4(inFrom, 1.0);
    vec4 to = view.clipFromRelative * vec4(inTo, 1.0);
    vec2 a = from.xy / from.w;
    vec2 b = to.xy / to.w;
    vec2 along = (b - a) * vec2(view.size);
    along = dot(along, along) > 1e-6 ? normalize(along) : vec2(1.0, 0.0);
    float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
    bool end = gl_VertexID >= 2;
    vec2 offset = (vec2(-along.y, along.x) * side + along * (end ? 0.5 : -0.5)) * kReach * 2.0 * view.texel;
    gl_Position = vec4((end ? b : a) + offset, 0.0, 1.0);
    depth = end ? to.z / to.w : from.z / from.w;
    across = side * kReach;
    colour = inColour;
    onTop = inOnTop;
}
