// How much of its neighbour a pixel takes over, after Jimenez et al., "SMAA" (2012), sections 3 and 4.2, without tables: an
// edge runs along a straight line as long as nothing crosses it, and what crosses it at its ends says to which side the true
// edge leans there. Between such an end and the middle of the line the true edge is a straight one; the area under it is
// known in closed form.
// Red: of the pixel below, for this one; green: of this one, for the pixel below; blue and alpha: likewise to the left.
#include "shared/bindings.h"

layout(binding = HISTORY_UNIT) uniform sampler2D edges; // red: to the left; green: below
layout(location = 0) out vec4 weights;

const int kReach = 32; // pixels that an edge is followed to each side
const float kSharpness = 1.0; // of corners, 0..1: how much less they are smoothed

vec2 edgesAt(ivec2 pixel)
{
    return texelFetch(edges, clamp(pixel, ivec2(0), textureSize(edges, 0) - 1), 0).rg;
}

// The end of an edge: how far away, and by how much the true edge rises there (-0.5 .. 0.5 pixels, into this pixel's row).
struct End {
    float distance_;
    float rise;
};

// `along` steps from pixel to pixel of the edge, `across` leads over it; `own` and `other` select the channel of edges
// along it and of those that cross it.
End follow(ivec2 pixel, ivec2 along, ivec2 across, vec2 own, vec2 other)
{
    // A pixel's crossing edge lies at its left (or lower) side: forwards, that is the next pixel's.
    ivec2 crossing = along.x + along.y > 0 ? along : ivec2(0);
    for (int i = 0; i < kReach; ++i) {
        ivec2 p = pixel + along * i;
        float up = dot(edgesAt(p + crossing), other);
        float down = dot(edgesAt(p + crossing - across), other);
        if (up + down > 0.0) {
            // An edge that goes on across is a corner of the thing itself, not a step of a slanted edge.
            up *= 1.0 - kSharpness * dot(edgesAt(p + crossing + across), other);
            down *= 1.0 - kSharpness * dot(edgesAt(p + crossing - 2 * across), other);
            return End(float(i), 0.5 * (up - down));
        }
        if (dot(edgesAt(p + along), own) == 0.0) return End(float(i), 0.0);
    }
    return End(float(kReach), 0.0);
}

// Area between edge and true edge over the pixel, on its own side (x) and on the other (y).
vec2 areas(End back, End ahead)
{
    float length_ = back.distance_ + ahead.distance_ + 1.0;
    float middle = 0.5 * length_;
    float from = back.distance_, to = from + 1.0;
    float until = min(to, middle), since = max(from, middle);
    float first = max(until - from, 0.0) * back.rise * (1.0 - (from + until) / length_);
    float second = max(to - since, 0.0) * ahead.rise * ((since + to) / length_ - 1.0);
    return vec2(max(first, 0.0) + max(second, 0.0), max(-first, 0.0) + max(-second, 0.0));
}

void main()
{
    ivec2 p = ivec2(gl_FragCoord.xy);
    vec2 here = edgesAt(p);
    weights = vec4(0.0);
    if (here.x + here.y == 0.0) discard;
    const vec2 kLeft = vec2(1, 0), kBelow = vec2(0, 1);
    const ivec2 kX = ivec2(1, 0), kY = ivec2(0, 1);
    if (here.y > 0.0) weights.rg = areas(follow(p, -kX, kY, kBelow, kLeft), follow(p, kX, kY, kBelow, kLeft));
    if (here.x > 0.0) weights.ba = areas(follow(p, -kY, kX, kLeft, kBelow), follow(p, kY, kX, kLeft, kBelow));
}
