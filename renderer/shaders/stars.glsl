// Stars and the Milky Way, fixed to the celestial sphere, which turns with the sidereal day. They are drawn by chance, as a
// catalogue's stars are spread: ten times as many for each two magnitudes fainter, more of them towards the galaxy's plane.
#include "heavens.glsl"
#include "octahedron.glsl"
#include "shared/bindings.h"
#include "view.glsl"

layout(binding = NOISE_UNIT) uniform sampler2D galaxyNoise;

const vec3 kGalacticPole = vec3(-0.8676, -0.1981, 0.4560);   // at right ascension 192.86, declination 27.13 degrees
const vec3 kGalacticCentre = vec3(-0.0549, -0.8734, -0.4838); // at 266.40, -28.94

// How thickly stars lie, 0 at the galaxy's poles; dust lanes and clouds of stars in y.
vec2 galaxy(vec3 d)
{
    float height = dot(d, kGalacticPole);
    float centre = dot(d, kGalacticCentre);
    float width = mix(0.13, 0.22, 0.5 + 0.5 * centre);
    float band = exp(-height * height / (width * width));
    float along = atan(dot(d, cross(kGalacticPole, kGalacticCentre)), centre) * (1.0 / 6.2831853);
    float clouds = textureLod(galaxyNoise, vec2(along * 2.0, height * 0.45), 1.0).r;
    float lanes = textureLod(galaxyNoise, vec2(along * 4.0 + 0.3, height * 1.1), 0.0).r;
    float split = smoothstep(0.35, 0.62, lanes) * exp(-height * height / 0.0035) * 0.75;
    return vec2(band, band * smoothstep(0.25, 0.75, clouds) * (1.0 - split) * mix(0.45, 1.0, 0.5 + 0.5 * centre));
}

uint starHash(uvec2 cell)
{
    uint h = (cell.x * 0x8da6b343u) ^ (cell.y * 0xd8163841u);
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return h ^ (h >> 15);
}

vec3 stars(vec3 direction)
{
    vec3 d = vec3(dot(heavens.equatorFromWorld[0].xyz, direction), dot(heavens.equatorFromWorld[1].xyz, direction),
                  dot(heavens.equatorFromWorld[2].xyz, direction));
    const float kCells = 150.0; // from the pole of the octahedron to its edge
    vec2 thick = galaxy(d);
    vec2 place = octahedral(d) * kCells;
    vec2 cell = floor(place);
    uint h = starHash(uvec2(ivec2(cell) + 4096));
    uint g = starHash(uvec2(h, 77u));
    float chance = float(h & 0xffffu) / 65535.0; // small: a star, and the smaller the brighter
    float wanted = 0.11 + 0.25 * thick.x;
    float share = clamp(chance / wanted, 1e-4, 1.0);
    // A star is a spot of about a pixel that lies within its cell; an angle is so many cells there.
    float reach = clamp(1.4 * view.pixelAngle * kCells / 1.5, 0.08, 0.5);
    vec2 centre = cell + reach + (1.0 - 2.0 * reach) * vec2(g & 0xffu, (g >> 8) & 0xffu) / 255.0;
    float away = length(d - fromOctahedral(centre / kCells)); // in angle: the octahedron's cells are no squares
    float glow = max(1.0 - away / (1.4 * view.pixelAngle), 0.0);
    float bright = min(0.0045 * pow(share, -0.75), 0.3) * step(chance, wanted);
    vec3 tint = mix(vec3(1.0, 0.82, 0.64), vec3(0.72, 0.84, 1.0), float((g >> 16) & 0xffu) / 255.0);
    float above = smoothstep(0.0, 0.25, direction.y); // the air takes the light of those low down
    return (tint * (bright * glow * glow * glow * heavens.stars) + vec3(0.82, 0.88, 1.0) * (thick.y * heavens.milkyWay)) * above;
}
