// One triangle over the whole picture, at the far end of the depth range: depth tests then choose sky or surface.
#include "view.glsl"

layout(location = 0) out vec2 uv;
layout(location = 1) out vec3 ray;

void main()
{
    uv = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
    vec2 ndc = uv * 2.0 - 1.0;
    vec2 still = ndc - view.jitter;
    ray = view.forward + view.right * still.x + view.up * still.y;
    gl_Position = vec4(ndc, 0.0, 1.0);
}
