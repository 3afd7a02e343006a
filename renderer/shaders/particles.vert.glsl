// One quad for each particle, turned to the eye; its light is found here, once for all of it.
#include "haze.glsl"
#include "lighting.glsl"
#ifdef LAMPS
#include "lamps.glsl"
#endif
#include "shared/particles.h"

layout(std140, binding = PARTICLES_BINDING) uniform ParticlesBlock { ParticleSource sources[MOST_PARTICLE_SOURCES]; };

layout(location = 0) in uvec2 record; // source, seed
layout(location = 1) in float age;

layout(location = 0) out vec2 atlasPlace;
layout(location = 1) out vec2 corner;              // -1..1
layout(location = 2) flat out vec4 look;           // opacity, share that has come apart, m over which it is soft, kind
layout(location = 3) flat out vec3 sunlight;       // what a white particle would scatter of the sun
layout(location = 4) flat out vec3 skylight;       // and of the sky
layout(location = 5) flat out vec3 tint;
layout(location = 6) flat out vec3 towardSun;      // along the quad's axes
layout(location = 7) flat out vec3 hazeThrough;    // share of its light that is left
layout(location = 8) flat out vec3 hazeLight;      // what stands before it adds

const float kPi = 3.14159265;

// Forward scattering of Henyey and Greenstein, 1 where it is even.
float ahead(float g, float cosine)
{
    float d = 1.0 + g * g - 2.0 * g * cosine;
    return (1.0 - g * g) / (d * sqrt(d));
}

void main()
{
    ParticleSource s = sources[record.x];
    uint seed = record.y;
    float t = age / s.life;
    vec3 centre = particleCentre(s, seed, age);
    float radius = particleRadius(s, seed, age);
    float away = max(length(centre), 0.01);
    bool fire = s.kind == PARTICLE_FIRE;
    bool spark = particleIsSpark(s, seed);

    vec3 toEye = -centre / away;
    vec3 up = normalize(view.up);
    if (fire && !spark) up = normalize(mix(up, vec3(0.0, 1.0, 0.0), 0.85)); // flames stand
    vec3 right = normalize(cross(up, toEye));
    up = cross(toEye, right);
    float turn = fire ? 0.0 : (particleRandom(seed, 4u) + (particleRandom(seed, 6u) - 0.5) * 0.25 * t * sqrt(s.life)) * 2.0 * kPi;
    vec3 across = right * cos(turn) + up * sin(turn);
    vec3 along = up * cos(turn) - right * sin(turn);

    corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1);
    float pixel = away * view.pixelAngle;
    float drawn = spark ? max(radius, 0.9 * pixel) : radius;
    vec3 relative = centre + (across * corner.x + along * corner.y * (fire && !spark ? 1.6 : 1.0)) * drawn;
    gl_Position = view.clipFromRelative * vec4(relative, 1.0);

    float mirror = particleRandom(seed, 7u) < 0.5 ? -1.0 : 1.0;
    int tile = int(particleRandom(seed, 8u) * 7.999) + (fire ? 8 : 0);
    atlasPlace = (vec2(tile & 3, tile >> 2) + 0.5 + 0.49 * vec2(corner.x * mirror, corner.y)) * 0.25;

    // Thinner as it spreads; faded in and out, and near the eye.
    float ends = smoothstep(0.0, fire ? 0.12 : 0.10, t) * (1.0 - smoothstep(fire ? 0.55 : 0.35, 1.0, t));
    float near = smoothstep(0.15, 0.6 + radius, away);
    float thick = s.kind == PARTICLE_SMOKE ? 0.24 : (s.kind == PARTICLE_DUST ? 0.22 : 1.0);
    float share = spark ? (radius * radius) / (drawn * drawn) : 1.0;
    look = vec4(thick * ends * near * share, t, max(0.8 * radius, 0.02), spark ? 4.0 : float(s.kind));

    float sun = fire ? 0.0 : sunVisibility(centre, toEye);
#ifdef CLOUD_SHADOWS
    sun *= cloudShadow(centre);
#endif
    float forward = ahead(0.45, -dot(toEye, light.towardSun)) * 0.6 + 0.4;
    sunlight = sunAt(centre) * (sun * forward / kPi);
    skylight = 0.5 * (skyIrradiance(vec3(0.0, 1.0, 0.0)) + skyIrradiance(toEye)) * light.ambient;
    towardSun = vec3(dot(light.towardSun, across) * mirror, dot(light.towardSun, along), dot(light.towardSun, toEye));
    tint = s.colour;
    vec4 clip = view.clipFromRelative * vec4(centre, 1.0);
    vec2 place = clip.xy / max(clip.w, view.near) * 0.5 + 0.5;
#ifdef LAMPS
    skylight += lampsAround(centre, clamp(place, 0.0, 1.0) / view.texel, radius) * (0.25 / kPi); // scattered evenly
#endif
    Haze haze = hazeBefore(centre, place);
    hazeThrough = haze.through;
    hazeLight = max(haze.light, vec3(0.0));
}
