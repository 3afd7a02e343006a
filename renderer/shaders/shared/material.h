// A material of the shared table: glTF's metallic-roughness with its textures as layers of bound arrays. Read as
// texels of four words, by the numbers below.
#ifndef SHARED_MATERIAL_H
#define SHARED_MATERIAL_H
#include "shared.h"
SHARED_BEGIN

#define MATERIAL_TEXTURES 5 // by texture unit, BASE_COLOUR_UNIT to EMISSIVE_UNIT

#define MATERIAL_UNLIT 1u
#define MATERIAL_LEAF 2u      // two-sided and cut out: light shines through
#define MATERIAL_KEEP_NORMAL 4u // normals are bent away from the face on purpose: not turned on its back

#define TEXTURE_UV1 1u
#define TEXTURE_WRAP_U_SHIFT 1 // io::Wrap in two bits
#define TEXTURE_WRAP_V_SHIFT 3

struct MaterialTexture {
    vec4 matrix; // columns of the 2 x 2 part of uv' = M uv + offset
    vec2 offset; int layer; uint mode; // layer -1: no texture
};
SHARED_STRUCT_END(MaterialTexture, 32)

struct Material {
    uvec4 quick;                      // what every vertex needs: base colour, unorm16; layers of colour and normals; flags
    uvec4 quick2;                     // roughness, metallic; cutoff, normal scale / MATERIAL_MOST_SCALE; unorm16; unused
    vec4 baseColour;
    vec3 emissive;  float roughness;
    float metallic; float normalScale; float occlusionStrength; float alphaCutoff;
    uint flags; uint unused0; uint unused1; uint unused2;
    MaterialTexture textures[MATERIAL_TEXTURES];
};
SHARED_STRUCT_END(Material, 256)
#define MATERIAL_TEXELS 16
#define MATERIAL_QUICK_TEXEL 0
#define MATERIAL_EMISSIVE_TEXEL 3 // and roughness
#define MATERIAL_FACTORS_TEXEL 4  // metallic, normal scale, occlusion strength, alpha cutoff
#define MATERIAL_TEXTURE_TEXEL 6  // two a texture
#define MATERIAL_MOST_SCALE 4.0f  // of normals, in the quick words

#define HASHED_FROM_MIP 2.0f
#define HASHED_FULLY_MIP 4.5f

// The width of the range around the cutoff from which a texel of this mip has its threshold.
SHARED_FUNCTION float cutoutSpread(float mip, float cutoff)
{
    float hashed = clamp((mip - HASHED_FROM_MIP) / (HASHED_FULLY_MIP - HASHED_FROM_MIP), 0.0f, 1.0f);
    return hashed * min(cutoff, 1.0f - cutoff);
}

SHARED_END
#endif
