// Water from above, or from below (FROM_BELOW): what lies in it through its depth, the sky and the shore mirrored in it, the sun's glitter
// on slopes too small to be seen (Bruneton, Neyret and Holzschuch, "Real-time Realistic Ocean Lighting", 2010), foam.
#include "haze.glsl"
#include "lighting.glsl"
#include "water.glsl"
#include "water_mirror.glsl"

layout(binding = RIPPLES_UNIT) uniform sampler2D ripples;

layout(location = 0) in vec2 rest;
layout(location = 0) out vec4 radiance;

const float kPi = 3.14159265;
const float kDense = 1.333;       // refractive index
const float kReflected = 0.02;    // of what comes from straight above
const float kFoamAlbedo = 0.7;
const float kShoreEdge = 0.05;    // m of depth over which a shore is soft

// Slopes of the surface; `along` is the length of water that the pixel covers, m.
WaterShape shapeAt(vec2 place, float along)
{
    WaterShape s = WaterShape(vec3(0.0), vec2(0.0), 0.0, 0.0);
    for (int i = 0; i < WATER_WAVES; ++i)
        s = waterAdd(s, water.wave[i], place, waterShown(water.wave[i].length, along));
    s.slope /= max(1.0 - s.crowding, 0.2);
    return s;
}

vec2 alongWind(vec2 v, vec2 axis)
{
    return vec2(dot(v, axis), dot(v, vec2(-axis.y, axis.x)));
}

vec2 fromWind(vec2 v, vec2 axis)
{
    return axis * v.x + vec2(-axis.y, axis.x) * v.y;
}

// Adds both layers of ripples; the foam's pattern is theirs too.
float addRipples(inout WaterShape s, vec2 place)
{
    const vec2 turn = vec2(WATER_RIPPLES_COSINE, WATER_RIPPLES_SINE);
    vec2 axis = vec2(water.wind.x * turn.x - water.wind.y * turn.y, water.wind.x * turn.y + water.wind.y * turn.x);
    vec4 near = texture(ripples, alongWind(place, water.wind) * (1.0 / WATER_RIPPLES_NEAR) + water.ripples.xy);
    vec4 wide = texture(ripples, alongWind(place, axis) * (1.0 / WATER_RIPPLES_WIDE) + water.ripples.zw);
    float strength = water.ripple * 0.7071;
    s.slope += (fromWind(near.xy, water.wind) + fromWind(wide.xy, axis)) * strength;
    vec2 lost = max(vec2(near.z - dot(near.xy, near.xy), wide.z - dot(wide.xy, wide.xy)), vec2(0.0));
    s.lost += (lost.x + lost.y) * strength * strength;
    return 0.5 * (near.w + wide.w);
}

// Of light that meets slopes around a mean (Bruneton 2010, eq. 8); Schlick's for a calm surface.
float fresnelOfWater(float cosine, float lost)
{
    float deviation = sqrt(0.5 * lost);
    float grazing = pow(clamp(1.0 - cosine, 0.0, 1.0), 5.0 * exp(-2.69 * deviation));
    return kReflected + (1.0 - kReflected) * grazing / (1.0 + 22.7 * pow(deviation, 1.5));
}

// The sun in the facets of the surface, for each unit of its light: no narrower than its disc is, and as much of it as stands
// above the water's plane.
float glitter(vec3 normal, vec3 toEye, float lost)
{
    vec3 h = normalize(toEye + light.towardSun);
    float alpha = sqrt(lost + 0.25 * light.sunRadius * light.sunRadius + 1e-6);
    float nol = clamp(dot(normal, light.towardSun), 0.001, 1.0);
    float nov = clamp(dot(normal, toEye), 0.02, 1.0);
    float facets = min(distributionGgx(alpha, clamp(dot(normal, h), 0.0, 1.0)) * visibilitySmith(alpha, nol, nov), 4000.0);
    float f = kReflected + (1.0 - kReflected) * pow(1.0 - clamp(dot(h, toEye), 0.0, 1.0), 5.0);
    return facets * f * nol * clamp(0.5 + 0.5 * light.towardSun.y / light.sunRadius, 0.0, 1.0);
}

// m of water below the surface at what a place of the picture shows; far without a ground.
float depthBelow(vec2 uv, float surface)
{
    float depth = textureLod(behindDepth, uv, 0.0).r;
    vec2 ndc = uv * 2.0 - 1.0;
    vec3 ray = view.forward + view.right * ndc.x + view.up * ndc.y;
    return depth > 0.0 ? surface - ray.y * (view.near / depth) : 1e4;
}

// Where a ray that the surface bends meets the ground, on the screen; never what stands before the surface.
vec2 bentBy(vec2 uv, vec3 normal, float away, float below)
{
    vec3 aside = vec3(normal.x, 0.0, normal.z) * (0.25 * min(below, 2.0));
    vec2 shift = vec2(dot(aside, view.right) / dot(view.right, view.right), dot(aside, view.up) / dot(view.up, view.up)) * (0.5 / away);
    vec2 there = clamp(uv + clamp(shift, -0.05, 0.05), 0.5 * view.texel, 1.0 - 0.5 * view.texel);
    bool before = textureLod(behindDepth, there, 0.0).r > gl_FragCoord.z;
    return before ? uv : there;
}

// 0..1: lace along the shore that comes and goes with the waves, and on crests that crowd.
float foamAt(float below, float crowding, float pattern)
{
    float strength = water.foam * clamp(water.waves * 10.0, 0.0, 1.0);
    float reach = clamp(water.waves * 0.9, 0.05, 2.0);
    float wash = 0.6 + 0.4 * sin((below / reach * 1.3 + water.time * 0.14) * 6.2831853);
    float shore = (1.0 - smoothstep(0.0, reach, below)) * wash;
    float crest = smoothstep(0.38, 0.75, crowding);
    float amount = strength * clamp(shore + crest, 0.0, 1.0);
    return amount * smoothstep(1.0 - amount, 1.25 - 0.5 * amount, pattern + 0.25 * amount);
}

void main()
{
    vec2 uv = gl_FragCoord.xy * view.texel;
    vec2 ndc = uv * 2.0 - 1.0;
    vec3 ray = view.forward + view.right * ndc.x + view.up * ndc.y;
    vec3 relative = relativeFromDepth(ray, max(gl_FragCoord.z, 1e-7));
    float away = length(relative);
    vec3 toEye = -relative / away;

#ifdef PATCHES
    vec2 place = rest;
#else
    vec2 place = relative.xz;
#endif
    WaterShape s = shapeAt(place, away * view.pixelAngle / max(abs(toEye.y), 0.03));
    float pattern = addRipples(s, place);
    vec3 normal = normalize(vec3(-s.slope.x, 1.0, -s.slope.y));
#ifdef FROM_BELOW
    normal = -normal;
#endif
    float facing = dot(normal, toEye);
    normal = facing < 0.02 ? normalize(normal + toEye * (0.02 - facing)) : normal;
    float cosine = max(dot(normal, toEye), 0.02);

    vec3 sun = sunAt(relative) * sunVisibility(relative, vec3(0.0, 1.0, 0.0));
#ifdef CLOUD_SHADOWS
    sun *= cloudShadow(relative);
#endif
    // As of white, over pi; what is diffuse takes its colour of it.
    vec3 around = sun * (max(light.towardSun.y, 0.0) / kPi) + skyIrradiance(vec3(0.0, 1.0, 0.0)) * light.ambient;
    vec3 deep = water.colour * around;

    vec3 lit;
#ifdef FROM_BELOW
    // Snell's window, and the water's own colour mirrored around it.
    float bent2 = kDense * kDense * (1.0 - cosine * cosine);
    float f = bent2 >= 1.0 ? 1.0 : fresnelOfWater(sqrt(max(1.0 - bent2, 0.0)), 0.0);
    vec2 there = clamp(uv + normal.xz * 0.06, 0.5 * view.texel, 1.0 - 0.5 * view.texel);
    lit = mix(textureLod(behind, there, 0.0).rgb, deep, f);
#else
    float straight = depthBelow(uv, relative.y);
    vec2 there = bentBy(uv, normal, away, straight);
    float below = max(depthBelow(there, relative.y), 0.0);
    vec3 ground = texelFetch(behind, ivec2(there * vec2(view.size)), 0).rgb;
    // The way to the ground of a ray that the surface bends.
    float slant = sqrt(1.0 - (1.0 - toEye.y * toEye.y) / (kDense * kDense));
    float through = exp(-water.extinction * below / slant);
    // Light that a crest lets through, towards the sun.
    float crest = clamp(s.crowding, 0.0, 1.0) * pow(clamp(-dot(toEye, light.towardSun), 0.0, 1.0), 3.0);
    vec3 within = deep + water.colour * sun * (0.6 * crest);

    float f = fresnelOfWater(cosine, s.lost);
    vec3 upward = reflect(-toEye, normal);
    upward.y = sqrt(upward.y * upward.y + 1.5 * s.lost); // of facets that look up more than their mean
    Mirrored mirrored = mirroredFrom(relative, normalize(upward));
    float foam = foamAt(straight, s.crowding, pattern);

    // What the picture shows, of the ground and the shore, has its haze already: only the rest gets what stands before the water.
    float clear = 1.0 - foam;
    vec2 shown = vec2((1.0 - f) * through, f * mirrored.surface.a) * clear;
    lit = within * ((1.0 - f) * (1.0 - through)) + mirrored.sky * (f * (1.0 - mirrored.surface.a)) + glitter(normal, toEye, s.lost) * sun;
    lit = mix(lit, around * kFoamAlbedo, foam);
    Haze haze = hazeBefore(relative, uv);
    lit = lit * haze.through + haze.light * (1.0 - shown.x - shown.y) + ground * shown.x + mirrored.surface.rgb * shown.y;
    lit = max(lit, vec3(0.0));
    lit = mix(texelFetch(behind, ivec2(gl_FragCoord.xy), 0).rgb, lit, smoothstep(0.0, kShoreEdge, straight));
#endif
    radiance = vec4(min(lit, vec3(60000.0)), 1.0);
}
