// The ground into the GBuffer. Of its layers the two that show most are sampled.
#include "gbuffer_out.glsl"
#include "terrain.glsl"
#include "terrain_layers.glsl"
#ifdef HOLES
#include "hole.glsl"
#endif

layout(binding = LAYER_COLOURS_UNIT) uniform sampler2DArray layerColours;
layout(binding = LAYER_NORMALS_UNIT) uniform sampler2DArray layerNormals;

#ifdef FROM_ABOVE
layout(binding = HEIGHTS_UNIT) uniform MAP_TEXTURE heights;
#endif

layout(location = 0) in vec3 place;

struct Cover {
    vec3 colour;
    float height; // of its texture, for sharp borders
    vec3 bend;    // of the normal
    float roughness;
};

// `plane`: metres along the texture; `axisU`, `axisV`: where they point in the world. All of a quad of pixels ask
// for the same layer and plane, so that mips can come from their differences.
Cover cover(int index, vec2 plane, vec3 axisU, vec3 axisV, float tiling, float detail, const bool foremost)
{
    TerrainLayer layer = terrain.layer[index];
    vec2 uv = plane * layer.repeats;
    // A second, larger and turned copy breaks the repeats that a single one shows from afar.
    const mat2 turn = mat2(0.7986, 0.6018, -0.6018, 0.7986) * 0.2371;
    vec4 fine = texture(layerColours, vec3(uv, max(layer.colourLayer, 0.0)));
    vec4 both = fine;
    if (foremost) both = mix(fine, texture(layerColours, vec3(turn * uv, max(layer.colourLayer, 0.0))), tiling);
    vec3 bumps = texture(layerNormals, vec3(uv, max(layer.normalLayer, 0.0))).xyz;
    bumps = layer.normalLayer < 0.0 ? vec3(0.5, 0.5, 1.0) : bumps;
    vec2 bend = bumps.xy * 2.0 - 1.0;
#ifdef DETAIL
    // Nearer than texels are a smaller copy goes on: its heights shade, and bend.
    if (foremost && detail > 0.0) {
        const mat2 smaller = mat2(0.7648, -0.6442, 0.6442, 0.7648) * 6.31;
        both.rgb *= 1.0 + (texture(layerColours, vec3(smaller * uv, max(layer.colourLayer, 0.0))).a - 0.45) * detail * 0.55;
        if (layer.normalLayer >= 0.0) bend += (texture(layerNormals, vec3(smaller * uv, layer.normalLayer)).xy * 2.0 - 1.0) * detail * 0.6;
    }
#endif
    both = layer.colourLayer < 0.0 ? vec4(1.0, 1.0, 1.0, 0.5) : both;
    Cover c;
    c.colour = both.rgb * both.rgb * layer.colour; // stored as square roots
    c.height = both.a;
    c.bend = axisU * bend.x - axisV * bend.y; // +Y of a normal map is up, and v runs down
    c.roughness = layer.roughness * bumps.z;
    return c;
}

void main()
{
#ifdef FROM_ABOVE
    vec2 texel = clamp(place.xy, vec2(0.0), terrain.lastTexel);
#ifdef WINDOWS
    float level = windowLevel(texel);
    float height = texelFetch(heights, windowTexel(ivec2(texel * exp2(-level)), int(level)), 0).r;
#else
    float height = texelFetch(heights, ivec2(texel), 0).r;
#endif
#else
    vec2 texel = place.xy;
    float height = place.z;
#endif
    vec2 metres = texel * terrain.metres;
    vec3 n = groundNormal(texel);
    GroundNoise noise = groundNoise(metres);
    vec4 near = noise.near, far = noise.far;
    Choice choice = layersAt(texel, height, n, noise);

    // Cliffs are projected from the side that faces them most; noise breaks the line where sides meet.
    float steep = max(abs(n.x), abs(n.z)) + (near.a - 0.5) * 0.25 - n.y * 1.15;
    float turned = abs(n.x) - abs(n.z) + (near.b - 0.5) * 0.3;
    vec3 facing = quadShared(vec3(steep, turned, 0.0));
    bool side = facing.x > 0.0;
    bool fromX = facing.y > 0.0;
    vec3 world = vec3(metres.x, height, metres.y);
    vec2 plane = side ? (fromX ? vec2(world.z, -world.y) : vec2(world.x, -world.y)) : world.xz;
    vec3 axisU = side && fromX ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    vec3 axisV = side ? vec3(0.0, -1.0, 0.0) : vec3(0.0, 0.0, 1.0);

    float away = log2(length(dFdx(metres)) + length(dFdy(metres))); // of metres a pixel
    float tiling = clamp(0.22 + (far.a - 0.5) * 0.6 + clamp(away * 0.12 + 0.5, 0.0, 0.45), 0.0, 0.8);
    float detail = clamp(-6.0 - away, 0.0, 1.0); // from 1.5 cm a pixel on
    Cover a = cover(choice.first, plane, axisU, axisV, tiling, detail, true);
    Cover b = cover(choice.second, plane, axisU, axisV, tiling, detail, false);

    // The higher texel wins inside the transition.
    float share = choice.secondShare / max(choice.firstShare + choice.secondShare, 1e-4);
    float lift = a.height * (1.0 - share) - b.height * share;
    share = clamp((share * 2.0 - 1.0 - lift * 0.8) * 1.8 * 0.5 + 0.5, 0.0, 1.0) * step(1e-3, share);

    vec3 colour = mix(a.colour, b.colour, share);
    float patches = 0.82 + 0.36 * mix(far.b, near.b, 0.35); // large, faint patches, as ground has
    vec3 normal = normalize(n + mix(a.bend, b.bend, share) * 0.9);
    writeSurface(sqrt(colour * patches), 1.0, normal, mix(a.roughness, b.roughness, share), 0.0, SURFACE_GROUND, 0.0);
    outId = 0xffffffffu;
#ifdef HOLES
    if (inHole(coverMap, texel)) discard; // at the end: derivatives above are of whole quads
#endif
}
