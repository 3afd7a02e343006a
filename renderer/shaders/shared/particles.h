// Particles without memory: where one is follows from when it was born, so the same time gives the same picture. One text for
// the vertices and for the order in which they are drawn.
#ifndef SHARED_PARTICLES_H
#define SHARED_PARTICLES_H
#include "shared.h"
SHARED_BEGIN

#define MOST_PARTICLE_SOURCES 128 // in view at once
#define PARTICLE_FIRE 1u
#define PARTICLE_SMOKE 2u
#define PARTICLE_DUST 3u

struct ParticleSource {
    vec3 origin; float size;    // m from the eye; m across, of a grown one
    vec3 start;  float spread;  // m/s; m around the origin
    vec3 drift;  float settle;  // m/s that it ends with, after a gust's share; s, after which two thirds of the way to that are gone
    vec3 colour; float life;    // factor; s
    float gust;  float swirl;   // share by which the wind differs at each birth; m/s
    float time;  uint kind;     // s, as births count them
};
SHARED_STRUCT_END(ParticleSource, 80)

struct Particle { // one record for each that is drawn
    uint source; uint seed; // the seed counts births
    float age;              // s
};

// PCG's output step over a line of seeds (Jarzynski and Olano, "Hash Functions for GPU Rendering", 2020); 0..1.
SHARED_FUNCTION float particleRandom(uint seed, uint which)
{
    uint h = (seed + which * 0x9e3779b9u) * 747796405u + 2891336453u;
    h = ((h >> ((h >> 28u) + 4u)) ^ h) * 277803737u;
    h = (h >> 22u) ^ h;
    return float(h >> 8u) * (1.0f / 16777216.0f);
}

SHARED_FUNCTION bool particleIsSpark(ParticleSource s, uint seed)
{
    return s.kind == PARTICLE_FIRE && particleRandom(seed, 9u) < 0.07f;
}

// A velocity field without divergence (Arnold, Beltrami and Childress), over metres and seconds; each part within 1.6.
SHARED_FUNCTION vec3 particleSwirl(vec3 p, float time)
{
    vec3 a = p * 1.1f + vec3(time * 0.7f, time * 0.45f, -time * 0.6f);
    vec3 b = vec3(p.z, p.x, p.y) * 2.7f + vec3(-time * 1.3f, time * 1.1f, time * 0.9f);
    return vec3(sin(a.z) + cos(a.y), sin(a.x) + cos(a.z), sin(a.y) + cos(a.x)) * 0.6f +
           vec3(sin(b.z) + cos(b.y), sin(b.x) + cos(b.z), sin(b.y) + cos(b.x)) * 0.2f;
}

// m from the eye. A start that gives way to a drift through drag has a closed form: x = d t + (v - d) T (1 - exp(-t / T)).
SHARED_FUNCTION vec3 particleCentre(ParticleSource s, uint seed, float age)
{
    float turn = particleRandom(seed, 0u) * 6.2831853f;
    float out_ = sqrt(particleRandom(seed, 1u)) * s.spread;
    vec3 aside = vec3(cos(turn) * out_, 0.0f, sin(turn) * out_);
    float born = s.time - age;
    float gust = 1.0f + s.gust * (0.6f * sin(born * 0.41f) + 0.4f * sin(born * 1.07f + 1.3f));
    bool spark = particleIsSpark(s, seed);
    float lively = (0.75f + 0.5f * particleRandom(seed, 2u)) * (spark ? 1.9f : 1.0f);
    vec3 start = s.start * lively + aside * (s.kind == PARTICLE_DUST ? 1.2f : 0.15f);
    vec3 drift = vec3(s.drift.x * gust, s.drift.y * lively, s.drift.z * gust);
    vec3 way = drift * age + (start - drift) * (s.settle * (1.0f - exp(-age / s.settle)));
    // Flames draw together above their bed.
    float t = age / s.life;
    if (s.kind == PARTICLE_FIRE && !spark) aside *= 1.0f - 0.75f * t;
    float swirl = s.swirl * age / (1.0f + 0.35f * age) * (spark ? 2.5f : 1.0f);
    return s.origin + aside + way + particleSwirl(way * (0.6f / max(s.size + 0.2f, 0.3f)) + aside, born) * swirl;
}

// m
SHARED_FUNCTION float particleRadius(ParticleSource s, uint seed, float age)
{
    if (particleIsSpark(s, seed)) return 0.008f + 0.008f * particleRandom(seed, 3u);
    float t = age / s.life;
    float own = 0.5f * s.size * (0.7f + 0.6f * particleRandom(seed, 3u));
    if (s.kind == PARTICLE_FIRE) return own * (0.65f + 0.7f * t) * (1.0f - 0.55f * t * t);
    return own * (0.3f + 0.7f * sqrt(t) + (s.kind == PARTICLE_SMOKE ? 0.5f * t : 0.2f * t));
}

SHARED_END
#endif
