// Share of the sun's light that comes past what is in the shadow maps, and past the mountains beyond them.
#include "light.glsl"
#include "shadows_block.glsl"
#include "view.glsl"

layout(binding = SHADOW_UNIT) uniform sampler2DArrayShadow shadowMaps;
layout(binding = GROUND_SHADOW_UNIT) uniform sampler2D groundShadow;

// The cascade in which what is so far from the eye lies, m.
int cascadeAt(float away)
{
    float before = dot(vec4(greaterThan(vec4(away), shadows.ends)), vec4(1.0));
    return int(before) + (away > shadows.fifthEnd ? 1 : 0);
}

// How much of a shadow is the next cascade's, which takes over towards the end of each.
float shareOfNext(float away, int cascade)
{
    return clamp((away - shadows.cascade[cascade].blendFrom) * shadows.cascade[cascade].blendScale, 0.0, 1.0);
}

#ifdef SHADOWS
// Where a place is looked up: out of the slope it lies on, by as much as a filter of `reach` texels would see of it.
vec3 shadowPlace(vec3 relative, vec3 normal, int cascade, float reach)
{
    float cosine = clamp(dot(normal, shadows.towardLight), 0.0, 1.0);
    float along = shadows.bias * 0.5 * reach * sqrt(1.0 - cosine * cosine);
    vec3 lifted = relative + (normal * along + shadows.towardLight * shadows.depthBias) * shadows.cascade[cascade].texel;
    return (shadows.cascade[cascade].textureFromRelative * vec4(lifted, 1.0)).xyz;
}

// The weights of a tent's texels -1, 0, 1 … from a place, two of which lie under each tap: their sums, and the tap's place
// between the two. `first` is the distance from the place to the first texel.
vec2 tentPair(float first, float reach)
{
    vec2 weights = max(vec2(reach) - abs(vec2(first, first + 1.0)), 0.0);
    float sum = weights.x + weights.y;
    return vec2(sum, first + weights.y / max(sum, 1e-5));
}

// A tent of `reach` texels to either side over the comparison with each texel. A bilinear tap compares two by two, so the
// tent is as many taps wide as texels reach (after Castano, "Shadow Mapping Summary", 2013).
float tentFiltered(vec3 place, int cascade, float reach, int taps)
{
    float stretch = max(reach / float(taps), 1.0);
    vec2 at = place.xy * shadows.resolution;
    vec2 first = vec2(1 - taps) - fract(at - 0.5); // texel centres lie at halves
    float sum = 0.0;
    vec2 all = vec2(0.0);
    for (int y = 0; y < taps; ++y) {
        vec2 row = tentPair(first.y + float(2 * y), reach / stretch);
        all.y += row.x;
        all.x = 0.0;
        for (int x = 0; x < taps; ++x) {
            vec2 column = tentPair(first.x + float(2 * x), reach / stretch);
            all.x += column.x;
            vec2 tap = (at + vec2(column.y, row.y) * stretch) / shadows.resolution;
            sum += row.x * column.x * texture(shadowMaps, vec4(tap, float(cascade), place.z));
        }
    }
    return sum / (all.x * all.y);
}

// The narrowest of them with its weights written out: a third cheaper on software GL. Less than 2 texels pull its taps together.
float tentOfFour(vec3 place, int cascade, float reach)
{
    vec2 at = place.xy * shadows.resolution;
    vec2 s = fract(at - 0.5);
    vec2 low = 3.0 - 2.0 * s, high = 1.0 + 2.0 * s;
    float texel = 1.0 / shadows.resolution, scale = reach * 0.5 * texel;
    vec2 first = place.xy + ((2.0 - s) / low - 1.0 - s) * scale, second = place.xy + (s / high + 1.0 - s) * scale;
    float layer = float(cascade);
    float sum = low.x * low.y * texture(shadowMaps, vec4(first, layer, place.z));
    sum += high.x * low.y * texture(shadowMaps, vec4(second.x, first.y, layer, place.z));
    sum += low.x * high.y * texture(shadowMaps, vec4(first.x, second.y, layer, place.z));
    sum += high.x * high.y * texture(shadowMaps, vec4(second, layer, place.z));
    return sum / 16.0;
}

#ifdef CONTACT_SHADOWS
layout(binding = SHADOW_DEPTH_UNIT) uniform sampler2DArray shadowDepths;

const float kSharpest = 1.5;   // texels to either side; less would show them
const int kSearchStride = 4;   // texels from one look at 2 x 2 of them to the next
const int kSearchLooks = 5;    // along a side: over MOST_PENUMBRA to either side

// Half the width of the penumbra at a place, texels: the sun's width as seen past what blocks it (Fernando, "Percentage-
// Closer Soft Shadows", 2005). Looks lie on texels of the world, and weights fade to the sides, so nothing jumps when a
// place moves on. The place's own slope rises towards the light to one side: it is no blocker.
float penumbraAt(vec3 place, int cascade, float slope)
{
    ShadowCascade c = shadows.cascade[cascade];
    vec2 at = place.xy * shadows.resolution;
    vec2 first = floor((at - MOST_PENUMBRA) / float(kSearchStride)) * float(kSearchStride);
    float rise = slope * c.texel / c.depthRange;
    float depths = 0.0, weights = 0.0;
    for (int y = 0; y < kSearchLooks; ++y)
        for (int x = 0; x < kSearchLooks; ++x) {
            vec2 corner = first + vec2(x, y) * float(kSearchStride) + 1.0; // shared by the four
            vec4 depth = textureGather(shadowDepths, vec3(corner / shadows.resolution, float(cascade)));
            vec2 low = corner - 0.5 - at, high = low + 1.0;
            vec4 dx = vec4(low.x, high.x, high.x, low.x), dy = vec4(high.y, high.y, low.y, low.y);
            vec4 distances = sqrt(dx * dx + dy * dy);
            vec4 weight = max(MOST_PENUMBRA - distances, 0.0) * vec4(lessThan(depth, place.z - rise * distances));
            depths += dot(depth, weight);
            weights += dot(weight, vec4(1.0));
        }
    float blocked = weights > 0.0 ? (place.z - depths / weights) * c.depthRange : 0.0;
    return clamp(min(blocked, c.contactReach) * c.penumbra, kSharpest, MOST_PENUMBRA);
}
#endif

// What one cascade's map says.
float shadowIn(int cascade, vec3 relative, vec3 normal)
{
#ifdef CONTACT_SHADOWS
    float reach = shadows.reach;
    if (cascade < CONTACT_CASCADES) {
        float cosine = clamp(dot(normal, shadows.towardLight), 0.05, 1.0);
        reach = penumbraAt(shadowPlace(relative, normal, cascade, kSharpest), cascade, sqrt(1.0 - cosine * cosine) / cosine);
    }
    return tentFiltered(shadowPlace(relative, normal, cascade, reach), cascade, reach, min(int(ceil(reach)), MOST_TAPS));
#else
    vec3 place = shadowPlace(relative, normal, cascade, shadows.reach);
#if SHADOW_TAPS == 2
    return tentOfFour(place, cascade, shadows.reach);
#else
    return tentFiltered(place, cascade, shadows.reach, SHADOW_TAPS);
#endif
#endif
}

#endif // SHADOWS

// How far a ray towards the light goes, m along the ground, until it is over the ground that throws shadows: 0 there,
// negative where it never is. Borders are the middles of texels.
float wayToGround(vec2 place, vec2 direction)
{
    vec2 border = 0.5 / vec2(textureSize(groundShadow, 0));
    vec2 speed = direction * light.groundShadow.xy;
    speed += mix(vec2(-1e-12), vec2(1e-12), greaterThanEqual(speed, vec2(0.0)));
    vec2 one = (border - place) / speed, other = (1.0 - border - place) / speed;
    vec2 enters = min(one, other), leaves = max(one, other);
    float entered = max(max(enters.x, enters.y), 0.0);
    return entered <= min(leaves.x, leaves.y) ? entered : -1.0;
}

// Beyond the shadow maps: whether a mountain stands before the sun. The light climbs from a place beyond the map's edge to it.
float sunOverGround(vec3 relative)
{
    vec2 place = relative.xz * light.groundShadow.xy + light.groundShadow.zw;
    vec2 direction = shadows.towardLight.xz / max(length(shadows.towardLight.xz), 1e-4);
    float way = wayToGround(place, direction);
    if (way < 0.0) return 1.0;
    place += direction * light.groundShadow.xy * way;
    float shadow = textureLod(groundShadow, place, 0.0).r - way * shadows.climb - view.eyeHeight;
    float soft = 1.5 + length(relative) * 0.004;
    return smoothstep(-soft, soft, relative.y - shadow + soft);
}

#ifdef NOISE_BLEND
// Of places in the world, so that it stays where it is when the camera turns.
float placeNoise(vec3 relative, float away)
{
    float side = exp2(floor(log2(max(away, 1.0) * view.pixelAngle)));
    vec3 place = floor((mod(view.eyeHigh, 64.0) + view.eyeLow + relative) / side);
    return interleavedNoise(place.xz + 17.0 * place.y);
}
#endif

// Share of the sun that reaches a place. Cascades end at a distance from the eye, so that none changes when the camera turns.
// Where one turns into the next, both are mixed, or with NOISE_BLEND noise picks one for each place of about a pixel: software GL runs
// both sides of a branch, and a loop in its place costs a third more of all shadows.
float sunVisibility(vec3 relative, vec3 normal)
{
#ifdef SHADOWS
    float away = length(relative);
    int cascade = cascadeAt(away);
    float next = shareOfNext(away, cascade);
#ifdef NOISE_BLEND
    float lit = shadowIn(cascade + (next > placeNoise(relative, away) ? 1 : 0), relative, normal);
#else
    float lit = shadowIn(cascade, relative, normal);
    if (next > 0.0) lit = mix(lit, shadowIn(cascade + 1, relative, normal), next);
#endif
    float ended = clamp((away - shadows.fadeFrom) * shadows.fadeScale, 0.0, 1.0);
    return mix(lit, sunOverGround(relative), ended * ended * (3.0 - 2.0 * ended));
#else
    return 1.0;
#endif
}
