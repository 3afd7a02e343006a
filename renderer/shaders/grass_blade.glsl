// A blade: a strip along an arc, whose length is the blade's however it bends. SEGMENTS along it; needs view.glsl.
#include "octahedron.glsl"
#include "shared/grass.h"

layout(std140, binding = GRASS_BINDING) uniform GrassBlock { GrassFrame grass; };

layout(location = 0) out vec4 surface; // square roots of the colour; share of the sky that is not hidden by those around it
#if SEGMENTS == 1
layout(location = 1) flat out vec2 octahedralNormal; // it is seen too small for more than one
#else
layout(location = 1) out vec3 normal;
#endif

const float kStraight = 1e-3; // rad

// Vertex `index` of the strip; `packed_`: bend, look, ground and slope of GrassBlade.
void bladeVertex(int index, vec3 root, uint sizes, uvec4 packed_)
{
    int row = index >> 1;
    float t = float(row) * (1.0 / float(SEGMENTS));
    float side = row == SEGMENTS ? 0.0 : float(index & 1) * 2.0 - 1.0;
    vec2 size = unpackHalf2x16(sizes);
    vec2 bend = unpackHalf2x16(packed_.x);
    vec4 look = unpackUnorm4x8(packed_.y);
    GrassKind k = grass.kind[(packed_.y >> 8u) & 15u];

    float angle = max(length(bend), kStraight);
    vec2 towards = bend / angle;
#if SEGMENTS == 1
    float along = t * (1.0 - cos(angle)) / angle, up = t * sin(angle) / angle;
    float stretch = 1.0 / max(length(vec2((1.0 - cos(angle)) / angle, sin(angle) / angle)), 0.2);
    along *= stretch, up *= stretch;
#else
    float along = (1.0 - cos(angle * t)) / angle, up = sin(angle * t) / angle;
#endif
    vec3 spine = vec3(towards.x * along, up, towards.y * along) * size.x;
    vec3 tangent = vec3(towards.x * sin(angle * t), cos(angle * t), towards.y * sin(angle * t));

    // Turned some of the way towards the eye, so that no blade is seen from its edge.
    float facing = look.x * 6.2831853;
    vec3 across = vec3(cos(facing), 0.0, sin(facing));
    vec3 seen = normalize(cross(tangent, root + spine));
    across = normalize(across + seen * (dot(across, seen) < 0.0 ? -0.9 : 0.9));
    float width = size.y * (1.0 - t * t * 0.75) * 0.5;
    vec3 point = root + spine + across * (side * width);

    vec3 flat_ = cross(across, tangent);
    flat_ *= dot(flat_, point) > 0.0 ? -1.0 : 1.0;
    vec2 slope = unpackSnorm2x16(packed_.w);
    vec3 ground = vec3(slope.x, sqrt(max(1.0 - dot(slope, slope), 0.0025)), slope.y);
    float far = look.w;
    vec3 rounded = normalize(mix(normalize(flat_ + across * (side * 0.5)), ground, 0.45 + 0.5 * far));
#if SEGMENTS == 1
    octahedralNormal = octahedral(rounded);
#else
    normal = rounded;
#endif

    vec3 stored = unpackUnorm4x8(packed_.z).rgb;
    vec3 tint = stored * stored;
    float tone = (look.z - 0.5) * 2.0 * k.variety;
    vec3 own = mix(k.rootColour, k.tipColour, t) * (1.0 + 0.5 * tone);
    own = mix(own, own * vec3(1.35, 1.12, 0.7), max(tone, 0.0));
    float share = mix(k.groundColour * (1.0 - t), 1.0, far);
    surface = vec4(sqrt(mix(own, tint * (0.75 + 0.5 * t), share)), mix(0.35 + 0.65 * t, 0.85, far));
    gl_Position = view.clipFromRelative * vec4(point, 1.0);
}
