// The ground as something to read: over the picture, or in its place.
#include "terrain.glsl"
#include "terrain_layers.glsl"
#ifdef HOLES
#include "hole.glsl"
#endif

layout(location = 0) in vec3 place; // texel x, z; height, m
layout(location = 1) flat in float level;
layout(location = 0) out vec4 outColour;

const float kTile = 512.0; // texels

vec3 distinct(float number) // a colour that its neighbours do not have
{
    return 0.5 + 0.45 * cos(6.2831853 * (number * 0.381966 + vec3(0.0, 0.33, 0.67)));
}

// How much of the pixel a line covers that runs where `value` is a whole number; nothing where lines run closer than `apart` pixels.
float line(float value, float width, float apart)
{
    float pixel = max(fwidth(value), 1e-6);
    float away = abs(fract(value - 0.5) - 0.5) / pixel;
    return clamp(width * 0.5 + 0.5 - away, 0.0, 1.0) * clamp(1.0 / (pixel * apart) - 1.0, 0.0, 1.0);
}

float lines(vec2 texel, float step, float width, float apart)
{
    return max(line(texel.x / step, width, apart), line(texel.y / step, width, apart));
}

void main()
{
    vec2 texel = place.xy, metres = texel * terrain.metres;
    vec3 normal = groundNormal(texel);
    outColour = vec4(0.0);
#if VIEW == 0 // contours: every 1, 10, 100 m, as far as they do not run together; each fifth is stronger
    float shown = 0.0;
    float step = 1.0;
    for (int i = 0; i < 4; ++i, step *= 10.0)
        shown = max(shown, max(line(place.z / step, 1.0, 7.0) * 0.6, line(place.z / (step * 5.0), 1.6, 7.0) * 0.95));
    outColour = vec4(1.0, 0.86, 0.6, shown);
#elif VIEW == 1 // slope: green, yellow from 20 degrees, red from 40, violet from 60
    float s = clamp(slopeOf(normal) / 20.0, 0.0, 3.99);
    vec3 steps[5] = vec3[5](vec3(0.2, 0.5, 0.25), vec3(0.95, 0.85, 0.2), vec3(0.9, 0.25, 0.15), vec3(0.45, 0.1, 0.55), vec3(0.2, 0.05, 0.3));
    int i = int(s);
    outColour = vec4(mix(steps[i], steps[i + 1], s - float(i)), 0.8);
#elif VIEW == 2 // grid: the texels, near ones; 100 m; the edges of tiles
    float near = lines(texel, 1.0, 1.0, 5.0) * 0.4;
    float hundred = lines(metres, 100.0, 1.4, 5.0) * 0.8;
    float tiles = lines(texel, kTile, 2.4, 3.0);
    outColour = tiles > hundred ? vec4(1.0, 0.75, 0.2, tiles) : hundred > near ? vec4(0.75, 0.9, 1.0, hundred) : vec4(1.0, 1.0, 1.0, near);
#elif VIEW == 3 // layers: a colour for each, by the shares that show
    Choice choice = layersAt(texel, place.z, normal, groundNoise(metres));
    float second = choice.secondShare / max(choice.firstShare + choice.secondShare, 1e-4);
    outColour = vec4(mix(distinct(float(choice.first)), distinct(float(choice.second)), second), 0.85);
#elif VIEW == 4 // tiles: nodes by their level, and the edges of nodes and tiles
    float node = lines(texel, exp2(level) * float(TERRAIN_QUADS), 1.0, 3.0);
    float tiles = lines(texel, kTile, 2.4, 3.0);
    outColour = vec4(mix(mix(distinct(level), vec3(0.05), node * 0.7), vec3(1.0), tiles), 0.75);
#endif
    outColour.rgb *= VIEW == 0 || VIEW == 2 ? 1.0 : 0.55 + 0.45 * max(dot(normal, normalize(vec3(0.4, 0.8, 0.45))), 0.0);
#ifdef HOLES
    if (inHole(coverMap, texel)) discard;
#endif
}
