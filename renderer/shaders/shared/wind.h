// The wind: one field of gusts for all that it moves, and what it does to a plant. One text for C++ and GLSL.
// After Sousa, "Vegetation Procedural Animation and Shading in Crysis" (GPU Gems 3, ch. 16, 2007): a bend of the whole
// plant that keeps its length, a smaller one of its leaves, and smoothed triangle waves in place of sines.
#ifndef SHARED_WIND_H
#define SHARED_WIND_H
#include "shared.h"
SHARED_BEGIN

#define WIND_PERIOD 1024.0f      // s, after which time begins again: all frequencies are whole multiples of its inverse
#define WIND_GUST_PERIOD 4096.0f // m, likewise of the field of gusts
#define WIND_MOST_LEAN 0.25f     // m that the top of a plant gives way for each metre of its height
#define WIND_FLUTTER 0.02f       // m that leaves do for each metre of the plant's height
#define WIND_MOST_FLUTTER 0.06f  // m, of any
#define WIND_MOST_REACH 0.3f     // windReach() of a metre in any wind

struct Wind { // of one frame
    vec2 towards; float speed; float gustiness; // unit, x and z; m/s, 0: nothing sways; 0..1
    vec2 anchor;  vec2 origin;                  // near the eye, m: in the world, and in the field along and across
    float time;   float unused0; float unused1; float unused2; // s, in [0, WIND_PERIOD)
};
SHARED_STRUCT_END(Wind, 48)

// 0..1..0 over a whole number.
SHARED_FUNCTION float windWave(float x)
{
    float t = abs(fract(x) * 2.0f - 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

// From the world into the field, which the mean wind carries along (Taylor's frozen turbulence). The position is the sum
// of two floats.
SHARED_FUNCTION vec2 windPlace(Wind w, vec2 high, vec2 low)
{
    vec2 p = (high - w.anchor) + low;
    return w.origin + vec2(dot(p, w.towards), p.y * w.towards.x - p.x * w.towards.y);
}

// 0 lull, 1 gust. Fronts lie across the wind, about 140, 60 and 25 m apart, and the coarse ones bend the finer.
SHARED_FUNCTION float windGust(vec2 place)
{
    vec2 q = place * (1.0f / WIND_GUST_PERIOD);
    float broad = windWave(q.x * 29.0f + q.y * 11.0f);
    float middle = windWave(q.x * 67.0f - q.y * 43.0f + 0.4f * broad);
    float fine = windWave(q.x * 163.0f + q.y * 131.0f + 0.5f * middle);
    return 0.5f * broad + 0.3f * middle + 0.2f * fine;
}

SHARED_FUNCTION float windSpeed(Wind w, vec2 place)
{
    return w.speed * (1.0f + w.gustiness * (2.0f * windGust(place) - 1.0f));
}

// Of a plant's top, m for each metre of height: the wind's pressure, until the plant turns its leaves out of it.
SHARED_FUNCTION float windLean(float speed)
{
    float pressure = speed * speed;
    return WIND_MOST_LEAN * pressure / (pressure + 200.0f);
}

// 0..1, of leaves
SHARED_FUNCTION float windFlutter(float speed)
{
    return speed / (speed + 5.0f);
}

// The most that a wind does: the lean of a top for each metre of height, and windFlutter().
SHARED_FUNCTION vec2 windMost(Wind w)
{
    float fastest = w.speed * (1.0f + w.gustiness);
    return vec2(windLean(fastest) * 1.06f, windFlutter(fastest));
}

// How far at most any point of a plant moves, m; `give` is its height, m, by how freely it sways.
SHARED_FUNCTION float windReach(vec2 most, float give)
{
    return give * most.x + min(give * WIND_FLUTTER, WIND_MOST_FLUTTER) * most.y;
}

// Unlike that of others: a part of a turn, in 256ths. A step of Jarzynski and Olano, "Hash Functions for GPU Rendering"
// (2020).
SHARED_FUNCTION uint windPhase(uint object)
{
    uint h = object * 747796405u + 2891336453u;
    h = ((h >> ((h >> 28u) + 4u)) ^ h) * 277803737u;
    return ((h >> 22u) ^ h) & 255u;
}

struct Sway { // of one plant in one frame
    vec2 top;      // m that its top gives way, x and z
    float flutter; // m that leaves do
};

// `amount` is 0 of a rock, 1 of a plant that gives way freely; `height` in m. Tall trees swing slowly (Moore and
// Maguire, "Natural sway frequencies and damping ratios of trees", 2004).
SHARED_FUNCTION Sway windSway(Wind w, vec2 place, float amount, float height, uint phase)
{
    float speed = windSpeed(w, place);
    float tall = max(height, 0.1f);
    float swings = floor(1.3f / sqrt(tall) * WIND_PERIOD);
    float own = w.time * (1.0f / WIND_PERIOD);
    float part = float(phase) * (1.0f / 256.0f);
    float slow = windWave(own * swings + part);
    float quick = windWave(own * floor(swings * 1.61f) + 3.0f * part);
    float side = windWave(own * floor(swings * 0.83f) + 5.0f * part + 0.25f);
    float lean = windLean(speed) * amount * height;
    float along = lean * (0.6f + 0.25f * slow + 0.15f * quick);
    float across = lean * 0.3f * (2.0f * side - 1.0f);
    Sway sway;
    sway.top = w.towards * along + vec2(-w.towards.y, w.towards.x) * across;
    sway.flutter = min(WIND_FLUTTER * height, WIND_MOST_FLUTTER) * amount * windFlutter(speed);
    return sway;
}

SHARED_FUNCTION uint swayFlutter(Sway sway) // in 255ths of the most
{
    return uint(clamp(sway.flutter * (255.0f / WIND_MOST_FLUTTER) + 0.5f, 0.0f, 255.0f));
}

// Where a point of a plant goes, both from its root, m. `share`: its height, of the plant's. Its distance from the root
// stays.
SHARED_FUNCTION vec3 windBent(vec3 point, vec2 top, float share)
{
    float up = max(share, 0.0f);
    vec3 moved = point + vec3(top.x, 0.0f, top.y) * (up * up);
    return moved * sqrt(dot(point, point) / max(dot(moved, moved), 1e-12f));
}

// What leaves add to that: a wave that runs through the crown, at most 1 long. `point` in m, any axes; `time` as of
// Wind.
SHARED_FUNCTION vec3 windLeaf(vec3 point, float share, float time, float phase)
{
    float along = dot(point, vec3(0.31f, 0.23f, 0.37f)) + phase;
    float a = windWave(time * (1403.0f / WIND_PERIOD) + along) * 2.0f - 1.0f;
    float b = windWave(time * (2263.0f / WIND_PERIOD) + along * 1.7f) * 2.0f - 1.0f;
    return vec3(a, b, -a) * (0.577f * clamp(share * 4.0f, 0.0f, 1.0f));
}

SHARED_END
#endif
