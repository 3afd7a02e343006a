// What water mirrors: the sky, and what of the picture lies in that direction. With MARCH a ray is followed through the picture's
// depths; without it the picture is taken to be far away, which is right for mountains and clouds and near for a shore.
#include "sky_tables.glsl"
#include "view.glsl"

layout(binding = BEHIND_UNIT) uniform sampler2D behind;
layout(binding = BEHIND_DEPTH_UNIT) uniform sampler2D behindDepth;

const int kSteps = 24;
const int kHalvings = 4;
const float kGrowth = 1.28; // of a step over the one before

// 1 inside the picture, 0 at its rim.
float inPicture(vec2 uv)
{
    vec2 rim = smoothstep(vec2(0.0), vec2(0.08), uv) * smoothstep(vec2(0.0), vec2(0.08), 1.0 - uv);
    return rim.x * rim.y;
}

vec2 onScreen(vec4 clip)
{
    return clip.xy / clip.w * 0.5 + 0.5;
}

// The sky may shine through gaps; its sun does not count, as the glitter has it already.
vec3 pictureAt(vec2 uv, vec3 sky)
{
    return min(textureLod(behind, uv, 0.0).rgb, sky * 3.0 + light.sunIrradiance * 0.35);
}

// What is a surface of the picture has the haze before it already; the sky has not what stands between the water and the eye.
struct Mirrored {
    vec3 sky;
    vec4 surface; // its light, and the share of it before the sky
};

// The picture at infinity: only what is farther away than the water itself.
Mirrored farAway(vec3 from, vec3 direction, vec3 sky)
{
    Mirrored mirrored = Mirrored(sky, vec4(0.0));
    vec4 clip = view.clipFromRelative * vec4(direction, 0.0);
    if (clip.w <= 0.0) return mirrored;
    vec2 uv = onScreen(clip);
    float visible = inPicture(uv);
    if (visible <= 0.0) return mirrored;
    float depth = textureLod(behindDepth, uv, 0.0).r;
    vec3 picture = pictureAt(uv, sky);
    if (depth <= 0.0) mirrored.sky = mix(sky, picture, visible);
    else mirrored.surface = vec4(picture, visible * smoothstep(1.05, 1.3, view.near / depth / dot(from, view.forward)));
    return mirrored;
}

#ifdef MARCH
vec4 marched(vec3 from, vec3 direction, vec3 sky)
{
    float reached = 0.0;
    float step_ = 0.12 + 0.004 * length(from);
    for (int i = 0; i < kSteps; ++i) {
        float next = reached + step_;
        vec4 clip = view.clipFromRelative * vec4(from + direction * next, 1.0);
        if (clip.w <= view.near) break;
        vec2 uv = onScreen(clip);
        if (any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0)))) break;
        float behindBy = clip.w - view.near / max(textureLod(behindDepth, uv, 0.0).r, 1e-9);
        if (behindBy > 0.0 && behindBy < 2.0 * step_ + 0.5) {
            float low = reached, high = next;
            for (int k = 0; k < kHalvings; ++k) {
                float middle = 0.5 * (low + high);
                vec4 there = view.clipFromRelative * vec4(from + direction * middle, 1.0);
                bool past = there.w > view.near / max(textureLod(behindDepth, onScreen(there), 0.0).r, 1e-9);
                low = past ? low : middle;
                high = past ? middle : high;
            }
            vec2 hit = onScreen(view.clipFromRelative * vec4(from + direction * high, 1.0));
            return vec4(pictureAt(hit, sky), inPicture(hit));
        }
        reached = next;
        step_ *= kGrowth;
    }
    return vec4(0.0);
}
#endif

Mirrored mirroredFrom(vec3 from, vec3 direction)
{
    vec3 sky = skyUnderClouds(skyRadiance(direction), direction.y);
    Mirrored mirrored = farAway(from, direction, sky);
#ifdef MARCH
    vec4 hit = marched(from, direction, sky);
    mirrored.surface.rgb = mix(mirrored.surface.rgb * mirrored.surface.a, hit.rgb, hit.a);
    mirrored.surface.a = mix(mirrored.surface.a, 1.0, hit.a);
    mirrored.surface.rgb /= max(mirrored.surface.a, 1e-6);
#endif
    return mirrored;
}
