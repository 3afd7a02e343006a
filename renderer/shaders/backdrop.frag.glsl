// The studio of thumbnails: a plain ground that fades into the wall behind, darker where the model stands.
#include "shared/bindings.h"
#include "view.glsl"

layout(std140, binding = PASS_BINDING) uniform PassBlock { vec4 foot; }; // under the model: x, y, z from the eye; radius
layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 ray;
layout(location = 0) out vec4 radiance;

void main()
{
    vec3 wall = mix(vec3(0.16, 0.17, 0.19), vec3(0.30, 0.32, 0.35), smoothstep(0.1, 1.0, uv.y));
    float t = foot.y / min(ray.y, -1e-4);
    vec3 place = ray * t;
    float away = length(place.xz - foot.xz) / foot.w;
    vec3 ground = vec3(0.27, 0.27, 0.26) * (1.0 - 0.55 * exp(-away * away * 1.7));
    float fade = ray.y < 0.0 ? exp(-away * 0.28) : 0.0;
    radiance = vec4(mix(wall, ground, fade), 1.0);
}
