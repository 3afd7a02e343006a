// Culling on the GPU, once per view: which instances are seen, at which level of detail. The first pass decides and
// counts what falls into each bin; once the bins have their places, the second copies the records there.
// Two-pass occlusion after Haar and Aaltonen, "GPU-Driven Rendering Pipelines" (2015): EARLY draws what was seen in the
// last frame, LATE tests everything against the depth of that. KEPT draws what was seen, whoever looks now.
#include "shared/bindings.h"
#include "shared/culling.h"
#include "shared/instance.h"
#include "shared/wind.h"
#include "view.glsl"

layout(local_size_x = 64) in;
layout(std140, binding = PASS_BINDING) uniform CullBlock { CullView cull; };
layout(std430, binding = CULL_RECORDS_BINDING) readonly buffer Records { CullRecord records[]; };
layout(std430, binding = CULL_MODELS_BINDING) readonly buffer Models { CullModel models[]; };
layout(std430, binding = CULL_BINS_BINDING) buffer Bins { CullBin bins[]; };
layout(std430, binding = CULL_DECIDED_BINDING) buffer Decided { uint decided[]; }; // 0: nothing, else share, level + 1, whether it sways

#define DECIDED_SWAYS 0x10000u

#ifdef DECIDE
layout(std430, binding = CULL_SEEN_BINDING) buffer SeenBefore { uint seen[]; }; // 1: drawn by this view's last frame
layout(std430, binding = CULL_COUNTS_BINDING) buffer Counts { CullCounts counts; };
#ifdef LATE
#include "hidden.glsl"

bool hidden(CullRecord r)
{
    return hidden((r.centre - view.eyeHigh) - view.eyeLow, reachOf(r, cull));
}
#endif

void count(uint bin)
{
    atomicAdd(bins[bin].count, 1u);
}

void main()
{
    uint slot = gl_GlobalInvocationID.x;
    if (slot >= cull.count) return;
    CullRecord r = records[slot];
    CullModel m = models[r.model];
    uint decision = 0u;
    bool inside = wanted(r, cull) && insidePlanes(r, cull);
    bool large = inside && largeEnough(r, cull);
#if defined(EARLY) || defined(KEPT)
    bool shown = large && seen[slot] != 0u;
    bool draw = shown;
#elif defined(LATE)
    bool shown = large && !hidden(r);
    bool draw = shown && seen[slot] == 0u;
    seen[slot] = shown ? 1u : 0u;
#else
    bool shown = large;
    bool draw = large;
#endif
#ifndef EARLY
    if (large && !shown) atomicAdd(counts.hidden, 1u);
    if (inside) atomicAdd(counts.inside, 1u);
    if (large) atomicAdd(counts.large, 1u);
#endif
    if (draw) {
        atomicAdd(counts.drawn, 1u);
        LevelChoice choice = chooseLevel(r, m, cull);
        bool fading = choice.share < DRAWN_FADE_STEPS;
        bool swaying = swayShown(r, m, cull) > 0.0;
        decision = uint(choice.share) | uint(choice.level + 1) << 8 | (swaying ? DECIDED_SWAYS : 0u);
        uint kind = binOf(m, r, choice.level, fading, swaying);
        count(kind);
        if (fading) count(kind - BINS_OF_LEVEL);
    }
    decided[slot] = decision;
}
#else
layout(std430, binding = CULL_INSTANCES_BINDING) readonly buffer Instances { uvec4 instances[]; };
layout(std430, binding = CULL_DRAWN_BINDING) writeonly buffer Drawn { uvec4 drawn[]; };

// Adds what the wind does to it to a copy's words.
void bend(inout uvec4 words[INSTANCE_WORDS], float shown)
{
    uint phase = windPhase(words[0].w);
    vec2 place = windPlace(cull.wind, uintBitsToFloat(words[0].xz), uintBitsToFloat(words[1].xz));
    Sway sway = windSway(cull.wind, place, uintBitsToFloat(words[2].w) * shown, uintBitsToFloat(words[3].w), phase);
    words[1].w |= phase << DRAWN_PHASE_SHIFT | swayFlutter(sway) << DRAWN_FLUTTER_SHIFT;
    words[2].w = floatBitsToUint(sway.top.x);
    words[3].w = floatBitsToUint(sway.top.y);
}

void copy(uint slot, uint bin, uint bits, float shown)
{
    uint to = atomicAdd(bins[bin].next, 1u);
    if (to >= bins[bin].end) return;
    uvec4 words[INSTANCE_WORDS];
    for (uint i = 0u; i < INSTANCE_WORDS; ++i)
        words[i] = instances[slot * INSTANCE_WORDS + i];
    words[1].w = (words[1].w & DRAWN_FLAGS_MASK) | bits;
    if (shown >= 0.0) bend(words, shown);
    for (uint i = 0u; i < INSTANCE_WORDS; ++i)
        drawn[to * INSTANCE_WORDS + i] = words[i];
}

void main()
{
    uint slot = gl_GlobalInvocationID.x;
    if (slot >= cull.count || decided[slot] == 0u) return;
    CullRecord r = records[slot];
    CullModel m = models[r.model];
    uint share = decided[slot] & 0xffu;
    uint level = ((decided[slot] >> 8) & 0xffu) - 1u;
    bool swaying = (decided[slot] & DECIDED_SWAYS) != 0u;
    float shown = swaying ? swayShown(r, m, cull) : -1.0; // of what is still
    bool fading = share < uint(DRAWN_FADE_STEPS);
    uint bin = binOf(m, r, int(level), fading, swaying);
    copy(slot, bin, level << DRAWN_LEVEL_SHIFT | (fading ? share : 0u) << DRAWN_FADE_SHIFT, shown);
    if (fading)
        copy(slot, bin - BINS_OF_LEVEL, (level - 1u) << DRAWN_LEVEL_SHIFT | (DRAWN_FADE_OTHERS + share) << DRAWN_FADE_SHIFT,
             shown);
}
#endif
