// Irradiance of the sky as spherical harmonics of order 2 (Ramamoorthi and Hanrahan 2001), one work group.
#include "shared/bindings.h"
#include "sky_tables.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = SKY_LIGHT_STORAGE_BINDING) writeonly buffer SkyLightBlock { SkyLight skyLight; };

shared vec3 sums[64][9];

const int kRows = 32;
const int kColumns = 64; // one a thread

void main()
{
    uint column = gl_LocalInvocationID.x;
    vec3 coefficients[9];
    for (int i = 0; i < 9; ++i)
        coefficients[i] = vec3(0.0);
    for (int row = 0; row < kRows; ++row) {
        float y = 1.0 - (2.0 * float(row) + 1.0) / float(kRows);
        float angle = (float(column) + 0.5) * (2.0 * 3.14159265 / float(kColumns));
        float s = sqrt(1.0 - y * y);
        vec3 d = vec3(s * cos(angle), y, s * sin(angle));
        vec3 l = skyView(d) * (4.0 * 3.14159265 / float(kRows * kColumns));
        coefficients[0] += l * 0.282095;
        coefficients[1] += l * 0.488603 * d.y;
        coefficients[2] += l * 0.488603 * d.z;
        coefficients[3] += l * 0.488603 * d.x;
        coefficients[4] += l * 1.092548 * d.x * d.y;
        coefficients[5] += l * 1.092548 * d.y * d.z;
        coefficients[6] += l * 0.315392 * (3.0 * d.z * d.z - 1.0);
        coefficients[7] += l * 1.092548 * d.x * d.z;
        coefficients[8] += l * 0.546274 * (d.x * d.x - d.y * d.y);
    }
    for (int i = 0; i < 9; ++i)
        sums[column][i] = coefficients[i];
    barrier();
    if (column < 9u) {
        vec3 total = vec3(0.0);
        for (int i = 0; i < kColumns; ++i)
            total += sums[i][column];
        // The cosine lobe, divided by pi: 1, 2/3, 1/4 by order.
        float lobe = column == 0u ? 1.0 : column < 4u ? 2.0 / 3.0 : 0.25;
        skyLight.irradiance[column] = vec4(total * lobe, 0.0);
        sums[0][column] = total * lobe;
    }
    barrier();
    if (column == 0u) // as skyIrradiance() of a direction that is mostly none, (0, 0.4, 0)
        skyLight.haze = vec4(max(sums[0][0] * 0.282095 + sums[0][1] * (0.4 * 0.488603) - sums[0][6] * 0.315392, vec3(0.0)), 0.0);
}
