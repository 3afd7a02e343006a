// 0..1, different from texel to texel and from thing to thing: Jimenez's gradient noise (2014), of whole numbers up to a few
// thousand.
float texelNoise(vec2 texel, uint seed)
{
    vec2 moved = texel + vec2(seed & 63u, (seed >> 6) & 63u);
    return fract(52.9829189 * fract(dot(moved, vec2(0.06711056, 0.00583715))));
}
