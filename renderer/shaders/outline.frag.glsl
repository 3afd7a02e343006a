// A violet line of two pixels around what is selected, from the bits of the GBuffer.
#include "gbuffer_in.glsl"

layout(location = 0) out vec4 colour;

float selectedAt(ivec2 pixel)
{
    ivec2 last = textureSize(gbufferSurface, 0) - 1;
    vec4 surface = texelFetch(gbufferSurface, clamp(pixel, ivec2(0), last), 0);
    bool drawn = texelFetch(gbufferDepth, clamp(pixel, ivec2(0), last), 0).r > 0.0;
    return drawn && (surfaceBits(surface) & SURFACE_SELECTED) != 0u ? 1.0 : 0.0;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float own = selectedAt(pixel);
    float nearest = 9.0; // squared distance to a selected pixel
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x)
            nearest = min(nearest, selectedAt(pixel + ivec2(x, y)) > 0.0 ? float(x * x + y * y) : 9.0);
    float cover = (1.0 - own) * (1.0 - smoothstep(1.5, 2.6, sqrt(nearest)));
    if (cover <= 0.0) discard;
    colour = vec4(0.66, 0.36, 1.0, cover);
}
