// The exposure that makes the picture's light middle grey in the mean: a histogram of the logarithms of luminance at places
// spread evenly over it. The darkest and the brightest parts do not count, so that neither a lamp nor a cave's mouth decides.
#include "gbuffer_in.glsl"
#include "shared/bindings.h"
#include "shared/exposure.h"
#include "shared/film.h"

layout(local_size_x = EXPOSURE_BINS) in;
layout(binding = IMAGE_UNIT) uniform sampler2D image;
layout(std140, binding = PASS_BINDING) uniform MeteringBlock { Metering metering; };
layout(std430, binding = EXPOSURE_STORAGE_BINDING) buffer ChosenBlock { ChosenExposure chosen; };

const float kBin = (EXPOSURE_BRIGHTEST - EXPOSURE_DARKEST) / float(EXPOSURE_BINS);
const float kParts = 1024.0;      // of a bin, in which places within it are added
const float kDarkShare = 0.20;    // of all places, that do not count
const float kBrightShare = 0.05;
const float kDay = -6.5;          // EV, of land by day; the key falls below it, after Krawczyk et al., "Perceptual Effects in Real-Time Tone Mapping" (2005)

shared uint counts[EXPOSURE_BINS];
shared uint sums[EXPOSURE_BINS];

void look(ivec2 place)
{
    ivec2 size = textureSize(image, 0);
    ivec2 pixel = min((place * size + size / 2) / ivec2(EXPOSURE_WIDTH, EXPOSURE_HEIGHT), size - 1);
    bool drawn = texelFetch(gbufferDepth, pixel, 0).r > 0.0;
    // Aids to editing follow the exposure: they must not lead it.
    if (drawn && (surfaceBits(texelFetch(gbufferSurface, pixel, 0)) & SURFACE_UNLIT) != 0u) return;
    float l = luminance(texelFetch(image, pixel, 0).rgb);
    float at = l > 0.0 ? (log2(l) - EXPOSURE_DARKEST) / kBin : 0.0;
    at = clamp(at, 0.0, float(EXPOSURE_BINS) - 0.001);
    atomicAdd(counts[uint(at)], 1u);
    atomicAdd(sums[uint(at)], uint(fract(at) * kParts));
}

// EV, of what counts.
float meanBrightness(float total)
{
    float first = total * kDarkShare, last = total * (1.0 - kBrightShare);
    float below = 0.0, sum = 0.0;
    for (int i = 0; i < EXPOSURE_BINS; ++i) {
        float count = float(counts[i]);
        float taken = max(min(below + count, last) - max(below, first), 0.0);
        if (taken > 0.0) sum += taken * (float(i) + float(sums[i]) / (count * kParts));
        below += count;
    }
    return EXPOSURE_DARKEST + kBin * sum / (last - first);
}

void main()
{
    uint own = gl_LocalInvocationID.x;
    counts[own] = 0u;
    sums[own] = 0u;
    barrier();
    for (uint i = own; i < uint(EXPOSURE_WIDTH * EXPOSURE_HEIGHT); i += uint(EXPOSURE_BINS))
        look(ivec2(i % uint(EXPOSURE_WIDTH), i / uint(EXPOSURE_WIDTH)));
    barrier();
    if (own != 0u) return;
    float total = 0.0;
    for (int i = 0; i < EXPOSURE_BINS; ++i)
        total += float(counts[i]);
    float target = chosen.ev;
    if (total > 0.0) {
        float mean = meanBrightness(total);
        target = log2(MIDDLE_GREY) - mean + metering.compensation - metering.darkness * max(kDay - mean, 0.0);
    }
    target = clamp(target, metering.lowest, metering.highest);
    chosen.target = target;
    chosen.before = chosen.exposure;
    chosen.ev = metering.share < 1.0 ? mix(chosen.ev, target, metering.share) : target; // to the bit, whatever was before
    chosen.exposure = exp2(chosen.ev);
}
