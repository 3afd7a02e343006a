// Mixes pixels with the neighbour across an edge, by weight: light is mixed, not its code.
#include "shared/bindings.h"

layout(binding = IMAGE_UNIT) uniform sampler2D image;
layout(binding = HISTORY_UNIT) uniform sampler2D weights; // as smaa_weights.frag.glsl writes them
layout(location = 0) out vec4 colour;

vec4 weightsAt(ivec2 pixel)
{
    ivec2 size = textureSize(weights, 0);
    return all(lessThan(pixel, size)) ? texelFetch(weights, pixel, 0) : vec4(0.0);
}

vec3 light(ivec2 pixel) // by the square, near enough to sRGB
{
    vec3 c = texelFetch(image, clamp(pixel, ivec2(0), textureSize(image, 0) - 1), 0).rgb;
    return c * c;
}

void main()
{
    ivec2 p = ivec2(gl_FragCoord.xy);
    vec4 own = weightsAt(p);
    float below = own.r, left = own.b;
    float above = weightsAt(p + ivec2(0, 1)).g, right = weightsAt(p + ivec2(1, 0)).a;
    if (below + left + above + right == 0.0) discard; // the picture below already holds this pixel
    bool alongX = max(left, right) > max(below, above); // the stronger of two that meet
    ivec2 step_ = alongX ? ivec2(1, 0) : ivec2(0, 1);
    float back = alongX ? left : below, ahead = alongX ? right : above;
    vec3 mixed = light(p) * max(1.0 - back - ahead, 0.0) + light(p - step_) * back + light(p + step_) * ahead;
    colour = vec4(sqrt(mixed), 1.0);
}
