// What of the grass a view shows: one thread for each place of the tiles around it. What grows in a cell follows from the cell
// alone, so it is the same in every frame, from every camera and at every resolution.
#include "terrain.glsl"
#include "view.glsl"
#include "shared/grass.h"
#ifdef HOLES
layout(binding = COVER_UNIT) uniform MAP_TEXTURE coverMap;
#include "hole.glsl"
#endif

layout(local_size_x = 8, local_size_y = 8) in;

layout(std140, binding = GRASS_BINDING) uniform GrassBlock { GrassFrame grass; };
layout(std430, binding = GRASS_BLADES_BINDING) writeonly buffer Blades { GrassBlade blades[]; };
layout(std430, binding = GRASS_COUNTS_BINDING) buffer Counts { GrassCounts counts; };
layout(std430, binding = GRASS_TILES_BINDING) readonly buffer Tiles { GrassTile tiles[]; };

layout(binding = HEIGHTS_UNIT) uniform MAP_TEXTURE heights;
layout(binding = GROUND_NORMALS_UNIT) uniform MAP_TEXTURE groundNormals;
layout(binding = GRASS_MAP_UNIT) uniform sampler2D grassMap; // io::GrassCover
layout(binding = GRASS_MASK_UNIT) uniform sampler2D footprints; // wraps around
#ifdef TINT
layout(binding = GROUND_TINT_UNIT) uniform sampler2D groundTint;
#endif

const float kFadeFrom = 0.6;  // of a level's end: from there on those that the next one lacks shrink
const float kEndsFrom = 0.75; // of the distance to which grass is drawn
const float kLeastBend = 1e-3;

vec4 unit4(uint bits)
{
    return vec4(bits & 255u, (bits >> 8u) & 255u, (bits >> 16u) & 255u, bits >> 24u) * (1.0 / 255.0);
}

float heightOfTexel(ivec2 texel)
{
#ifdef WINDOWS
    return texelFetch(heights, windowTexel(texel, 0), 0).r;
#else
    return texelFetch(heights, texel, 0).r;
#endif
}

// Of the map's triangles: io::HeightMap::height().
float heightOf(ivec2 texel, vec2 f)
{
    float b = heightOfTexel(texel + ivec2(1, 0)), c = heightOfTexel(texel + ivec2(0, 1));
    if (f.x + f.y <= 1.0) {
        float a = heightOfTexel(texel);
        return a + (b - a) * f.x + (c - a) * f.y;
    }
    float d = heightOfTexel(texel + ivec2(1, 1));
    return d + (c - d) * (1.0 - f.x) + (b - d) * (1.0 - f.y);
}

vec3 normalOf(ivec2 texel, vec2 f)
{
#ifdef WINDOWS
    vec2 flat_ = texelFetch(groundNormals, windowTexel(texel + ivec2(f + 0.5), 0), 0).xy;
#else
    vec2 flat_ = textureLod(groundNormals, (vec2(texel) + f + 0.5) * terrain.texelSize, 0.0).xy;
#endif
    return vec3(flat_.x, sqrt(max(1.0 - dot(flat_, flat_), 0.0025)), flat_.y);
}

bool covered(ivec2 cell)
{
    return texelFetch(footprints, cell & (textureSize(footprints, 0) - 1), 0).r > 0.0;
}

// The clump that a place belongs to: the nearest of one point in each square.
vec4 clumpAt(ivec2 cell, vec2 jitter, float size)
{
    float cells = max(size / GRASS_CELL, 1.0);
    vec2 p = (vec2(cell) + jitter) / cells - 0.5;
    ivec2 low = ivec2(floor(p));
    float nearest = 1e9;
    uint found = 0u;
    for (int i = 0; i < 4; ++i) {
        ivec2 square = low + ivec2(i & 1, i >> 1);
        uvec3 h = grassHash(uvec3(uint(square.x), uint(square.y), 77u));
        vec2 away = vec2(square) + vec2(h.xy >> 16u) * (1.0 / 65536.0) - p - 0.5;
        float d = dot(away, away);
        found = d < nearest ? h.z : found;
        nearest = min(nearest, d);
    }
    return unit4(found);
}

bool inView(vec3 middle, float radius)
{
    float ahead = dot(middle, view.forward);
    if (ahead < -radius) return false;
    vec2 across = abs(vec2(dot(middle, view.right) / dot(view.right, view.right), dot(middle, view.up) / dot(view.up, view.up)));
    vec2 grown = radius * sqrt(1.0 + 1.0 / vec2(dot(view.right, view.right), dot(view.up, view.up)));
    return all(lessThan(across, vec2(max(ahead, 0.0)) + grown));
}

void main()
{
    GrassTile tile = tiles[gl_WorkGroupID.z];
    ivec2 block = (tile.cell >> tile.level) + ivec2(gl_GlobalInvocationID.xy);
    ivec2 cell = grassCell(block, tile.level);
    uvec3 h = grassHash(uvec3(uint(cell.x), uint(cell.y), 1u));
    vec2 jitter = vec2(h.xy >> 16u) * (1.0 / 65536.0);
    vec2 across = (vec2(cell - grass.eyeCell) + jitter) * GRASS_CELL - grass.eyeRest;

    float away = length(across);
    float ends = min(grassFrom(tile.level + 1, grass.full), grass.distance);
    if (away >= ends || away < grassFrom(tile.level, grass.full)) return;

    // Which of the texels around it counts is chance, by how near each is.
    vec2 onMap = ((vec2(cell) + jitter) * GRASS_CELL - grass.mapFrom) / grass.mapTexel;
    ivec2 texel = ivec2(floor(onMap + unit4(h.z).xy));
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(grass.mapSize)))) return;
    vec4 grown = texelFetch(grassMap, texel, 0);
    if (grown.g + grown.b == 0.0) return;
    int kinds = int(grown.r * 255.0 + 0.5);
    float u = (float(h.x & 65535u) + 0.5) * (1.0 / 65536.0);
    int kind = kinds & 15;
    bool grows = u < grown.g * grass.kind[kind].density * grass.density;
    if (!grows) {
        kind = kinds >> 4;
        grows = 1.0 - u < grown.b * grass.kind[kind].density * grass.density;
    }
    if (!grows || covered(cell)) return;
    GrassKind k = grass.kind[kind];

    vec2 onGround = (terrain.eyeRest + across) / terrain.metres;
    ivec2 ground = ivec2(terrain.eyeTexel) + ivec2(floor(onGround));
    if (any(lessThan(ground, ivec2(0))) || any(greaterThanEqual(ground, ivec2(terrain.lastTexel)))) return;
    vec2 within = fract(onGround);
#ifdef HOLES
    if (inHole(coverMap, vec2(ground) + within)) return;
#endif
    float height = heightOf(ground, within);
    vec3 normal = normalOf(ground, within);
    float above = height - grass.water;
    if (normal.y < k.steepness.x || normal.y > k.steepness.y || height < k.altitude.x || height > k.altitude.y || above < k.aboveWater.x ||
        above > k.aboveWater.y)
        return;

    vec4 clump = clumpAt(cell, jitter, k.clumpSize);
    vec4 own = unit4(grassHash(uvec3(h.y, h.z, 9u)).y);
    float tall = mix(k.height.x, k.height.y, mix(own.x, clump.x, k.clump)) * grown.a * (255.0 / 128.0);
    bool lasts = tile.level + 1 < GRASS_LEVELS && cell == grassCell(block >> 1, tile.level + 1);
    float shrink = lasts ? 1.0 : 1.0 - smoothstep(kFadeFrom, 1.0, away / grassFrom(tile.level + 1, grass.full));
    shrink *= 1.0 - smoothstep(kEndsFrom, 1.0, away / grass.distance);
    tall *= mix(0.4, 1.0, shrink);
    float wide = k.width * (0.7 + 0.6 * own.y) * shrink * max(1.0, away / (kFadeFrom * grass.full));
    vec3 root = vec3(across.x, height - grass.eyeHeight, across.y);
    if (shrink <= 0.0 || !inView(root + vec3(0.0, tall * 0.5, 0.0), tall + wide)) return;

    // It leans with its clump and from the wind, and away from what presses it down.
    float turn = (own.z + 0.17) * 6.2831853;
    float lean = clump.z * 6.2831853;
    vec2 bend = (vec2(cos(turn), sin(turn)) * (1.0 - k.clump) + vec2(cos(lean), sin(lean)) * k.clump) * k.bend * (0.5 + own.w) * 1.5;
    vec2 gusts = windPlace(grass.wind, view.eyeHigh.xz, view.eyeLow.xz + across);
    float speed = windSpeed(grass.wind, gusts);
    float sways = windLean(speed) / WIND_MOST_LEAN * k.wind;
    float own_ = windWave(grass.wind.time * (floor(WIND_PERIOD * (1.2 + 0.8 * own.x)) / WIND_PERIOD) + clump.y + own.w * 0.3);
    bend += grass.wind.towards * sways * (1.0 + 0.5 * (own_ - 0.5));
    for (int i = 0; i < grass.pressers; ++i) {
        vec4 presser = grass.presser[i];
        vec3 from = root - presser.xyz;
        float near = 1.0 - smoothstep(0.4, 1.0, length(from) / presser.w);
        bend += normalize(from.xz + vec2(1e-4, 0.0)) * near * grass.pressed[i / 4][i % 4] * 2.4;
    }
    float angle = length(bend);
    bend *= min(angle, 2.6) / max(angle, kLeastBend);
    // Where its tip would lie in what it must not grow through it leans the other way.
    vec2 tip = bend / max(angle, kLeastBend) * (tall * min(angle, 1.0) * 0.6);
    if (covered(cell + ivec2(floor(jitter + tip / GRASS_CELL)))) bend *= -0.35;

    uint place = atomicAdd(counts.taken, 1u);
    if (place >= grass.most) return;
    float shown = tall / max(length(root), 0.1);
    int shape = shown > grass.shapeAngle ? 0 : shown > grass.shapeAngle * 0.3 ? 1 : 2;
    uint index = atomicAdd(counts.shape[shape], 1u);
    if (index >= grass.room) return;
    GrassBlade blade;
    blade.root = root;
    blade.size = packHalf2x16(vec2(tall, wide));
    blade.bend = packHalf2x16(bend);
    blade.look = uint(own.z * 255.0) | uint(kind) << 8u | uint(mix(own.w, clump.w, 0.6) * 255.0) << 16u | uint(smoothstep(0.3, 1.0, away / grass.distance) * 255.0) << 24u;
#ifdef TINT
    vec3 tint = textureLod(groundTint, ((terrain.eyeTexel + onGround) * grass.tintScale), 0.0).rgb;
    blade.ground = packUnorm4x8(vec4(tint, 1.0));
#else
    blade.ground = 0u;
#endif
    blade.slope = packSnorm2x16(normal.xz);
    blades[uint(shape) * grass.room + index] = blade;
}
