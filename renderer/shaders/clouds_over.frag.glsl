// Lays the clouds over the picture at full resolution: before the sky, and before surfaces as far as they reach into them.
#include "shared/bindings.h"
#include "view.glsl"

layout(binding = GBUFFER_DEPTH_UNIT) uniform sampler2D gbufferDepth;
layout(binding = CLOUD_IMAGE_UNIT) uniform sampler2D cloudImage;
layout(binding = IMAGE_UNIT) uniform sampler2D cloudDistances;
layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 ray;
layout(location = 0) out vec4 over; // light, and the share of what is there that stays

const float kFarthestStored = 60000.0; // m, as in clouds.frag.glsl

struct CloudsSeen {
    vec4 image;
    vec2 distances; // where they begin and their middle
};

// A tent over 3 x 3 texels takes out the noise that the march began with. Those before which a nearer surface stands did not look
// as far as this pixel does and know nothing of its clouds.
CloudsSeen cloudsAround(vec2 place, float surface)
{
    ivec2 own = ivec2(place);
    ivec2 last = textureSize(cloudImage, 0) - 1;
    vec2 part = fract(place);
    vec3 tentX = vec3(1.0 - part.x, 1.0, part.x), tentY = vec3(1.0 - part.y, 1.0, part.y);
    float enough = 0.9 * min(surface, kFarthestStored);
    CloudsSeen sum = CloudsSeen(vec4(0.0), vec2(0.0));
    float weights = 0.0;
    float hidden = 0.0;
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) {
            ivec2 texel = clamp(own + ivec2(x, y) - 1, ivec2(0), last);
            vec3 distances = texelFetch(cloudDistances, texel, 0).rgb;
            if (texel != own && distances.b < enough) continue;
            vec4 image = texelFetch(cloudImage, texel, 0);
            float weight = tentX[x] * tentY[y];
            float hides = weight * (1.0 - image.a);
            sum.image += image * weight;
            sum.distances += distances.rg * hides;
            weights += weight;
            hidden += hides;
        }
    return CloudsSeen(sum.image / weights, sum.distances / max(hidden, 1e-6));
}

void main()
{
    float depth = texelFetch(gbufferDepth, ivec2(gl_FragCoord.xy), 0).r;
    float surface = depth > 0.0 ? length(relativeFromDepth(ray, depth)) : kFarthestStored;
    CloudsSeen seen = cloudsAround(gl_FragCoord.xy / float(SPAN), surface);
    over = seen.image;
    if (depth <= 0.0) return;
    float share = clamp((surface - seen.distances.x) / max(2.0 * (seen.distances.y - seen.distances.x), 1.0), 0.0, 1.0);
    float through = pow(max(over.a, 1e-4), share);
    over = vec4(over.rgb * ((1.0 - through) / max(1.0 - over.a, 1e-4)), through);
}
