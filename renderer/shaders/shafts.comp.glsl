// Fog in froxels (Wronski, "Volumetric fog", SIGGRAPH 2014): each thread follows one column of them from the eye and adds up
// the light that is missing in it. Over a slice, light of S a metre through an extinction e comes to S (1 - exp(-e d)) / e;
// for fog that is its colour times what the slice takes of light from behind it, which is known in closed form.
#include "lighting.glsl"
#include "shafts.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f, binding = 0) writeonly uniform image3D volume;

const int kLooks = 4; // towards the sun, in each froxel

float shadowAt(vec3 relative)
{
    float sun = sunVisibility(relative, light.towardSun);
#ifdef CLOUD_SHADOWS
    sun *= cloudShadow(relative);
#endif
    return 1.0 - sun;
}

float sliceEnd(int slice)
{
    float x = float(slice + 1) / float(SHAFTS_SLICES);
    return shafts.range * x * x;
}

void main()
{
    ivec2 column = ivec2(gl_GlobalInvocationID.xy);
    if (column.x >= SHAFTS_WIDTH || column.y >= SHAFTS_HEIGHT) return;
    vec2 ndc = (vec2(column) + 0.5) / vec2(SHAFTS_WIDTH, SHAFTS_HEIGHT) * 2.0 - 1.0;
    vec3 ray = view.forward + view.right * ndc.x + view.up * ndc.y;
    vec3 direction = normalize(ray);
    vec3 share = sunShareOfFog(direction) * shafts.strength;
    float noise = interleavedNoise(vec2(column));
    vec3 missing = vec3(0.0);
    float before = 1.0, from = 0.0;
    for (int slice = 0; slice < SHAFTS_SLICES; ++slice) {
        float to = sliceEnd(slice);
        float through = fogTransmittance(ray * to);
        float dark = 0.0;
        for (int look = 0; look < kLooks; ++look)
            dark += shadowAt(ray * mix(from, to, (float(look) + noise) / float(kLooks)));
        float middle = 0.5 * (from + to) * length(ray);
        missing += fogColour(direction, middle) * share * (dark / float(kLooks) * (before - through));
        imageStore(volume, ivec3(column, slice), vec4(missing, through));
        before = through;
        from = to;
    }
}
