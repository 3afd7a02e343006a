// The ground into the GBuffer: up to eight layers by slope and altitude, of which the two that show most are sampled.
#include "gbuffer_out.glsl"
#include "terrain.glsl"

layout(binding = GROUND_NORMALS_UNIT) uniform sampler2D groundNormals;
layout(binding = LAYER_COLOURS_UNIT) uniform sampler2DArray layerColours;
layout(binding = LAYER_NORMALS_UNIT) uniform sampler2DArray layerNormals;
layout(binding = NOISE_UNIT) uniform sampler2D noiseField;

layout(location = 0) in vec3 place;

struct Cover {
    vec3 colour;
    float height; // of its texture, for sharp borders
    vec3 bend;    // of the normal
    float roughness;
};

// How far a value is inside a range, 0 to 1; the ends of the scale have no border.
float inside(float value, vec2 range, float width, vec2 scale)
{
    float low = range.x <= scale.x ? 1.0 : smoothstep(range.x - width, range.x + width, value);
    float high = range.y >= scale.y ? 1.0 : 1.0 - smoothstep(range.y - width, range.y + width, value);
    return low * high;
}

// `plane`: metres along the texture; `axisU`, `axisV`: where they point in the world.
Cover cover(int index, vec2 plane, vec3 axisU, vec3 axisV, float tiling, vec2 plane_dx, vec2 plane_dy)
{
    TerrainLayer layer = terrain.layer[index];
    vec2 uv = plane * layer.repeats;
    // A second, larger and turned copy breaks the repeats that a single one shows from afar.
    const mat2 turn = mat2(0.7986, 0.6018, -0.6018, 0.7986) * 0.2371;
    vec2 dx = plane_dx * layer.repeats;
    vec2 dy = plane_dy * layer.repeats;
    vec4 fine = textureGrad(layerColours, vec3(uv, max(layer.colourLayer, 0.0)), dx, dy);
    vec4 broad = textureGrad(layerColours, vec3(turn * uv, max(layer.colourLayer, 0.0)), turn * dx, turn * dy);
    vec4 both = mix(fine, broad, tiling);
    vec2 bend = textureGrad(layerNormals, vec3(uv, max(layer.normalLayer, 0.0)), dx, dy).xy * 2.0 - 1.0;
    bend = layer.normalLayer < 0.0 ? vec2(0.0) : bend;
    both = layer.colourLayer < 0.0 ? vec4(1.0, 1.0, 1.0, 0.5) : both;
    Cover c;
    c.colour = both.rgb * layer.colour;
    c.height = both.a;
    c.bend = axisU * bend.x - axisV * bend.y; // +Y of a normal map is up, and v runs down
    c.roughness = layer.roughness;
    return c;
}

void main()
{
    vec2 texel = place.xy;
    vec2 metres = texel * terrain.metres;
    vec2 flat_ = texture(groundNormals, (texel + 0.5) * terrain.texelSize).xy;
    vec3 n = vec3(flat_.x, sqrt(max(1.0 - dot(flat_, flat_), 0.0025)), flat_.y);

    vec4 near = texture(noiseField, metres * (1.0 / 47.0));
    vec4 far = texture(noiseField, metres.yx * (1.0 / 613.0));
    float ragged = (near.b - 0.5) * 1.1 + (far.b - 0.5) * 1.3;
    float slope = degrees(acos(clamp(n.y, 0.0, 1.0)));

    // Later layers lie over earlier ones; of what then shows, keep the two largest shares.
    float shown = 1.0;
    int first = 0;
    int second = 0;
    float firstShare = 0.0;
    float secondShare = 0.0;
    for (int i = terrain.layers - 1; i >= 0; --i) {
        vec4 rules = terrain.layer[i].rules;
        vec2 widths = terrain.layer[i].widths;
        float share = inside(slope + ragged * widths.x * 1.6, rules.xy, widths.x, vec2(0.0, 90.0)) *
                      inside(place.z + ragged * widths.y * 2.0, rules.zw, widths.y, vec2(-1e5, 1e5));
        share *= shown;
        shown -= share;
        bool top = share > firstShare;
        bool next = share > secondShare;
        second = top ? first : next ? i : second;
        secondShare = top ? firstShare : next ? share : secondShare;
        first = top ? i : first;
        firstShare = top ? share : firstShare;
    }

    // Cliffs are projected from the side that faces them most; noise breaks the line where sides meet.
    float steep = max(abs(n.x), abs(n.z)) + (near.a - 0.5) * 0.25;
    bool side = steep > n.y * 1.15;
    bool fromX = abs(n.x) > abs(n.z) + (near.b - 0.5) * 0.3;
    vec3 world = vec3(metres.x, place.z, metres.y);
    vec3 dx = dFdx(world);
    vec3 dy = dFdy(world);
    vec2 plane = side ? (fromX ? vec2(world.z, -world.y) : vec2(world.x, -world.y)) : world.xz;
    vec2 plane_dx = side ? (fromX ? vec2(dx.z, -dx.y) : vec2(dx.x, -dx.y)) : dx.xz;
    vec2 plane_dy = side ? (fromX ? vec2(dy.z, -dy.y) : vec2(dy.x, -dy.y)) : dy.xz;
    vec3 axisU = side && fromX ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    vec3 axisV = side ? vec3(0.0, -1.0, 0.0) : vec3(0.0, 0.0, 1.0);

    float tiling = clamp(0.22 + (far.a - 0.5) * 0.6 + smoothstep(0.02, 0.25, length(dx) + length(dy)) * 0.4, 0.0, 0.8);
    Cover a = cover(first, plane, axisU, axisV, tiling, plane_dx, plane_dy);
    Cover b = cover(second, plane, axisU, axisV, tiling, plane_dx, plane_dy);

    // The higher texel wins inside the transition.
    float share = secondShare / max(firstShare + secondShare, 1e-4);
    float lift = a.height * (1.0 - share) - b.height * share;
    share = clamp((share * 2.0 - 1.0 - lift * 0.8) * 1.8 * 0.5 + 0.5, 0.0, 1.0) * step(1e-3, share);

    vec3 colour = mix(a.colour, b.colour, share);
    float patches = 0.82 + 0.36 * mix(far.b, near.b, 0.35); // large, faint patches, as ground has
    vec3 normal = normalize(n + mix(a.bend, b.bend, share) * 0.9);
    writeSurface(colour * patches, 1.0, normal, mix(a.roughness, b.roughness, share), 0.0, SURFACE_GROUND, 0.0);
    outId = 0xffffffffu;
}
