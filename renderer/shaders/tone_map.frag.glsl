// Scene-linear radiance to the picture: bloom, exposure, lens and film, curve, sRGB, dither. Alpha keeps the brightness for
// the smoothing of edges. What is neutral is not compiled in, so it changes nothing and costs nothing.
#include "shared/bindings.h"
#include "shared/film.h"
#include "view.glsl"

layout(binding = IMAGE_UNIT) uniform sampler2D image;
layout(std140, binding = PASS_BINDING) uniform FilmBlock { Film film; };
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

#ifdef BLOOM
layout(binding = BLOOM_UNIT) uniform sampler2D bloom;
#endif

#ifdef CHOSEN_EXPOSURE
#include "gbuffer_in.glsl"
#include "shared/exposure.h"
layout(std140, binding = PICTURE_BINDING) uniform ChosenBlock { ChosenExposure chosen; };

// What takes no light was drawn for the exposure of the frame before.
float exposureAt(ivec2 pixel)
{
    bool drawn = texelFetch(gbufferDepth, pixel, 0).r > 0.0;
    bool unlit = drawn && (surfaceBits(texelFetch(gbufferSurface, pixel, 0)) & SURFACE_UNLIT) != 0u;
    return unlit ? chosen.before : view.exposure;
}
#else
float exposureAt(ivec2 pixel)
{
    return view.exposure;
}
#endif

#ifdef GRAIN
// Grains of silver: most to be seen in the middle tones, other ones in each picture of the film.
float grain(ivec2 pixel, float brightness)
{
    uint h = uint(pixel.x) * 0x8da6b343u ^ uint(pixel.y) * 0xd8163841u ^ uint(film.moment) * 0xcb1ab31fu;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    h ^= h >> 15;
    float noise = float(h & 0xffffu) / 65536.0 + float(h >> 16) / 65536.0 - 1.0;
    return noise * film.grain * (0.03 + 0.5 * sqrt(brightness) * (1.0 - brightness));
}
#endif

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 linear = texelFetch(image, pixel, 0).rgb;
#ifdef BLOOM
    linear = mix(linear, textureLod(bloom, uv, 0.0).rgb, film.bloom);
#endif
    float exposure = exposureAt(pixel);
#ifdef VIGNETTE
    exposure *= vignetteAt(film, uv);
#endif
    linear *= exposure;
#ifdef WHITE_BALANCE
    linear = whiteBalanced(film, linear);
#endif
#ifdef CONTRAST
    linear = contrasted(film, linear);
#endif
#ifdef SATURATION
    linear = saturated(film, linear);
#endif
    vec3 shown = toneMapToSrgb(CURVE, linear);
#ifdef GRAIN
    shown += grain(pixel, luminance(shown));
#endif
#ifdef DITHER
    shown += triangular(interleavedNoise(gl_FragCoord.xy)) * (1.0 / 255.0);
#endif
    shown = clamp(shown, vec3(0.0), vec3(1.0));
    colour = vec4(shown, luminance(shown));
}
