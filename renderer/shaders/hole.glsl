// Whether the square of texels at a place of the map is missing.
bool inHole(MAP_TEXTURE cover, vec2 texel)
{
#ifdef WINDOWS
    float level = floor(windowLevel(texel));
    vec4 packed_ = texelFetch(cover, windowTexel(ivec2(texel * exp2(-level)), int(level)), 0);
#else
    vec4 packed_ = texelFetch(cover, ivec2(texel), 0);
#endif
    return packed_.r > 0.498; // its highest bit
}
