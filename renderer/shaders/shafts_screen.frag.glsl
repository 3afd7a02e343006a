// Shafts from the picture's own depth, after the radial gathering of Mitchell, "Volumetric Light Scattering as a
// Post-Process" (GPU Gems 3, ch. 13), but knowing how deep things lie. A place in the fog at depth t on this pixel's ray
// sends a ray to the sun that runs over the picture towards it; at the share f of the way its depth is t / (1 - f). So what
// stands there at depth z, some metres thick, darkens the fog from z (1 - f) on.
#include "shafts.glsl"
#ifdef CLOUD_SHADOWS
#include "cloud_shadow.glsl"
#endif

layout(binding = GBUFFER_DEPTH_UNIT) uniform sampler2D gbufferDepth;
layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 ray;
layout(location = 0) out vec4 missing; // light; and m along the view, up to which

const int kTaps = 32, kCloudTaps = 12;
const float kCloudsEnd = 12000.0; // m, of fog that is looked at for them
const float kFarthest = 6e4;      // m, that a half float holds
const float kSky = 1e5;            // m
const float kThickness = 0.12;     // of what stands there, of its distance
const float kLeastThickness = 1.5; // m

// Of fog on this pixel's ray up to a depth, as fogTransmittance() knows it; (1 - exp(-x)) / x by its fraction.
float opticalDepth(float depth)
{
    float x = clamp(ray.y * depth / light.fogHeight, -2.0, 4.0);
    return light.fogDensity * length(ray) * depth / (1.0 + x * (0.5 + x * (1.0 / 12.0)));
}

float depthAt(vec2 place)
{
    ivec2 size = textureSize(gbufferDepth, 0);
    float depth = texelFetch(gbufferDepth, clamp(ivec2(place * vec2(size)), ivec2(0), size - 1), 0).r;
    return depth > 0.0 ? view.near / depth : kSky;
}

// Shares of the light from behind the fog that its dark parts take, which things throw into it.
float behindThings(float own, float noise)
{
    float covered = 0.0; // m, up to which it is known
    float dark = 0.0;
    for (int i = 0; i < kTaps; ++i) { // from the sun to here: places in the fog come nearest first
        float left = (float(i) + noise) / float(kTaps); // 1 - f
        vec2 place = mix(shafts.sun, uv, left);
        if (any(lessThan(place, vec2(0.0))) || any(greaterThan(place, vec2(1.0)))) continue;
        float z = depthAt(place);
        if (z >= kSky) continue;
        float from = max(z * left, covered);
        float to = min((z + max(z * kThickness, kLeastThickness)) * (left + 1.0 / float(kTaps)), own);
        if (to <= from) continue;
        float thin = opticalDepth(from), thick = opticalDepth(to);
        dark += max(thick - thin, 0.0) * exp(-0.5 * (thin + thick));
        covered = to;
    }
    return min(dark, 1.0) * shafts.strength;
}

#ifdef CLOUD_SHADOWS
float underClouds(float own, float noise)
{
    float end = min(own, kCloudsEnd), dark = 0.0, from = 0.0, thin = 0.0;
    for (int i = 0; i < kCloudTaps; ++i) {
        float share = float(i + 1) / float(kCloudTaps), to = end * share * share;
        float thick = opticalDepth(to);
        float lost = 1.0 - cloudShadow(ray * mix(from, to, noise));
        dark += lost * max(thick - thin, 0.0) * exp(-0.5 * (thin + thick));
        from = to;
        thin = thick;
    }
    return min(dark, 1.0) * shafts.clouds;
}
#endif

void main()
{
    float own = depthAt(uv), noise = interleavedNoise(gl_FragCoord.xy);
    float dark = shafts.strength > 0.0 ? behindThings(own, noise) : 0.0;
#ifdef CLOUD_SHADOWS
    dark += (1.0 - dark) * underClouds(own, noise);
#endif
    vec3 direction = normalize(ray);
    missing = vec4(fogColour(direction, own * length(ray)) * sunShareOfFog(direction) * dark, min(own, kFarthest));
}
