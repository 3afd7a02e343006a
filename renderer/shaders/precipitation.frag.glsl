// A drop's streak or a flake, soft where it meets a surface.
#include "gbuffer_in.glsl"
#include "view.glsl"

layout(location = 0) in vec2 corner;
layout(location = 1) flat in vec4 light_;
layout(location = 2) flat in vec4 fog;
layout(location = 3) flat in vec2 shape; // of a flake; a streak has none: below 0
layout(location = 0) out vec4 radiance;

const float kSoft = 0.25; // m

void main()
{
    float before = view.near / max(texelFetch(gbufferDepth, ivec2(gl_FragCoord.xy), 0).r, 1e-9) - view.near / gl_FragCoord.z;
    float r = length(corner);
    float covered;
    if (shape.y >= 0.0) {
        float ragged = 1.0 - 0.35 * shape.y * (0.5 + 0.5 * cos(3.0 * atan(corner.y, corner.x) + shape.x));
        covered = 1.0 - smoothstep(0.35 * ragged, ragged, r);
    } else covered = (1.0 - corner.x * corner.x) * (1.0 - smoothstep(0.4, 1.0, abs(corner.y)));
    covered *= light_.a * clamp(before / kSoft, 0.0, 1.0);
    radiance = vec4((light_.rgb * fog.a + fog.rgb) * covered, 1.0 - covered);
}
