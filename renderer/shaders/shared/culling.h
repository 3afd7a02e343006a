// What a view sees of the objects, and at which level of detail: one text for the CPU and for the compute shader, so
// that both give the same answer.
#ifndef SHARED_CULLING_H
#define SHARED_CULLING_H
#include "drawn.h"
#include "shared.h"
#include "wind.h"
SHARED_BEGIN

#define CULL_CASTS_SHADOW 1u
#define CULL_MARKER 2u
#define CULL_MIRRORED 4u
#define CULL_BLENDS 8u // drawn back to front, so the CPU keeps it

struct CullRecord { // of an instance, beside its Instance
    vec3 centre; float radius; // m, world; the radius covers the rounding of the centre
    uint model;  uint flags;
    float sway;  uint templateId; // `give` of windReach(); of the scene
};
SHARED_STRUCT_END(CullRecord, 32)

struct CullModel {
    vec4 errors[2]; // by level, of the radius; level 0 has none
    uint levels;    // at least 1
    uint firstBin;
    uint whole;     // 1: never fades, as blended parts cannot
    uint impostor;  // 1: the last level is one
};
SHARED_STRUCT_END(CullModel, 48)

struct CullView {
    vec4 planes[5];  // n, d: inside where dot(n, p) + d >= 0; m, world
    vec3 eye;        float smallestAngle; // radius / distance under which a thing is left out; 0: parallel light
    float errorAngle;  // error / distance that may be seen; 0: parallel light, or no levels
    float errorLength; // m, error that may be seen in parallel light
    float smallestRadius; // m, the same of parallel light
    uint required;     // flags
    uint refused;
    uint count;        // instances
    uint impostors;    // 1: they will do
    float meshLeeway;  // so many times as far may meshes err, but not impostors
    float swayAngle;   // way / distance under which sway is left out; 0: parallel light
    float swayLength;  // m, the same of parallel light
    vec2 windMost;     // windMost(); 0: nothing sways
    Wind wind;
};
SHARED_STRUCT_END(CullView, 192)

struct CullBin { // counted, then given a place
    uint count, first, next, end;
};
SHARED_STRUCT_END(CullBin, 16)

struct CullPart { // of a mesh, drawn with its bin
    uint firstIndex, indexCount, bin, level;
};
SHARED_STRUCT_END(CullPart, 16)

struct CullCounts { // instances: inside the view, of those large enough, of those hidden; drawn
    uint inside, large, hidden, drawn;
    uint copies, unused0, unused1, unused2; // entries of the longest list, with both of what fades
    uint triangles[MOST_LEVELS]; // drawn; std430 alone
};
SHARED_STRUCT_END(CullCounts, 64)

// Levels fade into one another over this share of the distance from which the coarser one will do.
#define LEVEL_FADE 0.05f

SHARED_FUNCTION bool wanted(CullRecord r, CullView v)
{
    return (r.flags & v.required) == v.required && (r.flags & v.refused) == 0u;
}

// Of the sphere that holds it however it sways, m.
SHARED_FUNCTION float reachOf(CullRecord r, CullView v)
{
    return r.radius + windReach(v.windMost, r.sway);
}

SHARED_FUNCTION bool insidePlanes(CullRecord r, CullView v)
{
    float least = 0.0f;
    for (int i = 0; i < 5; ++i)
        least = min(least, v.planes[i].x * r.centre.x + v.planes[i].y * r.centre.y + v.planes[i].z * r.centre.z +
                               v.planes[i].w + reachOf(r, v));
    return least >= 0.0f;
}

SHARED_FUNCTION bool largeEnough(CullRecord r, CullView v)
{
    vec3 d = r.centre - v.eye;
    return r.radius >= v.smallestRadius && r.radius * r.radius >= v.smallestAngle * v.smallestAngle * dot(d, d);
}

SHARED_FUNCTION float levelError(CullModel m, int level)
{
    return m.errors[level / 4][level % 4];
}

SHARED_FUNCTION float leeway(CullModel m, int level, CullView v)
{
    return m.impostor != 0u && level + 1 == int(m.levels) ? 1.0f : v.meshLeeway;
}

struct LevelChoice {
    int level;
    int share; // of DRAWN_FADE_STEPS that it covers; what is left belongs to the finer level
};

SHARED_FUNCTION LevelChoice chooseLevel(CullRecord r, CullModel m, CullView v)
{
    LevelChoice choice;
    choice.level = 0;
    choice.share = DRAWN_FADE_STEPS;
    vec3 d = r.centre - v.eye;
    float seen = v.errorAngle * max(sqrt(dot(d, d)) - r.radius, 0.0f) + v.errorLength;
    int levels = int(m.levels) - (v.impostors != 0u ? 0 : int(m.impostor));
    for (int level = 1; level < levels; ++level)
        if (levelError(m, level) * r.radius <= seen * leeway(m, level, v)) choice.level = level;
    if (choice.level == 0 || v.errorAngle <= 0.0f) return choice;
    float beyond = seen * leeway(m, choice.level, v) / (levelError(m, choice.level) * r.radius) - 1.0f;
    int share = min(int(beyond * (float(DRAWN_FADE_STEPS) / LEVEL_FADE)), DRAWN_FADE_STEPS);
    if (m.whole != 0u) share = share * 2 >= DRAWN_FADE_STEPS ? DRAWN_FADE_STEPS : 0;
    choice.share = share == 0 ? DRAWN_FADE_STEPS : share;
    choice.level -= share == 0 ? 1 : 0;
    return choice;
}

// How much of its sway is shown: nothing where that would be less than is to be seen, all where it is twice as much, so
// that no plant jumps where it begins. Vertices that sway cost more. An impostor is a picture of the model upright, so
// what will be one stands upright before.
SHARED_FUNCTION float swayShown(CullRecord r, CullModel m, CullView v)
{
    float most = windReach(v.windMost, r.sway);
    if (most <= 0.0f) return 0.0f;
    vec3 d = r.centre - v.eye;
    float away = max(sqrt(dot(d, d)) - r.radius, 0.0f);
    float least = v.swayAngle * away + v.swayLength;
    if (most <= least) return 0.0f;
    float shown = min(most / max(least, 1e-6f) - 1.0f, 1.0f);
    if (m.impostor == 0u || v.impostors == 0u) return shown;
    float nearness = (v.errorAngle * away + v.errorLength) / (levelError(m, int(m.levels) - 1) * r.radius);
    return min(shown, clamp((1.0f - nearness) * 4.0f, 0.0f, 1.0f));
}

#define BINS_OF_LEVEL 8u

SHARED_FUNCTION uint binOf(CullModel m, CullRecord r, int level, bool fading, bool swaying)
{
    uint kind = (swaying ? 4u : 0u) + ((r.flags & CULL_MIRRORED) != 0u ? 2u : 0u) + (fading ? 1u : 0u);
    return m.firstBin + uint(level) * BINS_OF_LEVEL + kind;
}

SHARED_END
#endif
