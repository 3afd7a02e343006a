// Impostors into the GBuffer, to be lit like what they stand for. Of the three frames around the direction that one is seen
// from, each pixel shows one, by their weights and a grain that moves along, moved by the depth that it shows there.
#include "fade.glsl"
#include "gbuffer_out.glsl"
#include "impostor.glsl"
#include "shared/bindings.h"
#include "shared/instance.h"
#include "texel_noise.glsl"

layout(binding = BASE_COLOUR_UNIT) uniform sampler2DArray colours;
layout(binding = NORMAL_UNIT) uniform sampler2DArray surfaces;
layout(location = 0) in vec4 places01;
layout(location = 1) in vec2 place2;
layout(location = 2) flat in vec4 frames01;
layout(location = 3) flat in vec4 frame2;
layout(location = 4) flat in vec4 shifts01;
layout(location = 5) flat in vec4 shift2; // and the weights of frames 0 and 1
layout(location = 6) flat in vec3 normalX;
layout(location = 7) flat in vec3 normalY;
layout(location = 8) flat in vec3 normalZ;
layout(location = 9) flat in uvec4 ids;   // object; flags, reach towards the sun; roughness of leaves and of the rest (unorm16); a pixel that moves along

const float kEdge = 1.0 / float(IMPOSTOR_FRAME_TEXELS);
const float kCover = 0.44; // from which a texel counts; a little under a half, as one picture alone is as thin as it was taken
const float kSpread = 0.35; // of the covers that pass: 0 keeps those above it, 1 keeps the mean and is all grain

void main()
{
#ifdef FADE
    if (fadedAway(gl_FragCoord.xy)) discard;
#endif
    vec2 pixel = floor(gl_FragCoord.xy) - vec2(ivec2(ids.w << 16, ids.w) >> 16);
    float which = texelNoise(pixel, 0u), grain = texelNoise(pixel.yx, 37u);

    bool first = which < shift2.z;
    bool second = which < shift2.z + shift2.w;
    vec2 frame = first ? frames01.xy : second ? frames01.zw : frame2.xy;
    vec2 shift = first ? shifts01.xy : second ? shifts01.zw : shift2.xy;
    vec2 place = clamp(first ? places01.xy : second ? places01.zw : place2, kEdge, 1.0 - kEdge);
    int mip = min(int(frame2.w) + 2, IMPOSTOR_MIPS - 1); // depth around, also where nothing is
    vec4 there = texelFetch(surfaces, ivec3((frame + place) * float(IMPOSTOR_FRAME_TEXELS >> mip), frame2.z), mip);
    place = clamp(place + shift * storedDepth(there), kEdge, 1.0 - kEdge);
    vec3 at = vec3((frame + place) / float(IMPOSTOR_FRAMES), frame2.z);
    vec4 colour = textureLod(colours, at, frame2.w);
    if (colour.a < kCover + (grain - 0.5) * kSpread) discard;

    ImpostorTexel t = loaded(colour, textureLod(surfaces, at, frame2.w));
    vec3 normal = normalize(normalX * t.normal.x + normalY * t.normal.y + normalZ * t.normal.z);
    uint bits = (ids.y & INSTANCE_SELECTED) != 0u ? SURFACE_SELECTED : 0u;
    bits |= SURFACE_IMPOSTOR | (t.leaf > 0.5 ? SURFACE_LEAF : 0u);
    vec2 roughness = unpackUnorm2x16(ids.z);
    writeSurface(t.root, 1.0, normal, mix(roughness.y, roughness.x, t.leaf), float(ids.y >> 8) / 255.0, bits, 0.0);
    outId = ids.x;
}
