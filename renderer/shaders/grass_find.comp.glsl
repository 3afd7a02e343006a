// Which cells of the tiles around an eye hold a plant: a group of threads for each tile. What grows in a cell follows from the cell alone, so it
// is the same in every frame, from every camera and at every resolution. How it looks is left to grass_place, which only goes through
// those that were found: on a machine whose threads go together, the long way of a few would be the way of all.
#include "terrain.glsl"
#include "view.glsl"
#include "grass_growth.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, binding = GRASS_COUNTS_BINDING) buffer Counts { GrassCounts counts; };
layout(std430, binding = GRASS_TILES_BINDING) readonly buffer Tiles { GrassTile tiles[]; };
layout(std430, binding = GRASS_FOUND_BINDING) writeonly buffer Found { GrassFound found[]; };

const int kPlaces = GRASS_TILE / 8; // along each side, of a thread: a thread costs more than a place

void look(GrassTile tile, ivec2 place)
{
    ivec2 block = (tile.cell >> tile.level) + place;
    ivec2 cell = grassCell(block, tile.level);
    uvec3 h = grassHash(uvec3(uint(cell.x), uint(cell.y), 1u));
    vec2 jitter = jitterOf(h);
    ivec2 fromEye = cell - grass.eyeCell;
    vec2 across = (vec2(fromEye) + jitter) * GRASS_CELL - grass.eyeRest;
    float away = length(across);
    float ends = min(grassFrom(tile.level + 1, grass.full), grass.distance);
    if (away >= ends || away < grassFrom(tile.level, grass.full)) return;

    // Which of the texels around it counts is chance, by how near each is.
    vec2 onMap = ((vec2(cell) + jitter) * GRASS_CELL - grass.mapFrom) / grass.mapTexel;
    ivec2 texel = ivec2(floor(onMap + unit4(h.z).xy));
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(grass.mapSize)))) return;
    vec4 grown = texelFetch(grassMap, texel, 0);
    int kind = kindAt(grown, (float(h.x & 65535u) + 0.5) * (1.0 / 65536.0), grass.density);
    if (kind < 0 || covered(cell)) return;
    vec2 ground = unpackHalf2x16(tile.heights);
    float tallest = max(grass.kind[kind].height.x, grass.kind[kind].height.y) * grown.a * (255.0 / 128.0);
    if (grass.looksAhead != 0 && !inView(vec3(across.x, (ground.x + ground.y + tallest) * 0.5, across.y), (ground.y - ground.x) * 0.5 + tallest)) return;

    uint index = atomicAdd(counts.found, 1u);
    if (index >= grass.foundRoom) return;
    if (index % GRASS_GROUP == 0u) atomicAdd(counts.groups, 1u);
    bool lasts = tile.level + 1 < GRASS_LEVELS && cell == grassCell(block >> 1, tile.level + 1);
    found[index] = packFound(fromEye, kind, tile.level, lasts, grown.a);
}

void main()
{
    GrassTile tile = tiles[gl_WorkGroupID.x];
    for (int i = 0; i < kPlaces * kPlaces; ++i)
        look(tile, ivec2(gl_LocalInvocationID.xy) + ivec2(i % kPlaces, i / kPlaces) * 8);
}
