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

// Optical depth towards the sun, in steps that grow, each a little aside of the last.
float towardsSun(vec3 relative, float h, float lod)
{
    const float kReach[5] = float[](0.02, 0.06, 0.15, 0.38, 1.0); // shares of the clouds' thickness, to the end of each step
    vec3 sun = light.towardSun;
    vec3 side = normalize(vec3(sun.z, 0.4, -sun.x));
    float tau = 0.0;
    float before = 0.0;
    for (int i = 0; i < 5; ++i) {
        float end = kReach[i] * clouds.thickness;
        float at = 0.5 * (before + end);
        vec3 offset = sun * at + side * (at * 0.15 * ((i & 1) == 0 ? 1.0 : -1.0));
        tau += cloudExtinction(relative + offset, h + offset.y / clouds.thickness, lod + float(i) * 0.5, i < 2) * (end - before);
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

void main()
{
    vec3 direction = normalize(ray);
    seen = vec4(0.0, 0.0, 0.0, 1.0);
    float looked = surfaceDistance();
    distances = min(vec4(kFarthestStored, kFarthestStored, looked, 0.0), vec4(kFarthestStored));
    vec2 part = within(direction, looked);
    if (part.y <= part.x || (clouds.base > 0.0 && direction.y <= 0.0) || part.x > kFarthest) return;

    float cosine = dot(direction, light.towardSun);
    // Steps grow with the distance, from within a cloud faster: what is near hides the rest.
    float growth = part.x > 0.0 ? 1.3 : 3.0;
    float jitter = interleavedNoise(gl_FragCoord.xy);
    float before = 0.0;
    float through = 1.0;
    float reached = 0.0; // distances weighted by what is scattered there
    vec3 radiance = vec3(0.0);
    for (int i = 0; i < STEPS; ++i) {
        float end = pow(float(i + 1) / float(STEPS), growth);
        float metres = (part.y - part.x) * (end - before);
        float t = part.x + (part.y - part.x) * mix(before, end, jitter);
        before = end;
        vec3 relative = direction * t;
        float h = cloudHeight(direction, t);
        float lod = min(log2(max(t * view.pixelAngle * float(SPAN), metres * 0.15) * clouds.perMetre * float(CLOUD_SHAPE_SIZE)), 4.0);
        float extinction = cloudExtinction(relative, h, lod, true);
        if (extinction <= 0.0) continue;
        float tauSun = towardsSun(relative, h, lod);
        float tauWhole = 0.35 * clouds.density * clouds.thickness;
        float powder = 1.0 - exp(-2.0 * (extinction * 0.1 * clouds.thickness));
        vec2 step_ = cloudStep(extinction, metres);
        float weight = through * step_.y;
        radiance += weight * cloudSource(tauSun, powder, tauWhole * (1.0 - h), 0.5 * tauWhole * h, cosine);
        reached += weight * t;
        through *= step_.x;
        if (through < 0.005) break;
    }
    float hiding = 1.0 - through;
    if (hiding < 1e-4) return;
    float middle = reached / hiding;
    through = through < 0.005 ? 0.0 : through;
    float haze = fogTransmittance(direction * middle) * (1.0 - smoothstep(0.6, 1.0, middle / kFarthest));
    haze *= clouds.base > 0.0 ? smoothstep(0.0, 0.05, direction.y) : 1.0;
    seen = vec4(throughAir(radiance, 1.0 - through, direction, middle, direction.y * middle, haze), through);
    distances.rg = min(vec2(part.x, middle), vec2(kFarthestStored));
}
#endif
