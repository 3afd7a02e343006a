// Bits of the GBuffer's surface target (B channel).
#ifndef SHARED_GBUFFER_H
#define SHARED_GBUFFER_H

#define SURFACE_SELECTED 1u
#define SURFACE_LEAF 2u
#define SURFACE_UNLIT 4u
#define SURFACE_GROUND 8u
#define SURFACE_IMPOSTOR 16u // flat, for something that reaches out of it: how far towards the sun stands where metallic does
#define IMPOSTOR_MOST_REACH 63.75f // m, that the GBuffer tells

#endif
