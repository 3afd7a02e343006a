// Every surface of the GBuffer under sun and sky. Runs where the depth test finds one.
#include "aerial.glsl"
#include "fog.glsl"
#include "gbuffer_in.glsl"
#include "lighting.glsl"
#ifdef LAMPS
#include "lamps.glsl"
#endif
#ifdef OCCLUSION
#include "occlusion.glsl"
#endif
#include "weather_surface.glsl"

layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 ray;
layout(location = 0) out vec4 radiance;

const float kOwnShadow = 0.9; // of an impostor's reach towards the sun
const float kCrownLit = 0.715;  // share of the sun that reaches a crown's leaves past each other

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 colour = texelFetch(gbufferColour, pixel, 0);
    vec4 stored = texelFetch(gbufferSurface, pixel, 0);
    Surface s;
    s.baseColour = decodeColour(colour.rgb);
    s.occlusion = colour.a;
    s.normal = fromOctahedral(texelFetch(gbufferNormal, pixel, 0).xy);
    s.roughness = max(stored.x, 0.045);
    s.bits = surfaceBits(stored);
    bool impostor = (s.bits & SURFACE_IMPOSTOR) != 0u;
    s.metallic = impostor ? 0.0 : stored.y;

    float depth = texelFetch(gbufferDepth, pixel, 0).r;
    vec3 relative = relativeFromDepth(ray, depth);
    if ((s.bits & SURFACE_UNLIT) == 0u) weatherSurface(s.baseColour, s.roughness, s.metallic, s.normal, relative);
#ifdef OCCLUSION
    s.occlusion *= occlusionAt(pixel, depth);
#endif
    // A flat picture would lie half in the shadow of what it stands for, with a straight edge.
    vec3 outOfOwnShadow = light.towardSun * (impostor ? stored.y * (IMPOSTOR_MOST_REACH * kOwnShadow) : 0.0);
    float sun = sunVisibility(relative + outOfOwnShadow, s.normal);
    sun *= impostor && (s.bits & SURFACE_LEAF) != 0u ? kCrownLit : 1.0;
#ifdef CLOUD_SHADOWS
    sun *= cloudShadow(relative);
#endif
    vec3 toEye = -normalize(relative);
    Reflector reflector = reflectorAt(s, toEye);
    vec3 lit = shade(s, reflector, toEye, sunAt(relative) * sun);
#ifdef LAMPS
    lit += lampLight(s, reflector, relative, toEye, gl_FragCoord.xy);
#endif
    float emission = decodeEmission(stored.w);
    lit = emission > 0.0 ? lit * 0.25 + s.baseColour * emission : lit;
    lit = (s.bits & SURFACE_UNLIT) != 0u ? s.baseColour / view.exposure : lit; // shown as it is, whatever the light
    lit = (s.bits & SURFACE_SELECTED) != 0u ? tintSelected(lit) : lit;
    lit = throughAir(lit, relative);
#ifdef FOG
    float through = fogTransmittance(relative);
    lit = lit * through + fogColour(normalize(relative), length(relative)) * (1.0 - through);
#endif
    radiance = vec4(min(lit, vec3(60000.0)), 1.0);
}
