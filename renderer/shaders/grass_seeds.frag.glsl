// The original's way to find where grass stands: pixels of the ground append seeds, so many as their share of it asks for. What hides the
// ground hides its grass, and which pixel has a seed changes with the view; kept to compare with.
#include "terrain.glsl"
#include "view.glsl"
#include "grass_growth.glsl"

layout(early_fragment_tests) in; // what is not to be seen appends nothing

layout(std430, binding = GRASS_BLADES_BINDING) writeonly buffer Blades { GrassBlade blades[]; };
layout(std430, binding = GRASS_COUNTS_BINDING) buffer Counts { GrassCounts counts; };

layout(location = 0) in vec3 place; // texel x, z; height, m

void main()
{
    vec2 metres = place.xy * terrain.metres;
    vec2 alongX = dFdx(metres), alongY = dFdy(metres);
    float area = abs(alongX.x * alongY.y - alongX.y * alongY.x); // m2 that the pixel shows
    vec2 across = (place.xy - terrain.eyeTexel) * terrain.metres - terrain.eyeRest;
    float away = length(across);
    if (away >= grass.distance) return;
    vec2 inCells = across / GRASS_CELL + grass.eyeRest / GRASS_CELL;
    ivec2 cell = grass.eyeCell + ivec2(floor(inCells));
    vec2 jitter = fract(inCells);
    uvec3 h = grassHash(uvec3(uvec2(gl_FragCoord.xy), floatBitsToUint(across.x)));
    vec2 onMap = ((vec2(cell) + jitter) * GRASS_CELL - grass.mapFrom) / grass.mapTexel;
    ivec2 texel = ivec2(floor(onMap + unit4(h.z).xy));
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(grass.mapSize)))) return;
    vec4 grown = texelFetch(grassMap, texel, 0);
    float cells = area / (GRASS_CELL * GRASS_CELL);
    int kind = kindAt(grown, (float(h.x & 65535u) + 0.5) * (1.0 / 65536.0), grass.density * cells);
    if (kind < 0 || covered(cell)) return;
    GrassKind k = grass.kind[kind];
    vec2 ground = floor(place.xy);
    vec3 normal = normalOf(ivec2(ground), place.xy - ground);
    if (!bears(k, place.z, normal)) return;

    Growth g = growthAt(k, cell, jitter, h, grown.a * (255.0 / 128.0), 1.0 - smoothstep(0.75, 1.0, away / grass.distance), max(1.0, sqrt(cells * 0.5)));
    vec3 root = vec3(across.x, place.z - grass.eyeHeight, across.y);
    bendGrowth(g, k, cell, jitter, root);
    uint index = atomicAdd(counts.taken, 1u);
    if (index >= min(grass.most, grass.room)) return;
    atomicAdd(counts.drawn, 1u);
    blades[index] = bladeOf(g, kind, root, normal, place.xy);
}
