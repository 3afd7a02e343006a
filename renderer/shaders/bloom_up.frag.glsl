// Twice as large, for bloom: a tent of 3 x 3 as four taps between texels. Alpha is how much of it is mixed into the level
// above.
#include "shared/bindings.h"

layout(binding = BLOOM_UNIT) uniform sampler2D image;
layout(std140, binding = PASS_BINDING) uniform PassBlock { vec4 share; };
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main()
{
    vec2 half_ = 0.5 / vec2(textureSize(image, 0));
    vec3 sum = textureLod(image, uv + vec2(-half_.x, -half_.y), 0.0).rgb + textureLod(image, uv + vec2(half_.x, -half_.y), 0.0).rgb +
               textureLod(image, uv + vec2(-half_.x, half_.y), 0.0).rgb + textureLod(image, uv + vec2(half_.x, half_.y), 0.0).rgb;
    colour = vec4(sum * 0.25, share.x);
}
