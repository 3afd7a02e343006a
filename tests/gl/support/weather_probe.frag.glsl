// A rough dark surface under the weather: its normal falls from straight up to straight down along x, its place goes along y.
#include "weather_surface.glsl"

layout(location = 0) out vec4 value;

void main()
{
    float up = 1.0 - 2.0 * floor(gl_FragCoord.x) / 63.0;
    vec3 normal = vec3(sqrt(max(1.0 - up * up, 0.0)), up, 0.0);
    vec3 colour = vec3(0.2);
    float roughness = 0.9;
    float metallic = 0.0;
    weatherSurface(colour, roughness, metallic, normal, vec3(gl_FragCoord.y * 17.0, 0.0, gl_FragCoord.y * 9.0));
    value = vec4(colour.g, roughness, metallic, up);
}
