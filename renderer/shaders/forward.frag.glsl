// Objects that are blended over the picture: glass and the like, ghosts of what is being placed, thumbnails.
#include "haze.glsl"
#include "lighting.glsl"
#ifdef LAMPS
#include "lamps.glsl"
#endif
#include "material.glsl"
#include "weather_surface.glsl"

layout(location = 11) in vec3 relative;
layout(location = 0) out vec4 radiance;
#ifdef WRITE_ID
layout(location = 1) out uint outId;
#endif

void main()
{
    MaterialSample m = sampleMaterial(gl_FrontFacing);
#ifdef MASK
    if (m.root.a < alphaCutoff()) discard;
#endif
    Surface s;
    s.baseColour = m.root.rgb * m.root.rgb;
    s.normal = m.normal;
    s.roughness = m.roughness;
    s.metallic = m.metallic;
    s.occlusion = m.occlusion;
    s.bits = (materialFlags() & MATERIAL_LEAF) != 0u ? SURFACE_LEAF : 0u;
#ifndef STUDIO
    if ((materialFlags() & MATERIAL_UNLIT) == 0u) weatherSurface(s.baseColour, s.roughness, s.metallic, s.normal, relative);
#endif
    float sun = sunVisibility(relative, s.normal);
#ifdef CLOUD_SHADOWS
    sun *= cloudShadow(relative);
#endif
    vec3 toEye = -normalize(relative);
    Reflector reflector = reflectorAt(s, toEye);
    vec3 lit = shade(s, reflector, toEye, sunAt(relative) * sun) + m.emissive;
#ifdef LAMPS
    lit += lampLight(s, reflector, relative, toEye, gl_FragCoord.xy);
#endif
    lit = (materialFlags() & MATERIAL_UNLIT) != 0u ? s.baseColour / view.exposure : lit;
    lit = isSelected() ? tintSelected(lit) : lit;
    float alpha = m.root.a;
#ifdef GHOST
    lit = mix(lit, kViolet * (0.9 / view.exposure), 0.3);
    alpha = 0.6;
#endif
#ifndef STUDIO
    Haze haze = hazeBefore(relative, gl_FragCoord.xy * view.texel);
    lit = max(lit * haze.through + haze.light, vec3(0.0));
#endif
    radiance = vec4(min(lit, vec3(60000.0)), alpha);
#ifdef WRITE_ID
    outId = objectHere();
#endif
}
