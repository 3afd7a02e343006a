// Straight up from places 320 m apart: what the layer lets through, and the volumes.
#include "cloud_field.glsl"
#include "clouds_layer.glsl"
#include "clouds_volume.glsl"

layout(location = 0) out vec4 value;

void main()
{
    vec2 relative = gl_FragCoord.xy * 320.0;
    float layer = 1.0 - layerHiding(cloudField(cloudPlace(relative), 0.0));
    float tau = 0.0;
    const int kSteps = 50;
    for (int i = 0; i < kSteps; ++i)
        tau += cloudExtinction(vec3(relative.x, 0.0, relative.y), (float(i) + 0.5) / float(kSteps), 0.0, true);
    value = vec4(layer, exp(-tau * clouds.thickness / float(kSteps)), 0.0, 1.0);
}
