// What stands in the sky: sun, moon and stars of one frame. The light block's `towardSun` is the sun or, by night, the moon:
// whichever lights surfaces. Here the sun is always the sun.
#ifndef SHARED_HEAVENS_H
#define SHARED_HEAVENS_H
#include "shared.h"
SHARED_BEGIN

struct Heavens {
    vec3 towardSun;      float aerial;     // unit; factor on distances through the air before things, 0: none
    vec3 towardMoon;     float moonRadius; // unit; radians
    vec3 moonLitFrom;    float stars;      // unit, whence its disc is lit; radiance of a bright star, 0: none are seen
    vec3 moonRadiance;   float milkyWay;   // of its lit disc, outside the air; of the band at its brightest
    vec3 glow;           float unused1;    // radiance of the night's sky at the horizon,
    vec3 glowOverhead;   float unused2;    // and overhead
    vec4 equatorFromWorld[3];              // rows: towards the equinox of spring, 90 degrees east of it, the celestial pole
};
SHARED_STRUCT_END(Heavens, 144)

SHARED_END
#endif
