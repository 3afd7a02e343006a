// A vertex of a tessellated patch. Between texels (or samples of a window) it lies on the map's triangles (io::HeightGrid): whatever the patch, so that
// neighbours meet.
#include "terrain_surface.glsl"

layout(quads, fractional_even_spacing, cw) in;

layout(location = 0) patch in vec4 patchIn;

invariant gl_Position;

layout(location = 0) out vec3 place;
#ifdef LEVELS
layout(location = 1) flat out float level;
#endif

void main()
{
    vec2 texel = min(patchIn.xy + gl_TessCoord.xy * (patchIn.z * float(TERRAIN_QUADS)), terrain.lastTexel);
    float stride = strideOf(patchIn.z);
    vec2 low = min(floor(texel / stride), max(ceil(terrain.lastTexel / stride) - 1.0, 0.0));
    vec2 span = min((low + 1.0) * stride, terrain.lastTexel) - low * stride; // shorter at the map's edge
    vec2 f = (texel - low * stride) / max(span, vec2(1e-6));
    float right = heightAt((low + vec2(1.0, 0.0)) * stride, stride), below = heightAt((low + vec2(0.0, 1.0)) * stride, stride);
    bool upper = f.x + f.y <= 1.0;
    float corner = heightAt((upper ? low : low + vec2(1.0)) * stride, stride);
    float height = corner + (right - corner) * (upper ? f.x : 1.0 - f.y) + (below - corner) * (upper ? f.y : 1.0 - f.x);

    gl_Position = clipPosition(texel, height);
    place = vec3(texel, height);
#ifdef LEVELS
    level = log2(patchIn.z);
#endif
}
