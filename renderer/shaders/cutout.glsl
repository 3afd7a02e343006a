// What is cut out by alpha keeps its fullness far away. Mips are made so that the share of texels above the cutoff stays;
// where a mip has few texels left to a leaf, a threshold that differs from place to place keeps the mean of them all:
// after Wyman and McGuire, "Hashed Alpha Testing" (2017), the place being the texel, so that it moves with the leaf.
const float kHashedFrom = 2.0; // mip
const float kHashedFully = 4.5;

float cutoutThreshold(vec2 uv, vec2 size, float cutoff, uint seed)
{
    vec2 dx = dFdx(uv) * size;
    vec2 dy = dFdy(uv) * size;
    float mip = 0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), 1.0));
    uvec2 texel = uvec2(ivec2(floor(uv * size * exp2(-floor(mip)))));
    uint h = (texel.x * 0x9e3779b1u) ^ (texel.y * 0x85ebca77u) ^ (seed * 0xc2b2ae3du);
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    float noise = float((h >> 9) & 0x3fffu) / 16384.0 - 0.5;
    float hashed = clamp((mip - kHashedFrom) / (kHashedFully - kHashedFrom), 0.0, 1.0);
    return cutoff + noise * hashed * min(cutoff, 1.0 - cutoff);
}
