// The surface of water: patches whose waves lift them (PATCHES), and around them a plain to the horizon, whose far corners lie
// at infinity.
#include "view.glsl"
#include "water.glsl"

layout(location = 0) out vec2 rest; // m from the eye, where a point would be without waves

#ifdef PATCHES
layout(location = 0) in vec4 patch_; // m from the eye, x and z of the first corner; m of a cell; m, where it is twice that

void main()
{
    ivec2 corner = ivec2(gl_VertexID % (WATER_CELLS + 1), gl_VertexID / (WATER_CELLS + 1));
    vec2 at = patch_.xy + vec2(corner) * patch_.z;
    float away = length(vec3(at.x, water.height, at.y));
    // Corners that the next level does not have move to those that it has, before it begins.
    at -= vec2(corner & 1) * patch_.z * smoothstep(0.75, 1.0, away / patch_.w);
    float spacing = max(water.finest, length(vec3(at.x, water.height, at.y)) / WATER_CELL_RATIO);
    WaterShape shape = WaterShape(vec3(0.0), vec2(0.0), 0.0, 0.0);
    for (int i = 0; i < WATER_WAVES; ++i)
        shape = waterAdd(shape, water.wave[i], at, waterShown(water.wave[i].length, spacing));
    rest = at;
    gl_Position = view.clipFromRelative * vec4(vec3(at.x, water.height, at.y) + shape.shift, 1.0);
}
#else
void main() // a strip of ten
{
    int corner = (gl_VertexID >> 1) & 3;
    vec2 way = vec2(corner == 0 || corner == 3 ? -1.0 : 1.0, corner < 2 ? -1.0 : 1.0);
    // Under the patches' rim a little, where they are plain already.
    vec2 at = mix(water.inner.xy, water.inner.zw, way * 0.495 + 0.5);
    rest = at;
    bool far = (gl_VertexID & 1) != 0;
    gl_Position = view.clipFromRelative * (far ? vec4(way.x, 0.0, way.y, 0.0) : vec4(at.x, water.height, at.y, 1.0));
}
#endif
