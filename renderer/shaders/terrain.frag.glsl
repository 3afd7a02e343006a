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

float ramps(float value, vec4 ramp)
{
    vec2 both = clamp(value * ramp.xz + ramp.yw, 0.0, 1.0);
    return both.x * both.y;
}

// `plane`: metres along the texture; `axisU`, `axisV`: where they point in the world; `lod`: log2 of metres a pixel.
Cover cover(int index, vec2 plane, vec3 axisU, vec3 axisV, float tiling, float lod)
{
    TerrainLayer layer = terrain.layer[index];
    vec2 uv = plane * layer.repeats;
    // A second, larger and turned copy breaks the repeats that a single one shows from afar.
    const mat2 turn = mat2(0.7986, 0.6018, -0.6018, 0.7986) * 0.2371;
    float fineLod = lod + layer.lodOffset;
    vec4 fine = textureLod(layerColours, vec3(uv, max(layer.colourLayer, 0.0)), fineLod);
    vec4 broad = textureLod(layerColours, vec3(turn * uv, max(layer.colourLayer, 0.0)), fineLod - 2.08);
    vec4 both = mix(fine, broad, tiling);
    vec2 bend = textureLod(layerNormals, vec3(uv, max(layer.normalLayer, 0.0)), fineLod).xy * 2.0 - 1.0;
    bend = layer.normalLayer < 0.0 ? vec2(0.0) : bend;
    both = layer.colourLayer < 0.0 ? vec4(1.0, 1.0, 1.0, 0.5) : both;
    Cover c;
    c.colour = both.rgb * both.rgb * layer.colour; // stored as square roots
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
        vec2 moved = vec2(slope, place.z) + ragged * terrain.layer[i].ragged;
        float share = ramps(moved.x, terrain.layer[i].slopeRamps) * ramps(moved.y, terrain.layer[i].altitudeRamps);
        share *= share * (3.0 - 2.0 * share);
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
    vec3 axisU = side && fromX ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    vec3 axisV = side ? vec3(0.0, -1.0, 0.0) : vec3(0.0, 0.0, 1.0);


    // Mips between what the longer and the shorter side of a pixel ask for: sharp enough where the ground runs away.
    float longer = max(dot(dx, dx), dot(dy, dy));
    float shorter = max(min(dot(dx, dx), dot(dy, dy)), longer * 0.02);
    float lod = 0.25 * log2(longer * shorter);
    float tiling = clamp(0.22 + (far.a - 0.5) * 0.6 + clamp(lod * 0.12 + 0.6, 0.0, 0.45), 0.0, 0.8);
    Cover a = cover(first, plane, axisU, axisV, tiling, lod);
    Cover b = cover(second, plane, axisU, axisV, tiling, lod);

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
