// Takes what is missing in fog from all that is seen through it, sky and surfaces.
#include "shafts.glsl"

layout(binding = GBUFFER_DEPTH_UNIT) uniform sampler2D gbufferDepth;
layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 ray;
layout(location = 0) out vec4 radiance; // added

void main()
{
    float depth = texelFetch(gbufferDepth, ivec2(gl_FragCoord.xy), 0).r;
    vec3 missing = missingInFog(uv, ray * (view.near / max(depth, view.near * 1e-5)));
    if (missing.r + missing.g + missing.b <= 0.0) discard;
    radiance = vec4(-missing, 0.0);
}
