// Whether the square of texels at a place of the map is missing.
bool inHole(sampler2D cover, vec2 texel)
{
    return texelFetch(cover, ivec2(texel), 0).r > 0.498; // its highest bit
}
