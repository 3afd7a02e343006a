// Clouds before whatever is behind them, at a lower resolution: volumes, or the layer for an eye above it (LAYER).
#include "cloud_light.glsl"
#include "clouds_layer.glsl"
#include "clouds_volume.glsl"
#include "fog.glsl"
#include "view.glsl"

layout(binding = GBUFFER_DEPTH_UNIT) uniform sampler2D gbufferDepth;
layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 ray;
layout(location = 0) out vec4 seen;     // their light; share of what is behind that comes through
layout(location = 1) out vec4 distances; // where they begin, their middle, how far was looked, m

const float kFarthest = 150000.0;     // m
const float kFarthestStored = 60000.0; // m, as 16 bits hold

// To the farthest surface of the pixels that this one stands for: what is nearer is sorted out at full resolution.
float surfaceDistance()
{
    ivec2 size = textureSize(gbufferDepth, 0);
    ivec2 first = ivec2(gl_FragCoord.xy) * SPAN;
    float depth = 1.0;
    for (int y = 0; y < SPAN; ++y)
        for (int x = 0; x < SPAN; ++x)
            depth = min(depth, texelFetch(gbufferDepth, min(first + ivec2(x, y), size - 1), 0).r);
    return depth > 0.0 ? length(relativeFromDepth(ray, depth)) : 1e9;
}

#ifdef LAYER
void main()
{
    vec3 direction = normalize(ray);
    LayerSeen layer = layerTowards(direction);
    seen = vec4(layer.radiance, layer.through);
    float metres = layer.metres < 0.0 ? kFarthestStored : layer.metres;
    distances = min(vec4(metres, metres, surfaceDistance(), 0.0), vec4(kFarthestStored));
}
#else
const float kLongest = 30000.0; // m of cloud that a ray goes through at most
const float kLeastLong = 90.0;  // m of a step between clouds
const float kShortest = 0.15;   // of the long steps: the first in a cloud
const float kGrowing = 1.9;     // of each further one
const int kHalvings = 2;
const int kLongSteps = 32;

// Optical depth towards the sun, in steps that grow, each a little aside of the last.
float towardsSun(vec3 relative, float h, float lod)
{
    const float kReach[4] = float[](0.025, 0.09, 0.3, 1.0); // shares of the clouds' thickness, to the end of each step
    vec3 sun = light.towardSun;
    vec3 side = normalize(vec3(sun.z, 0.4, -sun.x));
    float tau = 0.0;
    float before = 0.0;
    for (int i = 0; i < 4; ++i) {
        float end = kReach[i] * clouds.thickness;
        float at = 0.5 * (before + end);
        vec3 offset = sun * at + side * (at * 0.15 * ((i & 1) == 0 ? 1.0 : -1.0));
        tau += cloudExtinction(relative + offset, h + offset.y / clouds.thickness, lod + float(i) * 0.6, i == 0) * (end - before);
        before = end;
    }
    return tau;
}

// The part of the ray between the base's and the top's shells; nothing of it where y is not greater than x.
vec2 within(vec3 direction, float limit)
{
    vec2 base = cloudShell(clouds.planet, direction.y, clouds.base);
    vec2 top = cloudShell(clouds.planet, direction.y, clouds.base + clouds.thickness);
    if (top.y <= 0.0) return vec2(0.0);
    vec2 part = clouds.base > 0.0 ? vec2(base.y, top.y) : vec2(max(top.x, 0.0), base.x > 0.0 ? base.x : top.y);
    return vec2(part.x, min(min(part.y, part.x + kLongest), limit));
}

float lodAt(float t) // of the field, where a pixel of these clouds covers a texel
{
    return clamp(log2(t * view.pixelAngle * float(SPAN) * clouds.perMetre * float(CLOUD_SHAPE_SIZE)), -2.0, 4.0);
}

float extinctionAt(vec3 direction, float t, bool fine)
{
    return cloudExtinction(direction * t, cloudHeight(direction, t), lodAt(t), fine);
}

// Where a cloud begins between two places of a ray, the farther of which lies in it.
float edgeBetween(vec3 direction, float outside, float inside)
{
    for (int i = 0; i < kHalvings; ++i) {
        float middle = 0.5 * (outside + inside);
        if (extinctionAt(direction, middle, true) > 0.0) inside = middle;
        else outside = middle;
    }
    return inside;
}

struct Marched {
    vec3 radiance;
    float through;
    float reached; // distances weighted by what is scattered there
};

// Long steps through the air between clouds. Where one of them ends in a cloud its edge is looked for, and steps begin anew from
// short ones: so edges lie where they are, whatever the steps, and the light of what is seen most is found in detail.
Marched march(vec3 direction, vec2 part)
{
    float cosine = dot(direction, light.towardSun);
    float tauWhole = 0.35 * clouds.density * clouds.thickness;
    float jitter = interleavedNoise(gl_FragCoord.xy);
    Marched m = Marched(vec3(0.0), 1.0, 0.0);
    float t = part.x;
    float step_ = 0.0;
    bool outside = true;
    for (int i = 0; i < STEPS && t < part.y && m.through > 0.01; ++i) {
        float longest = max((part.y - part.x) / float(kLongSteps), kLeastLong) * (0.4 + 1.2 * (t - part.x) / (part.y - part.x));
        if (i == 0) step_ = longest * jitter;
        float at = t + step_ * (outside ? 1.0 : jitter);
        float extinction = extinctionAt(direction, at, true);
        if (outside && extinction > 0.0) {
            t = edgeBetween(direction, t, at);
            step_ = longest * kShortest;
            outside = false;
            continue;
        }
        t += step_;
        if (extinction <= 0.0) {
            step_ = outside ? longest : min(step_ * 2.0, longest);
            outside = step_ >= longest;
            continue;
        }
        vec3 relative = direction * at;
        float h = cloudHeight(direction, at);
        float tauSun = towardsSun(relative, h, lodAt(at));
        float powder = 1.0 - exp(-2.0 * (extinction * 0.1 * clouds.thickness));
        vec2 passed = cloudStep(extinction, step_);
        float weight = m.through * passed.y;
        m.radiance += weight * cloudSource(tauSun, powder, tauWhole * (1.0 - h), 0.5 * tauWhole * h, cosine);
        m.reached += weight * at;
        m.through *= passed.x;
        step_ = min(step_ * kGrowing, longest);
    }
    return m;
}

void main()
{
    vec3 direction = normalize(ray);
    seen = vec4(0.0, 0.0, 0.0, 1.0);
    float looked = surfaceDistance();
    distances = min(vec4(kFarthestStored, kFarthestStored, looked, 0.0), vec4(kFarthestStored));
    vec2 part = within(direction, looked);
    if (part.y <= part.x || (clouds.base > 0.0 && direction.y <= 0.0) || part.x > kFarthest) return;

    Marched m = march(direction, part);
    float hiding = 1.0 - m.through;
    if (hiding < 1e-4) return;
    float middle = m.reached / hiding;
    float through = m.through < 0.01 ? 0.0 : m.through;
    float haze = fogTransmittance(direction * middle) * (1.0 - smoothstep(0.6, 1.0, middle / kFarthest));
    haze *= clouds.base > 0.0 ? smoothstep(0.0, 0.05, direction.y) : 1.0;
    seen = vec4(throughAir(m.radiance, 1.0 - through, direction, middle, direction.y * middle, haze), through);
    distances.rg = min(vec2(part.x, middle), vec2(kFarthestStored));
}
#endif
