#include "clouds.glsl"

layout(binding = CLOUD_MAP_UNIT) uniform sampler2D cloudMap;

// Share of the sun that clouds leave to a place, m from the eye: a surface's, or one in the air.
float cloudShadow(vec3 relative)
{
    vec2 uv = (relative.xz - clouds.sunward * relative.y) * (1.0 / CLOUD_MAP_METRES) + clouds.map.zw;
    vec2 out_ = abs(uv - 0.5) * 2.0;
    float beyond = smoothstep(0.85, 0.98, max(out_.x, out_.y)); // of the map: the mean
    float through = mix(textureLod(cloudMap, uv, 0.0).r, 1.0 - clouds.cover * clouds.shadow, beyond);
    return mix(through, 1.0, clamp((relative.y - clouds.base) / clouds.thickness, 0.0, 1.0));
}
