// Tiling noise in space, made once. Shape: R Perlin octaves lifted by Worley cells, G Perlin octaves alone.
// DETAIL: R Worley octaves. Schneider and Vos, "The Real-time Volumetric Cloudscapes of Horizon: Zero Dawn" (2015).
layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;
layout(rg8, binding = 0) uniform writeonly image3D noise;

uint hash(ivec3 p, uint seed)
{
    uint h = uint(p.x) * 0x8da6b343u ^ uint(p.y) * 0xd8163841u ^ uint(p.z) * 0x9e3779b1u ^ seed * 0xcb1ab31fu;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    return h ^ (h >> 15);
}

ivec3 wrapped(ivec3 cell, ivec3 period)
{
    return cell & (period - 1); // periods are powers of two
}

float gradient(ivec3 cell, vec3 offset, ivec3 period, uint seed)
{
    uint h = hash(wrapped(cell, period), seed);
    // The twelve edges of a cube (Perlin 2002), four of them twice.
    uint edge = h & 15u;
    float u = edge < 8u ? offset.x : offset.y;
    float v = edge < 4u ? offset.y : edge == 12u || edge == 14u ? offset.x : offset.z;
    return ((edge & 1u) == 0u ? u : -u) + ((edge & 2u) == 0u ? v : -v);
}

float perlin(vec3 p, ivec3 period, uint seed) // about -1 .. 1
{
    vec3 cell = floor(p);
    vec3 f = p - cell;
    ivec3 c = ivec3(cell);
    vec3 s = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    float near = mix(mix(gradient(c, f, period, seed), gradient(c + ivec3(1, 0, 0), f - vec3(1, 0, 0), period, seed), s.x),
                     mix(gradient(c + ivec3(0, 1, 0), f - vec3(0, 1, 0), period, seed),
                         gradient(c + ivec3(1, 1, 0), f - vec3(1, 1, 0), period, seed), s.x), s.y);
    float far = mix(mix(gradient(c + ivec3(0, 0, 1), f - vec3(0, 0, 1), period, seed),
                        gradient(c + ivec3(1, 0, 1), f - vec3(1, 0, 1), period, seed), s.x),
                    mix(gradient(c + ivec3(0, 1, 1), f - vec3(0, 1, 1), period, seed),
                        gradient(c + ivec3(1, 1, 1), f - vec3(1, 1, 1), period, seed), s.x), s.y);
    return mix(near, far, s.z);
}

float worley(vec3 p, ivec3 period, uint seed) // 1 at the points, 0 far from all
{
    vec3 cell = floor(p);
    float nearest = 2.0;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                ivec3 c = ivec3(cell) + ivec3(x, y, z);
                uint h = hash(wrapped(c, period), seed);
                vec3 place = vec3(c) + vec3(h & 0x3ffu, (h >> 10) & 0x3ffu, (h >> 20) & 0x3ffu) / 1024.0 - p;
                nearest = min(nearest, dot(place, place));
            }
    return max(1.0 - sqrt(nearest), 0.0);
}

float perlinOctaves(vec3 p, ivec3 period, uint seed) // 0 .. 1
{
    float sum = 0.0;
    float weight = 0.5;
    for (int octave = 0; octave < 4; ++octave) {
        sum += perlin(p * vec3(period), period, seed + uint(octave)) * weight;
        period *= 2;
        weight *= 0.52;
    }
    return clamp(0.5 + sum * 0.6, 0.0, 1.0);
}

float worleyOctaves(vec3 p, ivec3 period, uint seed)
{
    return worley(p * vec3(period), period, seed) * 0.65 + worley(p * vec3(period * 2), period * 2, seed + 1u) * 0.35;
}

void main()
{
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    vec3 p = (vec3(texel) + 0.5) / vec3(imageSize(noise));
#ifdef DETAIL
    imageStore(noise, texel, vec4(worleyOctaves(p, ivec3(4), 47u), 0.0, 0.0, 0.0));
#else
    float base = perlinOctaves(p, ivec3(4, 4, 1), 11u);
    float cells = worleyOctaves(p, ivec3(8, 8, 2), 29u);
    float billows = clamp(mix(cells, 1.0, base) * 1.25 - 0.35, 0.0, 1.0);
    imageStore(noise, texel, vec4(billows, perlinOctaves(p, ivec3(4, 4, 1), 71u), 0.0, 0.0));
#endif
}
