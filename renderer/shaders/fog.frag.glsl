// Fog before every surface, blended: the alpha is what is left of the light behind. The sky fogs itself.
#include "fog.glsl"
#include "view.glsl"

layout(binding = GBUFFER_DEPTH_UNIT) uniform sampler2D gbufferDepth;
layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 ray;
layout(location = 0) out vec4 haze;

void main()
{
    vec3 relative = relativeFromDepth(ray, texelFetch(gbufferDepth, ivec2(gl_FragCoord.xy), 0).r);
    float through = fogTransmittance(relative);
    vec3 colour = fogColour(normalize(relative), length(relative));
    haze = vec4(colour * (1.0 - through), through);
}
