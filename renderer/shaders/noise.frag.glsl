// Tiling noise, made once: R billows (Perlin-Worley), G fine Worley, B and A two fields of Perlin octaves.
layout(location = 0) out vec4 noise;

const float kSize = 512.0;

uint hash(uvec2 p, uint seed)
{
    uint h = p.x * 0x8da6b343u ^ p.y * 0xd8163841u ^ seed * 0xcb1ab31fu;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    return h ^ (h >> 15);
}

vec2 hash2(ivec2 cell, int period, uint seed)
{
    ivec2 wrapped = ivec2(cell.x & (period - 1), cell.y & (period - 1)); // periods are powers of two
    uint h = hash(uvec2(wrapped), seed);
    return vec2(h & 0xffffu, h >> 16) / 65535.0;
}

float gradient(ivec2 cell, vec2 offset, int period, uint seed)
{
    float angle = hash2(cell, period, seed).x * 6.2831853;
    return dot(vec2(cos(angle), sin(angle)), offset);
}

float perlin(vec2 p, int period, uint seed) // about -0.7 .. 0.7
{
    vec2 cell = floor(p);
    vec2 f = p - cell;
    ivec2 c = ivec2(cell);
    vec2 s = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    float low = mix(gradient(c, f, period, seed), gradient(c + ivec2(1, 0), f - vec2(1, 0), period, seed), s.x);
    float high = mix(gradient(c + ivec2(0, 1), f - vec2(0, 1), period, seed),
                     gradient(c + ivec2(1, 1), f - vec2(1, 1), period, seed), s.x);
    return mix(low, high, s.y);
}

float worley(vec2 p, int period, uint seed) // 1 at the points, 0 far from all
{
    vec2 cell = floor(p);
    float nearest = 2.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            vec2 place = cell + vec2(x, y) + hash2(ivec2(cell) + ivec2(x, y), period, seed);
            nearest = min(nearest, length(place - p));
        }
    return max(1.0 - nearest, 0.0);
}

float perlinOctaves(vec2 uv, int period, uint seed) // 0 .. 1
{
    float sum = 0.0;
    float weight = 0.5;
    for (int octave = 0; octave < 6; ++octave) {
        sum += perlin(uv * float(period), period, seed + uint(octave)) * weight;
        period *= 2;
        weight *= 0.52;
    }
    return clamp(0.5 + sum * 0.85, 0.0, 1.0);
}

float worleyOctaves(vec2 uv, int period, uint seed)
{
    return worley(uv * float(period), period, seed) * 0.625 + worley(uv * float(period * 2), period * 2, seed + 1u) * 0.25 +
           worley(uv * float(period * 4), period * 4, seed + 2u) * 0.125;
}

void main()
{
    vec2 uv = gl_FragCoord.xy / kSize;
    float base = perlinOctaves(uv, 4, 11u);
    float cells = worleyOctaves(uv, 8, 29u);
    float billows = clamp(mix(cells, 1.0, base) * 1.25 - 0.35, 0.0, 1.0); // Perlin lifted by Worley (Schneider 2015)
    noise = vec4(billows, worleyOctaves(uv, 16, 47u), perlinOctaves(uv, 4, 71u), perlinOctaves(uv, 8, 97u));
}
