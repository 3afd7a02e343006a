// Half as large, for bloom: 13 taps after Jimenez, "Next Generation Post Processing in Call of Duty: Advanced Warfare"
// (SIGGRAPH 2014), as five groups of four that overlap. At the first level each group is weighed by how dark it is (Karis),
// so that a bright pixel that comes and goes does not flicker; but by no less than a quarter, as the sun is a few pixels too and
// is to glow. QUARTER: four boxes of 2 x 2 pixels at once, for machines
// that pay for each tap.
#include "shared/bindings.h"
#include "shared/tone_map.h"
#include "view.glsl"

layout(binding = BLOOM_UNIT) uniform sampler2D image;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

vec3 at(vec2 pixels)
{
    return clamp(textureLod(image, uv + pixels / vec2(textureSize(image, 0)), 0.0).rgb, vec3(0.0), vec3(60000.0));
}

float weight(vec3 c)
{
#ifdef FIRST
    return max(1.0 / (1.0 + luminance(c) * view.exposure), 0.25);
#else
    return 1.0;
#endif
}

#ifdef QUARTER
void main()
{
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec3 box = at(vec2(i & 1, i >> 1) * 2.0 - 1.0);
        sum += box * weight(box);
        weights += weight(box);
    }
    colour = vec4(sum / weights, 1.0);
}
#else
void main()
{
    vec3 inner = (at(vec2(-1, -1)) + at(vec2(1, -1)) + at(vec2(-1, 1)) + at(vec2(1, 1))) * 0.25;
    vec3 sum = inner * weight(inner) * 0.5;
    float weights = weight(inner) * 0.5;
    vec3 middle = at(vec2(0));
    vec3 left = at(vec2(-2, 0)), right = at(vec2(2, 0)), down = at(vec2(0, -2)), up = at(vec2(0, 2));
    for (int i = 0; i < 4; ++i) {
        vec2 side = vec2(i & 1, i >> 1) * 2.0 - 1.0;
        vec3 group = (middle + (side.x < 0.0 ? left : right) + (side.y < 0.0 ? down : up) + at(side * 2.0)) * 0.25;
        sum += group * weight(group) * 0.125;
        weights += weight(group) * 0.125;
    }
    colour = vec4(sum / weights, 1.0);
}
#endif
