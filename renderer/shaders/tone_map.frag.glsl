// Scene-linear radiance to the picture: exposure, curve, sRGB, dither. Alpha keeps the brightness for edge smoothing.
#include "shared/bindings.h"
#include "shared/tone_map.h"
#include "view.glsl"

layout(binding = IMAGE_UNIT) uniform sampler2D image;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main()
{
    vec3 linear = texelFetch(image, ivec2(gl_FragCoord.xy), 0).rgb * view.exposure;
    vec3 shown = toneMapToSrgb(CURVE, linear);
    float noise = interleavedNoise(gl_FragCoord.xy) - 0.5;
    shown = clamp(shown + noise / 255.0, vec3(0.0), vec3(1.0));
    colour = vec4(shown, luminance(shown));
}
