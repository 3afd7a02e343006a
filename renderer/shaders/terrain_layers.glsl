// Which two layers cover a point of the ground: up to 32, by slope, altitude and flow or by hand.
layout(binding = NOISE_UNIT) uniform sampler2D noiseField;
layout(binding = GROUND_NORMALS_UNIT) uniform MAP_TEXTURE groundNormals;
#ifdef FLOW
layout(binding = FLOW_UNIT) uniform sampler2D groundFlow; // io::GroundFlow
#endif

float ramps(float value, vec4 ramp)
{
    vec2 both = clamp(value * ramp.xz + ramp.yw, 0.0, 1.0);
    return both.x * both.y;
}

// The value of the quad's first pixel, for all four.
vec3 quadShared(vec3 v)
{
    vec2 odd = vec2(ivec2(gl_FragCoord.xy) & 1);
    return v - dFdxFine(v) * odd.x - dFdyFine(v) * odd.y;
}

struct Choice {
    float shown; // share that no layer has taken yet
    int first, second;
    float firstShare, secondShare;
};

// `where`: slope in degrees, altitude in m, the noise that breaks borders, and flow.
void consider(inout Choice c, const int index, vec4 where)
{
    TerrainLayer layer = terrain.layer[index];
    vec2 moved = where.xy + where.z * layer.ragged;
    float share = ramps(moved.x, layer.slopeRamps) * ramps(moved.y, layer.altitudeRamps);
#ifdef FLOW
    share *= ramps(where.w + where.z * 0.04, layer.flowRamps);
#endif
    share *= share * (3.0 - 2.0 * share) * c.shown;
    c.shown -= share;
    bool top = share > c.firstShare;
    bool next = share > c.secondShare;
    c.second = top ? c.first : next ? index : c.second;
    c.secondShare = top ? c.firstShare : next ? share : c.secondShare;
    c.first = top ? index : c.first;
    c.firstShare = top ? share : c.firstShare;
}

#ifdef PAINTED
layout(binding = COVER_UNIT) uniform MAP_TEXTURE coverMap; // io::packed(): lower layer, upper layer, share of the upper one, painted

// What was painted covers the rules. The four texels around name two layers each: all that are the same count together, and the
// two that then show most are kept.
void showPainted(inout Choice c, vec2 texel)
{
    vec2 at = clamp(texel, vec2(0.0), terrain.lastTexel), last = terrain.lastTexel;
#ifdef WINDOWS
    float level = floor(windowLevel(texel));
    at *= exp2(-level);
    last *= exp2(-level);
#define COVER_AT(place) texelFetch(coverMap, windowTexel(place, int(level)), 0)
#else
#define COVER_AT(place) texelFetch(coverMap, place, 0)
#endif
    ivec2 low = max(min(ivec2(at), ivec2(ceil(last)) - 1), ivec2(0));
    vec2 f = (at - vec2(low)) / max(min(vec2(1.0), last - vec2(low)), vec2(1e-6)); // the last cell may be a part of one
    vec4 near[4] = vec4[](COVER_AT(low), COVER_AT(low + ivec2(1, 0)), COVER_AT(low + ivec2(0, 1)), COVER_AT(low + ivec2(1, 1)));
    if (near[0].a + near[1].a + near[2].a + near[3].a == 0.0) return;
    vec4 weight = vec4((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
    int layer[10];
    float share[10];
    float rules = 0.0;
    for (int i = 0; i < 4; ++i) {
        float painted = near[i].a * weight[i];
        rules += weight[i] - painted;
        layer[i] = int(near[i].r * 255.0 + 0.5) & 31;
        share[i] = painted * (1.0 - near[i].b);
        layer[i + 4] = int(near[i].g * 255.0 + 0.5);
        share[i + 4] = painted * near[i].b;
    }
    float most = max(c.firstShare + c.secondShare, 1e-4);
    layer[8] = c.first;
    share[8] = rules * c.firstShare / most;
    layer[9] = c.second;
    share[9] = rules * c.secondShare / most;
    c.firstShare = c.secondShare = 0.0;
    for (int i = 0; i < 10; ++i) {
        float all = 0.0;
        for (int j = 0; j < 10; ++j)
            all += layer[j] == layer[i] ? share[j] : 0.0;
        bool known = layer[i] == c.first && c.firstShare > 0.0;
        bool top = !known && all > c.firstShare;
        bool next = !known && !top && all > c.secondShare;
        c.second = top ? c.first : next ? layer[i] : c.second;
        c.secondShare = top ? c.firstShare : next ? all : c.secondShare;
        c.first = top ? layer[i] : c.first;
        c.firstShare = top ? all : c.firstShare;
    }
    c.first = min(c.first, LAYERS - 1);
    c.second = min(c.second, LAYERS - 1);
}
#endif

vec3 groundNormal(vec2 texel)
{
#ifdef WINDOWS
    float footprint = log2(max(max(length(dFdx(texel)), length(dFdy(texel))), 1e-3));
    float level = clamp(footprint, windowLevel(texel), float(terrain.windows - 1));
    float finer = floor(level), coarser = min(finer + 1.0, float(terrain.windows - 1));
    vec2 flat_ = mix(textureLod(groundNormals, vec3((texel * exp2(-finer) + 0.5) / float(terrain.windowSide), finer), 0.0).xy,
                     textureLod(groundNormals, vec3((texel * exp2(-coarser) + 0.5) / float(terrain.windowSide), coarser), 0.0).xy, level - finer);
#else
    vec2 flat_ = texture(groundNormals, (texel + 0.5) * terrain.texelSize).xy;
#endif
    return vec3(flat_.x, sqrt(max(1.0 - dot(flat_, flat_), 0.0025)), flat_.y);
}

float slopeOf(vec3 normal) // degrees
{
    return degrees(acos(clamp(normal.y, 0.0, 1.0)));
}

struct GroundNoise {
    vec4 near, far; // repeats every 47 m, every 613 m
};

GroundNoise groundNoise(vec2 metres)
{
    return GroundNoise(texture(noiseField, metres * (1.0 / 47.0)), texture(noiseField, metres.yx * (1.0 / 613.0)));
}

// The same for all of a quad of pixels.
Choice layersAt(vec2 texel, float height, vec3 normal, GroundNoise noise)
{
    float ragged = (noise.near.b - 0.5) * 1.1 + (noise.far.b - 0.5) * 1.3;
    vec4 where = vec4(quadShared(vec3(slopeOf(normal), height, ragged)), 0.0);
#ifdef FLOW
    where.w = quadShared(vec3(texture(groundFlow, texel * terrain.flowScale + 0.5 / vec2(textureSize(groundFlow, 0))).r, 0.0, 0.0)).x;
#endif
    // Later layers lie over earlier ones; of what then shows, keep the two largest shares. Written out layer by
    // layer: software GL reads a uniform block far faster by constant numbers than by a loop's.
    Choice choice = Choice(1.0, 0, 0, 0.0, 0.0);
#if LAYERS > 31
    consider(choice, 31, where);
#endif
#if LAYERS > 30
    consider(choice, 30, where);
#endif
#if LAYERS > 29
    consider(choice, 29, where);
#endif
#if LAYERS > 28
    consider(choice, 28, where);
#endif
#if LAYERS > 27
    consider(choice, 27, where);
#endif
#if LAYERS > 26
    consider(choice, 26, where);
#endif
#if LAYERS > 25
    consider(choice, 25, where);
#endif
#if LAYERS > 24
    consider(choice, 24, where);
#endif
#if LAYERS > 23
    consider(choice, 23, where);
#endif
#if LAYERS > 22
    consider(choice, 22, where);
#endif
#if LAYERS > 21
    consider(choice, 21, where);
#endif
#if LAYERS > 20
    consider(choice, 20, where);
#endif
#if LAYERS > 19
    consider(choice, 19, where);
#endif
#if LAYERS > 18
    consider(choice, 18, where);
#endif
#if LAYERS > 17
    consider(choice, 17, where);
#endif
#if LAYERS > 16
    consider(choice, 16, where);
#endif
#if LAYERS > 15
    consider(choice, 15, where);
#endif
#if LAYERS > 14
    consider(choice, 14, where);
#endif
#if LAYERS > 13
    consider(choice, 13, where);
#endif
#if LAYERS > 12
    consider(choice, 12, where);
#endif
#if LAYERS > 11
    consider(choice, 11, where);
#endif
#if LAYERS > 10
    consider(choice, 10, where);
#endif
#if LAYERS > 9
    consider(choice, 9, where);
#endif
#if LAYERS > 8
    consider(choice, 8, where);
#endif
#if LAYERS > 7
    consider(choice, 7, where);
#endif
#if LAYERS > 6
    consider(choice, 6, where);
#endif
#if LAYERS > 5
    consider(choice, 5, where);
#endif
#if LAYERS > 4
    consider(choice, 4, where);
#endif
#if LAYERS > 3
    consider(choice, 3, where);
#endif
#if LAYERS > 2
    consider(choice, 2, where);
#endif
#if LAYERS > 1
    consider(choice, 1, where);
#endif
    consider(choice, 0, where);
#ifdef PAINTED
    showPainted(choice, quadShared(vec3(texel, 0.0)).xy);
#endif
    return choice;
}
