// The ground as tessellated patches, one vertex each: handed on as it is.
layout(location = 1) in vec4 inPatch;
layout(location = 2) in vec4 inEdges;

layout(location = 0) out vec4 patchOut;
layout(location = 1) out vec4 edgesOut;

void main()
{
    patchOut = inPatch;
    edgesOut = inEdges;
}
