// The GBuffer, read back.
#include "octahedron.glsl"
#include "shared/bindings.h"
#include "shared/gbuffer.h"

layout(binding = GBUFFER_COLOUR_UNIT) uniform sampler2D gbufferColour;
layout(binding = GBUFFER_NORMAL_UNIT) uniform sampler2D gbufferNormal;
layout(binding = GBUFFER_SURFACE_UNIT) uniform sampler2D gbufferSurface;
layout(binding = GBUFFER_DEPTH_UNIT) uniform sampler2D gbufferDepth;

vec3 decodeColour(vec3 stored)
{
    return stored * stored;
}

float decodeEmission(float stored)
{
    return stored <= 0.0 ? 0.0 : exp2(stored * 16.0 - 8.0);
}

uint surfaceBits(vec4 surface)
{
    return uint(surface.z * 255.0 + 0.5);
}
