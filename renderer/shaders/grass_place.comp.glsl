// What of the plants that grass_find found a view shows, and how they look: one thread for each.
#include "terrain.glsl"
#include "view.glsl"
#include "grass_growth.glsl"
#include "shared/drawn.h"
#ifdef HOLES
layout(binding = COVER_UNIT) uniform MAP_TEXTURE coverMap;
#include "hole.glsl"
#endif
#ifdef HIDDEN
#include "hidden.glsl"
#endif

layout(local_size_x = GRASS_GROUP) in;

layout(std430, binding = GRASS_BLADES_BINDING) writeonly buffer Blades { GrassBlade blades[]; };
layout(std430, binding = GRASS_COUNTS_BINDING) buffer Counts { GrassCounts counts; };
layout(std430, binding = GRASS_FOUND_BINDING) readonly buffer Found { GrassFound found[]; };
#ifdef PLANTS
#include "shared/instance.h"
layout(std430, binding = GRASS_PLANTS_BINDING) writeonly buffer Plants { Instance plants[]; }; // as a view's copies
#endif

layout(binding = HEIGHTS_UNIT) uniform MAP_TEXTURE heights;

const float kFadeFrom = 0.6;  // of a level's end: from there on those that the next one lacks shrink
const float kMostWide = 12.0;
const float kMostSpread = 2.0; // of those that stand for others
const float kEndsFrom = 0.75; // of the distance to which grass is drawn

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

// Where more may grow around the eye than can be drawn, some stay for all, the same ones each time, and stand wider. So it is where still
// more were found in view.
float keptShare()
{
    float most = float(grass.most);
    return min(grass.kept, clamp((most - 3.0 * sqrt(most)) / float(max(counts.found, 1u)), 1e-6, 1.0));
}

// A quarter as many are left at twice as far, so that each must cover four times as much.
float spreadAt(float away)
{
    float times = max(1.0, away / (kFadeFrom * grass.full));
    return min(times * times, kMostWide);
}

#ifdef PLANTS
// A model in a blade's place: as tall, upright, moved by the wind as objects are.
void growPlant(Growth g, GrassKind k, ivec2 cell, vec3 root)
{
    uint index = atomicAdd(counts.plants[k.plant - 1u], 1u);
    if (index >= grass.plantRoom) return;
    float scale = g.tall * k.perHeight, turn = g.own.z * 6.2831853;
    vec2 axis = vec2(cos(turn), sin(turn)) * scale;
    uint phase = uint(g.own.w * 255.0);
    Sway sway = windSway(grass.wind, windPlace(grass.wind, view.eyeHigh.xz, view.eyeLow.xz + root.xz), k.wind, g.tall, phase);
    vec2 top = sway.top + pressedAt(root) * (g.tall * 1.5);
    Instance plant;
    plant.positionHigh = view.eyeHigh;
    plant.objectId = 0xffffffffu;
    plant.positionLow = view.eyeLow + root;
    plant.drawn = phase << DRAWN_PHASE_SHIFT | swayFlutter(sway) << DRAWN_FLUTTER_SHIFT;
    plant.axisX = vec4(axis.x, 0.0, axis.y, top.x);
    plant.axisY = vec4(0.0, scale, 0.0, top.y);
    plant.axisZ = vec4(-axis.y, 0.0, axis.x, k.perHeight);
    plants[(k.plant - 1u) * grass.plantRoom + index] = plant;
}
#endif

void main()
{
    if (gl_GlobalInvocationID.x >= min(counts.found, grass.foundRoom)) return;
    GrassFound f = found[gl_GlobalInvocationID.x];
    ivec2 cell = grass.eyeCell + cellOf(f);
    int kind = kindOf(f), level = levelOf(f);
    uvec3 h = grassHash(uvec3(uint(cell.x), uint(cell.y), 1u));
    vec2 jitter = jitterOf(h);
    vec2 across = (vec2(cellOf(f)) + jitter) * GRASS_CELL - grass.eyeRest;
    float away = length(across), factor = factorOf(f);
    GrassKind k = grass.kind[kind];

    vec2 onGround = (terrain.eyeRest + across) / terrain.metres;
    ivec2 ground = ivec2(terrain.eyeTexel) + ivec2(floor(onGround));
    if (any(lessThan(ground, ivec2(0))) || any(greaterThanEqual(ground, ivec2(terrain.lastTexel)))) return;
    vec2 within = fract(onGround);
#ifdef HOLES
    if (inHole(coverMap, vec2(ground) + within)) return;
#endif
    float height = heightOf(ground, within);
    vec3 root = vec3(across.x, height - grass.eyeHeight, across.y);
    float tallest = max(k.height.x, k.height.y) * factor;
    if (grass.looksAhead != 0 && !inView(root + vec3(0.0, tallest * 0.5, 0.0), tallest)) return;
    vec3 normal = normalOf(ground, within);
    if (!bears(k, height, normal)) return;

    float shrink = lastsOf(f) ? 1.0 : 1.0 - smoothstep(kFadeFrom, 1.0, away / grassFrom(level + 1, grass.full));
    shrink *= 1.0 - smoothstep(kEndsFrom, 1.0, away / grass.distance);
    float kept = keptShare(), chance = (float(h.y & 65535u) + 0.5) * (1.0 / 65536.0);
    float lasting = kept < 1.0 ? 1.0 - smoothstep(kept * 0.8, kept, chance) : 1.0;
    if (shrink <= 0.0) return;
    Growth g = growthAt(k, cell, jitter, h, factor, shrink * max(lasting, 0.01), spreadAt(away) * min(inversesqrt(kept), kMostSpread));
#ifdef HIDDEN
    if (hidden(root + vec3(0.0, g.tall * 0.5, 0.0), g.tall + g.wide)) return;
#endif
    atomicAdd(counts.taken, 1u);
    if (lasting <= 0.0 || atomicAdd(counts.drawn, 1u) >= grass.most) return;
#ifdef PLANTS
    if (k.plant != 0u) {
        growPlant(g, k, cell, root);
        return;
    }
#endif
    bendGrowth(g, k, cell, jitter, root);
    float shown = g.tall / max(length(root), 0.1);
    int shape = shown > grass.shapeAngle ? 0 : shown > grass.shapeAngle * 0.3 ? 1 : 2;
    uint index = atomicAdd(counts.shape[shape], 1u);
    if (index >= grass.room) return;
    blades[uint(shape) * grass.room + index] = bladeOf(g, kind, root, normal, terrain.eyeTexel + onGround);
}
