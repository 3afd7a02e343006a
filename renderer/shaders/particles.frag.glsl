// A puff that the sun shines on, a flame or a spark: what it adds, and what is left of what is behind.
#include "gbuffer_in.glsl"
#include "shared/particles.h"
#include "view.glsl"

layout(binding = PARTICLE_ATLAS_UNIT) uniform sampler2D atlas;

layout(location = 0) in vec2 atlasPlace;
layout(location = 1) in vec2 corner;
layout(location = 2) flat in vec4 look;
layout(location = 3) flat in vec3 sunlight;
layout(location = 4) flat in vec3 skylight;
layout(location = 5) flat in vec3 tint;
layout(location = 6) flat in vec3 towardSun;
layout(location = 7) flat in vec3 hazeThrough;
layout(location = 8) flat in vec3 hazeLight;
layout(location = 0) out vec4 radiance;

const float kFlame = 0.45; // radiance of the hottest, where the sun's irradiance is 1
const vec3 kSmokeAlbedo = vec3(0.42, 0.42, 0.43);
const vec3 kDustAlbedo = vec3(0.52, 0.44, 0.34);

// From dark red over orange to a yellow white.
vec3 glow(float heat)
{
    return vec3(1.0, 0.36 * heat + 0.22 * heat * heat, 0.05 * heat * heat + 0.18 * heat * heat * heat * heat) * heat * heat;
}

void main()
{
    float before = view.near / max(texelFetch(gbufferDepth, ivec2(gl_FragCoord.xy), 0).r, 1e-9) - view.near / gl_FragCoord.z;
    float soft = clamp(before / look.z, 0.0, 1.0);
    float opacity = look.x * soft;
    uint kind = uint(look.w + 0.5);
    vec4 picture = texture(atlas, atlasPlace);

    vec3 added;
    float covered;
    if (kind == PARTICLE_FIRE) {
        float heat = clamp((picture.r * (0.75 + 0.5 * picture.a) - 0.55 * look.y) * 1.35, 0.0, 1.0);
        added = glow(heat) * (kFlame * opacity) * tint;
        covered = 0.35 * heat * opacity;
    } else if (kind == 4u) {
        float inside = clamp(1.0 - dot(corner, corner), 0.0, 1.0);
        added = vec3(1.0, 0.42, 0.1) * (1.5 * inside * opacity * (1.0 - look.y)) * tint;
        covered = 0.0;
    } else {
        float apart = 0.75 * look.y;
        covered = opacity * smoothstep(apart * picture.a, apart * picture.a + 0.6, picture.r);
        vec3 normal = vec3(picture.gb * 2.0 - 1.0, 0.0);
        normal.z = sqrt(max(1.0 - dot(normal, normal), 0.05));
        float facing = clamp((dot(normalize(normal), towardSun) + 0.6) / 1.6, 0.0, 1.0);
        vec3 albedo = kind == PARTICLE_SMOKE ? kSmokeAlbedo : kDustAlbedo;
        added = albedo * tint * (sunlight * (0.35 + 0.9 * facing) + skylight) * covered;
    }
    radiance = vec4(min(added * hazeThrough + hazeLight * covered, vec3(60000.0)), 1.0 - covered);
}
