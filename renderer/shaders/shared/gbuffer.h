// Bits of the GBuffer's surface target (B channel).
#ifndef SHARED_GBUFFER_H
#define SHARED_GBUFFER_H

#define SURFACE_SELECTED 1u
#define SURFACE_LEAF 2u
#define SURFACE_UNLIT 4u
#define SURFACE_GROUND 8u

#endif
