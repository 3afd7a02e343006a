// Seeds as points, each of which becomes a blade.
layout(location = 0) in vec3 inRoot;
layout(location = 1) in uint inSize;
layout(location = 2) in uvec4 inLook; // bend, look, ground, slope: GrassBlade

layout(location = 0) out vec3 root;
layout(location = 1) flat out uint size;
layout(location = 2) flat out uvec4 look;

void main()
{
    root = inRoot;
    size = inSize;
    look = inLook;
}
