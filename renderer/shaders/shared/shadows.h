// The shadow maps of one frame, as shaders look them up.
#ifndef SHARED_SHADOWS_H
#define SHARED_SHADOWS_H
#include "shared.h"

#define MAX_CASCADES 6
#define CONTACT_CASCADES 2          // the nearest ones, of which shadows may soften with distance
#define MOST_PENUMBRA 8.0f          // texels to either side; as far as blockers are looked for
#define MOST_TAPS 8                 // along a side of the filter; beyond, they stand farther apart

SHARED_BEGIN

struct ShadowCascade {
    mat4 textureFromRelative;              // to a texture that repeats on x and y, and depth: 0 towards the light
    float texel;       float depthRange;   // m; m from depth 0 to 1
    float blendFrom;   float blendScale;   // distance at which the next one begins to show, m; per m, 0: never
    float penumbra;    float contactReach; // texels to either side for each m to what blocks the light; m that count of it
    vec2 low;                              // where the window begins in the texture, 0..1
};
SHARED_STRUCT_END(ShadowCascade, 96)

struct Shadows {
    ShadowCascade cascade[MAX_CASCADES];
    vec4 ends;                            // distance at which each ends, m; without end where there is no next one
    float fifthEnd;    int cascades;
    float resolution;  float reach;       // texels along a side; half the filter's width, texels
    float bias;        float depthBias;   // texels along the normal of a slope, and towards the light
    float fadeFrom;    float fadeScale;   // distance at which shadows begin to end, m; per m
    vec3 towardLight;  float climb;       // unit, of which Light has the exact one; of a ray to it, m up for each m along the ground
};
SHARED_STRUCT_END(Shadows, 640)

// sRGB, of tinted cascades and of their boxes.
SHARED_FUNCTION vec3 cascadeTint(int cascade)
{
    switch (cascade) {
    case 0: return vec3(1.0f, 0.35f, 0.3f);
    case 1: return vec3(0.4f, 1.0f, 0.35f);
    case 2: return vec3(0.35f, 0.5f, 1.0f);
    case 3: return vec3(1.0f, 0.9f, 0.3f);
    case 4: return vec3(0.9f, 0.4f, 1.0f);
    default: return vec3(0.3f, 0.95f, 0.95f);
    }
}

SHARED_END
#endif
