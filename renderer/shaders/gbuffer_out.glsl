// What every surface leaves in the GBuffer.
#include "octahedron.glsl"
#include "shared/gbuffer.h"

layout(location = 0) out vec4 outColour;  // base colour as square roots, occlusion
layout(location = 1) out vec2 outNormal;  // octahedral
layout(location = 2) out vec4 outSurface; // roughness, metallic, bits, emission as log2
layout(location = 3) out uint outId;

// Emission shares the base colour's hue: factors of 2^-8 to 2^8 in 255 steps, 0 is none.
float encodeEmission(float factor)
{
    return factor <= 0.0 ? 0.0 : clamp((log2(factor) + 8.0) / 16.0, 1.0 / 255.0, 1.0);
}

// Of what is packed already: square roots of the base colour with occlusion, an octahedral normal.
void writePacked(vec4 rootAndOcclusion, vec2 octahedralNormal, float roughness, float metallic, uint bits, float emission)
{
    outColour = rootAndOcclusion;
    outNormal = octahedralNormal;
    outSurface = vec4(roughness, metallic, float(bits) / 255.0, encodeEmission(emission));
}

// `root`: square roots of the base colour.
void writeSurface(vec3 root, float occlusion, vec3 normal, float roughness, float metallic, uint bits, float emission)
{
    writePacked(vec4(root, occlusion), octahedral(normal), roughness, metallic, bits, emission);
}
