// One of two levels of detail that share an instance's pixels while the eye comes nearer: each draws those that the
// other leaves out.
#include "shared/drawn.h"
#include "view.glsl"

#ifdef FADE
layout(location = 13) flat in uint fade;

bool fadedAway(vec2 pixel)
{
    float share = float(fade & (DRAWN_FADE_OTHERS - 1u)) / float(DRAWN_FADE_STEPS);
    bool coarse = interleavedNoise(pixel) < share;
    return coarse == (fade >= DRAWN_FADE_OTHERS);
}
#endif
