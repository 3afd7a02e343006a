// The shaders of the bare loop: Lambert light, one shadow map, base colour and alpha test.
#pragma once

namespace bench {

constexpr const char* kObjectVertex = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 colour;
layout(location = 4) in vec4 row0; // world from model, by rows
layout(location = 5) in vec4 row1;
layout(location = 6) in vec4 row2;
layout(location = 0) uniform mat4 clipFromWorld;
layout(location = 1) uniform mat4 shadowFromWorld;
layout(location = 2) uniform vec4 uvScaleOffset;
out vec3 vNormal;
out vec2 vUv;
out vec4 vColour;
out vec3 vShadow;
void main()
{
    vec4 model = vec4(position, 1);
    vec4 world = vec4(dot(row0, model), dot(row1, model), dot(row2, model), 1);
    vNormal = vec3(dot(row0.xyz, normal), dot(row1.xyz, normal), dot(row2.xyz, normal));
    vUv = uv * uvScaleOffset.xy + uvScaleOffset.zw;
    vColour = colour;
    vShadow = (shadowFromWorld * world).xyz;
    gl_Position = clipFromWorld * world;
}
)";

constexpr const char* kObjectFragment = R"(#version 450 core
in vec3 vNormal;
in vec2 vUv;
in vec4 vColour;
in vec3 vShadow;
layout(binding = 0) uniform sampler2D baseColour;
layout(binding = 1) uniform sampler2DShadow shadowMap;
layout(location = 3) uniform vec4 factor;
layout(location = 4) uniform vec3 towardSun;
#ifdef MASKED
layout(location = 5) uniform float cutoff;
#endif
layout(location = 0) out vec4 colour;
void main()
{
    vec4 albedo = texture(baseColour, vUv) * factor * vColour;
#ifdef MASKED
    if (albedo.a < cutoff) discard;
#endif
    vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal);
    float lit = texture(shadowMap, vec3(vShadow.xy * 0.5 + 0.5, vShadow.z));
    vec3 light = vec3(1.0, 0.95, 0.85) * (1.35 * max(dot(n, towardSun), 0) * lit) + vec3(0.42, 0.47, 0.53) * (0.7 + 0.3 * n.y);
    colour = vec4(albedo.rgb * light, 1);
}
)";

constexpr const char* kCasterVertex = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 2) in vec2 uv;
layout(location = 4) in vec4 row0;
layout(location = 5) in vec4 row1;
layout(location = 6) in vec4 row2;
layout(location = 1) uniform mat4 shadowFromWorld;
layout(location = 2) uniform vec4 uvScaleOffset;
out vec2 vUv;
void main()
{
    vec4 model = vec4(position, 1);
    vUv = uv * uvScaleOffset.xy + uvScaleOffset.zw;
    gl_Position = shadowFromWorld * vec4(dot(row0, model), dot(row1, model), dot(row2, model), 1);
}
)";

constexpr const char* kCasterFragment = R"(#version 450 core
in vec2 vUv;
layout(binding = 0) uniform sampler2D baseColour;
#ifdef MASKED
layout(location = 5) uniform float cutoff;
#endif
void main()
{
#ifdef MASKED
    if (texture(baseColour, vUv).a < cutoff) discard;
#endif
}
)";

} // namespace bench
