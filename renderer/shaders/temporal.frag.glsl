// Anti-aliasing over time, after Karis, "High Quality Temporal Supersampling" (SIGGRAPH 2014): this frame, drawn a part of a
// pixel aside, is mixed into what earlier ones gathered, found again by where its surface was seen then. What has no place
// among the colours around it (Salvi, variance clipping, GDC 2016) is drawn towards them: leaves that swayed leave no trail.
#include "gbuffer_in.glsl"
#include "shared/bindings.h"
#include "shared/tone_map.h"
#include "view.glsl"

layout(binding = IMAGE_UNIT) uniform sampler2D image;
layout(binding = HISTORY_UNIT) uniform sampler2D history;
layout(std140, binding = PASS_BINDING) uniform PassBlock {
    mat4 lastClipFromRelative; // from this eye to the last frame's picture, neither moved aside
    vec4 mixing;               // x: share of this frame
};
layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 ray;
layout(location = 0) out vec4 radiance;

const float kDeviations = 1.25; // that the past may stray from its neighbours

// Bright pixels weigh less, or a lamp's edge would stay jagged.
vec3 compress(vec3 c) { return c / (1.0 + luminance(c) * view.exposure); }
vec3 expand(vec3 c) { return c / max(1.0 - luminance(c) * view.exposure, 1e-4); }

// Catmull-Rom through 4 x 4 texels by five taps (Jimenez 2016): bilinear would blur at each frame that moves.
vec3 gathered(vec2 place)
{
    vec2 size = vec2(textureSize(history, 0));
    vec2 at = place * size - 0.5, base = floor(at), f = at - base;
    vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f)), w1 = 1.0 + f * f * (-2.5 + 1.5 * f);
    vec2 w2 = f * (0.5 + f * (2.0 - 1.5 * f)), w3 = f * f * (-0.5 + 0.5 * f);
    vec2 w12 = w1 + w2;
    vec2 first = (base - 0.5) / size, second = (base + 0.5 + w2 / w12) / size, third = (base + 2.5) / size;
    vec4 sum = vec4(compress(textureLod(history, second, 0.0).rgb), 1.0) * (w12.x * w12.y);
    sum += vec4(compress(textureLod(history, vec2(second.x, first.y), 0.0).rgb), 1.0) * (w12.x * w0.y);
    sum += vec4(compress(textureLod(history, vec2(first.x, second.y), 0.0).rgb), 1.0) * (w0.x * w12.y);
    sum += vec4(compress(textureLod(history, vec2(third.x, second.y), 0.0).rgb), 1.0) * (w3.x * w12.y);
    sum += vec4(compress(textureLod(history, vec2(second.x, third.y), 0.0).rgb), 1.0) * (w12.x * w3.y);
    return max(sum.rgb / sum.a, vec3(0.0));
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy), most = textureSize(image, 0) - 1;
    vec3 mean = vec3(0.0), squares = vec3(0.0), own = vec3(0.0);
    float nearest = 0.0; // depth: the edge of what stands before moves with it
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            ivec2 p = clamp(pixel + ivec2(x, y), ivec2(0), most);
            vec3 c = compress(texelFetch(image, p, 0).rgb);
            mean += c / 9.0;
            squares += c * c / 9.0;
            if (x == 0 && y == 0) own = c;
            nearest = max(nearest, texelFetch(gbufferDepth, p, 0).r);
        }
    vec3 relative = ray * (view.near / max(nearest, 1e-7));
    vec4 clip = lastClipFromRelative * vec4(relative, 1.0);
    vec2 before = clip.xy / clip.w * 0.5 + 0.5;
    bool seen = clip.w > 0.0 && all(greaterThanEqual(before, vec2(0.0))) && all(lessThanEqual(before, vec2(1.0)));
    vec3 past = own;
    if (seen && mixing.x < 1.0) {
        vec3 reach = kDeviations * sqrt(max(squares - mean * mean, vec3(0.0))) + 1e-5;
        past = gathered(before);
        vec3 from = past - mean;
        vec3 over = abs(from) / reach;
        past = mean + from / max(max(over.x, max(over.y, over.z)), 1.0);
    }
    radiance = vec4(expand(mix(past, own, mixing.x)), 1.0);
}
