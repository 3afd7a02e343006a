// All that stands between the eye and what is drawn over the finished picture: air (AERIAL), fog (FOG), and in it what shadows take
// (SHAFTS_VOLUME, SHAFTS_SCREEN).
#include "aerial.glsl"
#include "fog.glsl"
#include "shafts.glsl"

struct Haze {
    vec3 through; // share of light from there that is left
    vec3 light;   // that is added
};

// Of what lies at `relative`, m from the eye, and shows at `uv`.
Haze hazeBefore(vec3 relative, vec2 uv)
{
    AirBefore air = airTo(relative);
    Haze haze = Haze(air.through, air.light);
#ifdef FOG
    float clear = fogTransmittance(relative);
    haze.through *= clear;
    haze.light = haze.light * clear + fogColour(normalize(relative), length(relative)) * (1.0 - clear);
#endif
#if defined(SHAFTS_VOLUME) || defined(SHAFTS_SCREEN)
    haze.light -= missingInFog(uv, relative);
#endif
    return haze;
}
