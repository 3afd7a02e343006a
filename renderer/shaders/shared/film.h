// What lens and film make of light: white balance, contrast, saturation, vignette, grain. Neutral values change nothing.
#ifndef SHARED_FILM_H
#define SHARED_FILM_H
#include "tone_map.h"

#define MIDDLE_GREY 0.18f

SHARED_BEGIN

struct Film {
    vec4 white[3];   // columns of the matrix after which the light that is to look white does
    float contrast;  float saturation; // 1: as it is
    float vignette;  float grain;      // share of light that the corners lose; strength, 0: none
    float bloom;     float moment;     // share of light that is scattered; number of the film's picture, for its grain
    float unused1;   float unused2;
};
SHARED_STRUCT_END(Film, 80)

SHARED_FUNCTION vec3 whiteBalanced(Film film, vec3 c)
{
    return max(vec3(film.white[0]) * c.x + vec3(film.white[1]) * c.y + vec3(film.white[2]) * c.z, vec3(0.0f));
}

// Around middle grey, in powers: what is twice as bright stays so many stops brighter.
SHARED_FUNCTION vec3 contrasted(Film film, vec3 c)
{
    return pow(max(c, vec3(0.0f)) / MIDDLE_GREY, vec3(film.contrast)) * MIDDLE_GREY;
}

SHARED_FUNCTION vec3 saturated(Film film, vec3 c)
{
    float grey = luminance(c);
    return max(vec3(grey) + (c - vec3(grey)) * film.saturation, vec3(0.0f));
}

// Grows with the fourth power of the distance from the middle, as the light that falls through a lens at an angle does
// (the law of cos^4); 1 at the corners.
SHARED_FUNCTION float vignetteAt(Film film, vec2 uv)
{
    vec2 from = uv * 2.0f - vec2(1.0f);
    float r2 = 0.5f * dot(from, from);
    return 1.0f - film.vignette * r2 * r2;
}

// From even noise in [0, 1) to that of the sum of two dice, in (-1, 1): rounding after it leaves neither steps nor a
// noise that comes and goes with the value (Wannamaker, Lipshitz and Vanderkooy, 1992).
SHARED_FUNCTION float triangular(float noise)
{
    float u = 2.0f * noise - 1.0f;
    float t = 1.0f - sqrt(1.0f - abs(u));
    return u < 0.0f ? -t : t;
}

SHARED_END
#endif
