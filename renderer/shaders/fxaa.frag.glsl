// Smooths edges of the finished picture, after Lottes, "FXAA" (2009): finds the local edge and blends along it.
#include "shared/bindings.h"
#include "view.glsl"

layout(binding = IMAGE_UNIT) uniform sampler2D image; // brightness in alpha
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

// Of 3 x 3 pixels, each read once: what bilinear taps between them would give, for half the work.
float brightness(ivec2 pixel)
{
    return texelFetch(image, clamp(pixel, ivec2(0), textureSize(image, 0) - 1), 0).a;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float own = brightness(pixel);
    float n = brightness(pixel + ivec2(0, 1));
    float s = brightness(pixel - ivec2(0, 1));
    float e = brightness(pixel + ivec2(1, 0));
    float w = brightness(pixel - ivec2(1, 0));
    float nw = 0.25 * (own + n + w + brightness(pixel + ivec2(-1, 1)));
    float ne = 0.25 * (own + n + e + brightness(pixel + ivec2(1, 1)));
    float sw = 0.25 * (own + s + w + brightness(pixel + ivec2(-1, -1)));
    float se = 0.25 * (own + s + e + brightness(pixel + ivec2(1, -1)));
    float lowest = min(own, min(min(nw, ne), min(sw, se)));
    float highest = max(own, max(max(nw, ne), max(sw, se)));
    float contrast = highest - lowest;
    if (contrast < max(0.04, highest * 0.11)) discard; // the picture below already holds this pixel

    // Across the gradient, that is along the edge.
    vec2 direction = vec2((nw + ne) - (sw + se), (nw + sw) - (ne + se));
    float reduce = max((nw + ne + sw + se) * 0.25 * 0.125, 1.0 / 128.0);
    float scale = 1.0 / (min(abs(direction.x), abs(direction.y)) + reduce);
    direction = clamp(direction * scale, vec2(-8.0), vec2(8.0)) * view.texel;

    vec4 near = 0.5 * (textureLod(image, uv + direction * (1.0 / 3.0 - 0.5), 0.0) +
                       textureLod(image, uv + direction * (2.0 / 3.0 - 0.5), 0.0));
    vec4 far = 0.5 * near + 0.25 * (textureLod(image, uv - direction * 0.5, 0.0) + textureLod(image, uv + direction * 0.5, 0.0));
    colour = far.a < lowest || far.a > highest ? near : far;
}
