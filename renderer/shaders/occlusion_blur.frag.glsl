// Mean over the 4 x 4 pixels that searched in different directions, one axis at a time, without what lies behind an edge.
// Reversed depth is linear on the screen along a plane: what keeps to the slope belongs to the same surface.
#include "shared/bindings.h"
#include "shared/occlusion.h"

layout(std140, binding = PASS_BINDING) uniform PassBlock { OcclusionPass pass; };
layout(binding = IMAGE_UNIT) uniform sampler2D image;
layout(location = 0) out vec2 result;

const float kTolerance = 0.03; // of depth, from the slope

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec2 taps[5];
    for (int i = 0; i < 5; ++i)
        taps[i] = texelFetch(image, clamp(texel + (i - 2) * pass.step, ivec2(0), pass.size - 1), 0).rg;
    float depth = taps[2].g;
    float back = depth - taps[1].g;
    float ahead = taps[3].g - depth;
    float slope = abs(back) < abs(ahead) ? back : ahead;
    float scale = 1.0 / (kTolerance * max(depth, 1e-9));
    float sum = taps[2].r, weights = 1.0;
    for (int i = 0; i < 5; ++i) {
        if (i == 2) continue;
        float away = abs(taps[i].g - depth - slope * float(i - 2));
        float w = (i == 0 || i == 4 ? 0.5 : 1.0) * clamp(2.0 - away * scale, 0.0, 1.0);
        sum += taps[i].r * w;
        weights += w;
    }
    float seen = sum / weights;
#ifdef LAST
    seen = pow(clamp(seen, 0.0, 1.0), pass.strength * OCCLUSION_POWER);
#endif
    result = vec2(seen, depth);
}
