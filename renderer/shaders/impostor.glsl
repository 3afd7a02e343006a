// What a texel of an impostor holds. All but the depth is weighed by coverage, so that filtering mixes in nothing from
// where nothing is.
#include "shared/impostor.h"

const float kZero = 128.0 / 255.0; // of values with a sign

// Unit vectors on a disc, Lambert's azimuthal projection around +Y: no seam but at -Y, so it can be filtered.
vec2 onDisc(vec3 n)
{
    return n.xz * inversesqrt(max(2.0 + 2.0 * n.y, 1e-4));
}

vec3 fromDisc(vec2 p)
{
    float f = min(dot(p, p), 1.0);
    return vec3(p.x, 0.0, p.y) * (2.0 * sqrt(1.0 - f)) + vec3(0.0, 1.0 - 2.0 * f, 0.0);
}

struct ImpostorTexel {
    vec3 root;    // of the base colour
    float cover;
    vec3 normal;  // of the model
    float depth;  // towards the eye from the centre, of the radius
    float leaf;   // share of leaves
};

struct ImpostorStore {
    vec4 colour, surface;
};

ImpostorStore stored(ImpostorTexel t)
{
    ImpostorStore s;
    s.colour = vec4(t.root * t.cover, t.cover);
    s.surface = vec4(onDisc(t.normal) * t.cover, t.depth, 0.0) * (127.0 / 255.0) + kZero;
    s.surface.w = t.leaf * t.cover;
    return s;
}

float storedDepth(vec4 surface)
{
    return (surface.z - kZero) * (255.0 / 127.0);
}

ImpostorTexel loaded(vec4 colour, vec4 surface)
{
    float scale = 1.0 / max(colour.a, 1e-3);
    ImpostorTexel t;
    t.cover = colour.a;
    t.root = colour.rgb * scale;
    t.normal = fromDisc((surface.xy - kZero) * (255.0 / 127.0 * scale));
    t.depth = storedDepth(surface);
    t.leaf = surface.w * scale;
    return t;
}
