// Water between an eye in it and what it sees: light that is lost, and what the water scatters.
#include "gbuffer_in.glsl"
#include "sky_light.glsl"
#include "view.glsl"
#include "water.glsl"

layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 ray;
layout(location = 0) out vec4 radiance; // and what is left of what is behind

void main()
{
    float depth = texelFetch(gbufferDepth, ivec2(gl_FragCoord.xy), 0).r;
    vec3 direction = normalize(ray);
    float way = depth > 0.0 ? length(relativeFromDepth(ray, depth)) : 1e5;
    way = direction.y > 0.0 ? min(way, water.height / direction.y + water.waves) : way; // no farther than the surface
    float through = exp(-water.extinction * way);
    // Deeper down it is darker.
    vec3 around = light.sunIrradiance * (max(light.towardSun.y, 0.0) / 3.14159265) + skyIrradiance(vec3(0.0, 1.0, 0.0)) * light.ambient;
    float dim = exp(-0.35 * water.extinction * max(water.height - direction.y * min(way, 1.0 / water.extinction), 0.0));
    radiance = vec4(water.colour * around * (dim * (1.0 - through)), through);
}
