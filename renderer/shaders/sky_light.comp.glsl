// Irradiance of the sky as spherical harmonics of order 2 (Ramamoorthi and Hanrahan 2001), one work group. Clouds hide a part
// of the sky and shine themselves; a closed cover lets about a quarter of all light through (Kasten and Czeplak, "Solar and
// terrestrial radiation dependent on the amount and type of cloud", 1980), as grey as what comes from above.
#include "clouds.glsl"
#include "shared/bindings.h"
#include "sky_tables.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = SKY_LIGHT_STORAGE_BINDING) writeonly buffer SkyLightBlock { SkyLight skyLight; };

shared vec3 sums[64][10];   // of the clear sky that is seen; the last: its irradiance on level ground without clouds
shared float covered[64][9]; // of the clouds before it, per radiance of their mean

const int kRows = 32;
const int kColumns = 64; // one a thread

// Share of the sky that clouds hide at a height: towards the horizon one sees their sides too.
float hiddenAt(float up)
{
    float aside = 1.0 - up;
    float cover = clouds.cover * clouds.on;
    return up <= 0.0 ? 0.0 : mix(cover, 1.0 - (1.0 - cover) * (1.0 - cover), aside * aside);
}

void addHarmonics(inout vec3 c[9], vec3 l, vec3 d)
{
    c[0] += l * 0.282095;
    c[1] += l * 0.488603 * d.y;
    c[2] += l * 0.488603 * d.z;
    c[3] += l * 0.488603 * d.x;
    c[4] += l * 1.092548 * d.x * d.y;
    c[5] += l * 1.092548 * d.y * d.z;
    c[6] += l * 0.315392 * (3.0 * d.z * d.z - 1.0);
    c[7] += l * 1.092548 * d.x * d.z;
    c[8] += l * 0.546274 * (d.x * d.x - d.y * d.y);
}

// Irradiance over pi under a closed cover: what comes through, and comes back from the ground and the clouds again and again.
vec3 underCover(vec3 clearSky)
{
    vec3 sun = clouds.sun / max(light.sunAbove, vec3(1e-6)) * (max(light.towardSun.y, 0.0) / 3.14159265);
    return (sun + clearSky) * (clouds.through / (1.0 - clouds.albedo * (1.0 - clouds.through)));
}

// Mean radiance of clouds as they are seen from below: grey where they close, bright with sunlit sides where few stand.
vec3 cloudMean(vec3 overcast, vec3 clearSky)
{
    vec3 sides = clouds.sun / max(light.sunAbove, vec3(1e-6)) * (0.1 * clamp(light.towardSun.y * 2.2, 0.0, 1.0)); // a low sun's fall on few
    return mix(sides + clearSky * 0.7 + overcast * 0.3, overcast, smoothstep(0.3, 0.95, clouds.cover));
}

void main()
{
    uint column = gl_LocalInvocationID.x;
    vec3 seen[9];
    vec3 hidden[9]; // x alone counts
    for (int i = 0; i < 9; ++i)
        seen[i] = hidden[i] = vec3(0.0);
    vec3 level = vec3(0.0);
    for (int row = 0; row < kRows; ++row) {
        float y = 1.0 - (2.0 * float(row) + 1.0) / float(kRows);
        float angle = (float(column) + 0.5) * (2.0 * 3.14159265 / float(kColumns));
        float s = sqrt(1.0 - y * y);
        vec3 d = vec3(s * cos(angle), y, s * sin(angle));
        float share = 4.0 * 3.14159265 / float(kRows * kColumns);
        vec3 l = skyView(d) * share;
        float behind = hiddenAt(y);
        level += l * (max(y, 0.0) / 3.14159265);
        float lit = y < 0.0 ? 1.0 - clouds.cover * clouds.on * (1.0 - clouds.through) : 1.0; // the ground below
        addHarmonics(seen, l * ((1.0 - behind) * lit), d);
        addHarmonics(hidden, vec3(behind * share * (1.0 + 2.0 * y) * (3.0 / 7.0)), d);
    }
    for (int i = 0; i < 9; ++i) {
        sums[column][i] = seen[i];
        covered[column][i] = hidden[i].x;
    }
    sums[column][9] = level;
    barrier();
    if (column < 9u) {
        vec3 total = vec3(0.0);
        vec3 clear = vec3(0.0);
        float behind = 0.0;
        for (int i = 0; i < kColumns; ++i) {
            total += sums[i][column];
            clear += sums[i][9];
            behind += covered[i][column];
        }
        vec3 overcast = underCover(clear);
        total += behind * cloudMean(overcast, clear);
        if (column == 0u) {
            skyLight.clear = vec4(clear, 0.0);
            skyLight.overcast = vec4(overcast, 0.0);
        }
        // The cosine lobe, divided by pi: 1, 2/3, 1/4 by order.
        float lobe = column == 0u ? 1.0 : column < 4u ? 2.0 / 3.0 : 0.25;
        skyLight.irradiance[column] = vec4(total * lobe, 0.0);
        sums[0][column] = total * lobe;
    }
    barrier();
    if (column == 0u) // as skyIrradiance() of a direction that is mostly none, (0, 0.4, 0)
        skyLight.haze = vec4(max(sums[0][0] * 0.282095 + sums[0][1] * (0.4 * 0.488603) - sums[0][6] * 0.315392, vec3(0.0)), 0.0);
}
