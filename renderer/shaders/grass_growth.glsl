// How a plant looks that grows at a place: the same for those of the grid and for the original's seeds. Needs terrain.glsl and view.glsl.
#include "shared/grass.h"

layout(std140, binding = GRASS_BINDING) uniform GrassBlock { GrassFrame grass; };
layout(binding = GROUND_NORMALS_UNIT) uniform MAP_TEXTURE groundNormals;
layout(binding = GRASS_MAP_UNIT) uniform sampler2D grassMap; // io::GrassCover
layout(binding = GRASS_MASK_UNIT) uniform sampler2D footprints; // wraps around
layout(binding = GROUND_TINT_UNIT) uniform sampler2D groundTint; // GroundTint

const float kLeastBend = 1e-3;

vec4 unit4(uint bits)
{
    return vec4(bits & 255u, (bits >> 8u) & 255u, (bits >> 16u) & 255u, bits >> 24u) * (1.0 / 255.0);
}

vec2 jitterOf(uvec3 h) // of the cell; shares of it
{
    return vec2(h.xy >> 16u) * (1.0 / 65536.0);
}

GrassFound packFound(ivec2 cell, int kind, int level, bool lasts, float factor)
{
    GrassFound f;
    f.cell = uint(cell.x) & 65535u | uint(cell.y) << 16u;
    f.what = uint(kind) | uint(level) << 4u | (lasts ? 128u : 0u) | uint(factor * 255.0 + 0.5) << 8u;
    return f;
}

ivec2 cellOf(GrassFound f)
{
    return ivec2(int(f.cell << 16u), int(f.cell)) >> 16;
}

int kindOf(GrassFound f)
{
    return int(f.what & 15u);
}

int levelOf(GrassFound f)
{
    return int(f.what >> 4u & 7u);
}

bool lastsOf(GrassFound f)
{
    return (f.what & 128u) != 0u;
}

float factorOf(GrassFound f) // of the kind's height
{
    return float(f.what >> 8u) * (1.0 / 128.0);
}

// Of a ball, from the eye.
bool inView(vec3 middle, float radius)
{
    float ahead = dot(middle, view.forward);
    if (ahead < -radius) return false;
    vec2 across = abs(vec2(dot(middle, view.right) / dot(view.right, view.right), dot(middle, view.up) / dot(view.up, view.up)));
    vec2 grown = radius * sqrt(1.0 + 1.0 / vec2(dot(view.right, view.right), dot(view.up, view.up)));
    return all(lessThan(across, vec2(max(ahead, 0.0)) + grown));
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

// Which kind grows at a place of the map by the chance `u`; -1: none. `chance` is what kinds' densities are multiplied by.
int kindAt(vec4 grown, float u, float chance)
{
    int kinds = int(grown.r * 255.0 + 0.5);
    if (u < grown.g * grass.kind[kinds & 15].density * chance) return kinds & 15;
    if (1.0 - u < grown.b * grass.kind[kinds >> 4].density * chance) return kinds >> 4;
    return -1;
}

bool bears(GrassKind k, float height, vec3 normal)
{
    float above = height - grass.water;
    return normal.y >= k.steepness.x && normal.y <= k.steepness.y && height >= k.altitude.x && height <= k.altitude.y &&
           above >= k.aboveWater.x && above <= k.aboveWater.y;
}

struct Growth {
    float tall, wide; // m
    vec2 bend;        // rad
    vec4 own, clump;  // chances
};

// `h`: of the cell; `factor`: of the kind's height; `shrink`: 1 a whole plant; `spread`: how much wider it stands for others.
Growth growthAt(GrassKind k, ivec2 cell, vec2 jitter, uvec3 h, float factor, float shrink, float spread)
{
    Growth g;
    g.clump = clumpAt(cell, jitter, k.clumpSize);
    g.own = unit4(grassHash(uvec3(h.y, h.z, 9u)).y);
    g.tall = mix(k.height.x, k.height.y, mix(g.own.x, g.clump.x, k.clump)) * factor * mix(0.4, 1.0, shrink);
    g.wide = k.width * (0.7 + 0.6 * g.own.y) * shrink * spread;
    g.bend = vec2(0.0);
    return g;
}

// Which way and how much it is pressed aside there.
vec2 pressedAt(vec3 root)
{
    vec2 pressed = vec2(0.0);
    for (int i = 0; i < grass.pressers; ++i) {
        vec3 from = root - grass.presser[i].xyz;
        pressed += normalize(from.xz + vec2(1e-4, 0.0)) * (1.0 - smoothstep(0.4, 1.0, length(from) / grass.presser[i].w)) * grass.pressed[i / 4][i % 4];
    }
    return pressed;
}

// It leans with its clump and from the wind, and away from what presses it down.
void bendGrowth(inout Growth g, GrassKind k, ivec2 cell, vec2 jitter, vec3 root)
{
    float turn = (g.own.z + 0.17) * 6.2831853;
    float lean = g.clump.z * 6.2831853;
    vec2 bend = (vec2(cos(turn), sin(turn)) * (1.0 - k.clump) + vec2(cos(lean), sin(lean)) * k.clump) * k.bend * (0.5 + g.own.w) * 1.5;
    vec2 gusts = windPlace(grass.wind, view.eyeHigh.xz, view.eyeLow.xz + root.xz);
    float speed = windSpeed(grass.wind, gusts);
    float sways = windLean(speed) / WIND_MOST_LEAN * k.wind;
    float wave = windWave(grass.wind.time * (floor(WIND_PERIOD * (1.2 + 0.8 * g.own.x)) / WIND_PERIOD) + g.clump.y + g.own.w * 0.3);
    bend += grass.wind.towards * sways * (1.0 + 0.5 * (wave - 0.5));
    bend += pressedAt(root) * 2.4;
    float angle = length(bend);
    bend *= min(angle, 2.6) / max(angle, kLeastBend);
    // Where its tip would lie in what it must not grow through it leans the other way.
    vec2 tip = bend / max(angle, kLeastBend) * (g.tall * min(angle, 1.0) * 0.6);
    if (covered(cell + ivec2(floor(jitter + tip / GRASS_CELL)))) bend *= -0.35;
    g.bend = bend;
}

// `onGround`: texels of the ground, for its colour.
GrassBlade bladeOf(Growth g, int kind, vec3 root, vec3 normal, vec2 onGround)
{
    GrassBlade blade;
    blade.root = root;
    blade.size = packHalf2x16(vec2(g.tall, g.wide));
    blade.bend = packHalf2x16(g.bend);
    blade.look = uint(g.own.z * 255.0) | uint(kind) << 8u | uint(mix(g.own.w, g.clump.w, 0.6) * 255.0) << 16u |
                 uint(smoothstep(0.3, 1.0, length(root.xz) / grass.distance) * 255.0) << 24u;
    blade.ground = packUnorm4x8(vec4(textureLod(groundTint, onGround * grass.tintScale, 0.0).rgb, 1.0));
    blade.slope = packSnorm2x16(normal.xz);
    return blade;
}
