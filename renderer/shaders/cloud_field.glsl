// Where clouds stand: noise that drifts with the wind and changes while it does, as each octave goes through a noise of three
// dimensions at its own pace. renderer/clouds.cpp knows its weights.
#include "clouds.glsl"

layout(binding = CLOUD_SHAPE_UNIT) uniform sampler3D cloudShape;   // values lie evenly between 0 and 1
layout(binding = CLOUD_DETAIL_UNIT) uniform sampler3D cloudDetail; // likewise

vec2 cloudPlace(vec2 relative) // m from the eye, to repeats
{
    return clouds.origin + relative * clouds.perMetre;
}

// How far the field is above the edge of clouds, 0 at the edge and 1 in the thick of them.
float cloudField(vec2 place, float lod)
{
    float billows = textureLod(cloudShape, vec3(place, clouds.phase.x), lod).r;
    float broad = textureLod(cloudShape, vec3(place.yx * CLOUD_BROAD + 0.37, clouds.phase.y), lod - 1.7).g; // gaps and gatherings
    float fine = textureLod(cloudDetail, vec3(place * CLOUD_FINE, clouds.phase.z), lod + 1.2).r;
    return (billows * CLOUD_BILLOWS_SHARE + broad * CLOUD_BROAD_SHARE + fine * CLOUD_FINE_SHARE - clouds.edge) / clouds.width;
}

// 0 at a cloud's edge, 1 in the thick of it.
float cloudThickness(float field)
{
    float x = clamp(field, 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x);
}
