// Pictures of puffs (the lower half) and of flames (the upper), four by four: R density, G and B the slope of a puff's
// surface, A a finer noise by which it comes apart.
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 picture;

float hashed(vec2 cell, float seed)
{
    uvec2 c = uvec2(ivec2(cell) + 4096);
    uint h = c.x * 0x8da6b343u ^ c.y * 0xd8163841u ^ uint(seed) * 0xcb1ab31fu;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return float((h ^ (h >> 15)) >> 8) * (1.0 / 16777216.0);
}

float valueNoise(vec2 p, float seed)
{
    vec2 cell = floor(p);
    vec2 f = p - cell;
    f = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    return mix(mix(hashed(cell, seed), hashed(cell + vec2(1.0, 0.0), seed), f.x),
               mix(hashed(cell + vec2(0.0, 1.0), seed), hashed(cell + vec2(1.0, 1.0), seed), f.x), f.y);
}

float octaves(vec2 p, float seed)
{
    float sum = 0.0;
    float weight = 0.5;
    for (int i = 0; i < 5; ++i) {
        sum += weight * valueNoise(p, seed + float(i) * 7.0);
        p = mat2(0.8, 0.6, -0.6, 0.8) * p * 2.03 + 3.1;
        weight *= 0.55;
    }
    return sum / 0.95;
}

// How thick a puff is towards the eye, 0 outside.
float puff(vec2 p, float seed)
{
    vec2 bent = p + 0.45 * (vec2(octaves(p * 1.4 + 5.0, seed + 50.0), octaves(p * 1.4 + 9.0, seed + 60.0)) - 0.5);
    float noise = octaves(bent * 2.1, seed);
    float round_ = 1.0 - dot(bent, bent) * 1.25;
    return clamp(round_ * 0.95 + (noise - 0.5) * 1.35, 0.0, 1.0) * smoothstep(0.98, 0.7, length(p));
}

float flame(vec2 p, float seed)
{
    float up = p.y * 0.5 + 0.5; // 0 at its foot
    float sway = (octaves(vec2(up * 2.2, seed), seed) - 0.5) * 1.5 * up;
    float x = p.x + sway;
    float width = 0.62 * sqrt(clamp(up * 3.5, 0.0, 1.0)) * pow(clamp(1.0 - up, 0.0, 1.0), 0.75) + 1e-3;
    float tongues = octaves(vec2(x * 2.6, up * 1.5) + seed, seed + 20.0);
    float core = 1.0 - abs(x) / width + (tongues - 0.5) * 1.1;
    return clamp(core, 0.0, 1.0) * smoothstep(0.0, 0.12, up) * smoothstep(1.0, 0.8, up) * smoothstep(1.0, 0.8, abs(p.x));
}

void main()
{
    vec2 tile = floor(uv * 4.0);
    vec2 p = fract(uv * 4.0) * 2.0 - 1.0;
    float seed = 1.0 + tile.x * 13.0 + tile.y * 101.0;
    float fine = octaves(p * 5.0, seed + 33.0);
    if (tile.y >= 2.0) {
        picture = vec4(flame(p, seed), 0.5, 0.5, fine);
        return;
    }
    const float kStep = 0.03;
    float here = puff(p, seed);
    vec2 slope = vec2(here - puff(p + vec2(kStep, 0.0), seed), here - puff(p + vec2(0.0, kStep), seed)) * (0.22 / kStep);
    picture = vec4(here, clamp((p * 0.55 + slope) * 0.5 + 0.5, 0.0, 1.0), fine);
}
