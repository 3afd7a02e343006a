// The light that is missing in fog because something stands before the sun. Fog is drawn as if all of it were lit, in one
// way on every machine; this is taken away from it. Wants SHAFTS_VOLUME (froxels) or SHAFTS_SCREEN.
#include "fog.glsl"
#include "shared/atmosphere.h"
#include "shared/shafts.h"
#include "view.glsl"

layout(std140, binding = PICTURE_BINDING) uniform ShaftsBlock { Shafts shafts; };

// Share of the light in fog that comes from the sun itself; the rest is the sky's, and does not end in shadows.
vec3 sunShareOfFog(vec3 direction)
{
    vec3 sun = light.sunIrradiance * miePhase(light.atmosphere.mieG, dot(direction, light.towardSun));
    vec3 sky = skyLight.haze.rgb * light.sunAbove + light.skyFloor * 2.76;
    return sun / max(sun + sky, vec3(1e-9));
}

#ifdef SHAFTS_VOLUME
layout(binding = SHAFTS_UNIT) uniform sampler3D shaftVolume; // what is missing up to each slice's end

vec3 missingInFog(vec2 uv, vec3 relative)
{
    float slices = sqrt(clamp(dot(relative, view.forward) / shafts.range, 0.0, 1.0)) * float(SHAFTS_SLICES);
    return textureLod(shaftVolume, vec3(uv, (slices - 0.5) / float(SHAFTS_SLICES)), 0.0).rgb * min(slices, 1.0);
}
#endif

#ifdef SHAFTS_SCREEN
layout(binding = SHAFTS_UNIT) uniform sampler2D shaftPicture; // as shafts_screen.frag.glsl writes it

vec3 missingInFog(vec2 uv, vec3 relative)
{
    // The small picture's pixels that lie as far away as this one: else what is missing behind a ridge shows around it.
    float own = clamp(dot(relative, view.forward), view.near, 6e4);
    ivec2 last = textureSize(shaftPicture, 0) - 1;
    vec2 at = uv * vec2(last + 1) - 0.5, part = fract(at);
    vec3 sum = vec3(0.0);
    float weights = 0.0, depth = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        vec4 tap = texelFetch(shaftPicture, clamp(ivec2(floor(at)) + corner, ivec2(0), last), 0);
        vec2 near = mix(1.0 - part, part, vec2(corner));
        float weight = (near.x * near.y + 0.01) / (0.02 + abs(log2(tap.a / own)));
        sum += tap.rgb * weight;
        depth += tap.a * weight;
        weights += weight;
    }
    return sum / weights * min(own * weights / depth, 1.0); // what is near has no more fog before it than that
}
#endif
