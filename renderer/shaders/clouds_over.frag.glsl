// Lays the clouds over the picture at full resolution: before the sky, and before surfaces as far as they reach into them.
#include "shared/bindings.h"
#include "view.glsl"

layout(binding = GBUFFER_DEPTH_UNIT) uniform sampler2D gbufferDepth;
layout(binding = CLOUD_IMAGE_UNIT) uniform sampler2D cloudImage;
layout(binding = IMAGE_UNIT) uniform sampler2D cloudDistances;
layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 ray;
layout(location = 0) out vec4 over; // light, and the share of what is there that stays

void main()
{
    // Four bilinear taps: a tent over 3 x 3 texels, which takes out the noise that the march began with.
    vec2 half_ = 0.5 / vec2(textureSize(cloudImage, 0));
    over = vec4(0.0);
    for (int y = -1; y <= 1; y += 2)
        for (int x = -1; x <= 1; x += 2)
            over += textureLod(cloudImage, uv + half_ * vec2(x, y), 0.0) * 0.25;

    float depth = texelFetch(gbufferDepth, ivec2(gl_FragCoord.xy), 0).r;
    if (depth <= 0.0) return;
    vec2 distances = textureLod(cloudDistances, uv, 0.0).rg;
    float surface = length(relativeFromDepth(ray, depth));
    float share = clamp((surface - distances.x) / max(2.0 * (distances.y - distances.x), 1.0), 0.0, 1.0);
    float through = pow(max(over.a, 1e-4), share);
    over = vec4(over.rgb * ((1.0 - through) / max(1.0 - over.a, 1e-4)), through);
}
