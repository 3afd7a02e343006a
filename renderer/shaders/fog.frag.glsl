// Fog over all that the picture shows; blended: the alpha is what is left of the light behind.
#include "fog.glsl"
#include "view.glsl"

layout(binding = GBUFFER_DEPTH_UNIT) uniform sampler2D gbufferDepth;
layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 ray;
layout(location = 0) out vec4 haze;

void main()
{
#ifdef OVER_SKY
    vec3 direction = normalize(ray);
    float through = fogTransmittance(direction * 1e6);
    vec3 colour = skyRadiance(direction) * light.fogTint;
#else
    vec3 relative = relativeFromDepth(ray, texelFetch(gbufferDepth, ivec2(gl_FragCoord.xy), 0).r);
    float through = fogTransmittance(relative);
    vec3 colour = fogColour(normalize(relative));
#endif
    haze = vec4(colour * (1.0 - through), through);
}
