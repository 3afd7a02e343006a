// What is cut out by alpha keeps its fullness far away. Mips are made so that the share of texels above their thresholds
// stays; where a mip has few texels left to a leaf, a threshold that differs from place to place keeps the mean of them all:
// after Wyman and McGuire, "Hashed Alpha Testing" (2017), the place being the texel, so that it moves with the leaf.
#include "shared/material.h"
#include "texel_noise.glsl"

// The exponent's bits in place of log2() and exp2(), and no multiplied integers: this runs for every layer of leaves.
float cutoutThreshold(vec2 uv, vec2 size, float cutoff, uint seed)
{
    vec2 dx = dFdx(uv) * size;
    vec2 dy = dFdy(uv) * size;
    float texels = max(max(dot(dx, dx), dot(dy, dy)), 1.0); // squared, a pixel
    float mip = float(floatBitsToInt(texels)) * (0.5 / 8388608.0) - 63.5; // log2, straight between the powers of two
    float scale = intBitsToFloat((127 - int(mip)) << 23);
    float noise = texelNoise(floor(uv * size * scale), seed) - 0.5;
    return cutoff + noise * cutoutSpread(mip, cutoff);
}
