// Water of one frame: a level with waves on it. A sum of Gerstner's trochoidal waves (Tessendorf, "Simulating Ocean
// Water", 2001; Finch, GPU Gems ch. 1, 2004), each with the speed that its length has in deep water.
#ifndef SHARED_WATER_H
#define SHARED_WATER_H
#include "shared.h"
SHARED_BEGIN

#define WATER_WAVES 7
#define WATER_CELLS 8        // of a patch, along a side
#define WATER_CELL_RATIO 24.0f // a patch's cells, and those it turns into, are at most that part of their distance

struct WaterWave {
    vec2 towards; float number; float amplitude; // unit, x and z; rad / m; m, half from trough to crest
    float phase;  float push; float length; float slope; // rad, under the eye; m that points go to and fro; m; the steepest
};

struct Water {
    WaterWave wave[WATER_WAVES];
    vec3 colour;      float height;     // radiance of deep water under the irradiance pi; m above the eye
    float extinction; float foam;       // per m; 0..1
    float ripple;     float waves;      // slope of what the waves above leave out, root mean square; m from trough to crest
    vec4 inner;                         // of the plain around the patches, m from the eye: lowest x and z, highest
    vec4 ripples;                       // along and across the wind: the eye in both layers of ripples, in turns of the texture
    vec2 wind;        float finest;     float time; // unit; m, the smallest cells; s, in [0, 4096)
};
SHARED_STRUCT_END(Water, 304)

// Metres that one turn of the texture of ripples takes in its two layers, and the second's direction from the wind's.
#define WATER_RIPPLES_NEAR 3.7f
#define WATER_RIPPLES_WIDE 13.3f
#define WATER_RIPPLES_COSINE 0.8f
#define WATER_RIPPLES_SINE -0.6f

// What a sum of waves does at one place.
struct WaterShape {
    vec3 shift;    // m, of the point that rests there
    vec2 slope;    // of the surface, towards x and z, before it is crowded
    float crowding; // share by which neighbours come together; 1 would fold it over
    float lost;    // mean square slope of waves that are too short to be told apart
};

// `place` is relative to the eye, at rest; `shown` is 1 where the wave is fully there, 0 where it is left out.
SHARED_FUNCTION WaterShape waterAdd(WaterShape s, WaterWave w, vec2 place, float shown)
{
    float angle = dot(w.towards, place) * w.number + w.phase;
    float up = sin(angle) * shown;
    float along = cos(angle) * shown;
    s.shift += vec3(w.towards.x * w.push * along, w.amplitude * up, w.towards.y * w.push * along);
    s.slope += w.towards * (w.slope * along);
    s.crowding += w.push * w.number * up;
    s.lost += 0.5f * w.slope * w.slope * (1.0f - shown * shown);
    return s;
}

// Whether what is `spacing` apart can show a wave of some length.
SHARED_FUNCTION float waterShown(float length_, float spacing)
{
    float x = clamp((length_ / spacing - 2.0f) / 3.0f, 0.0f, 1.0f);
    return x * x * (3.0f - 2.0f * x);
}

SHARED_END
#endif
