// Four texels of an impostor to one: what each covers counts, so nothing dark comes in from the edges.
#include "impostor.glsl"
#include "shared/bindings.h"

layout(binding = BASE_COLOUR_UNIT) uniform sampler2D colours;
layout(binding = NORMAL_UNIT) uniform sampler2D surfaces;
layout(location = 0) out vec4 outColour;
layout(location = 1) out vec4 outSurface;

void main()
{
    ivec2 first = ivec2(gl_FragCoord.xy) * 2;
    ImpostorTexel sum = ImpostorTexel(vec3(0.0), 0.0, vec3(0.0, 1e-4, 0.0), 0.0, 0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 place = first + ivec2(i & 1, i >> 1);
        ImpostorTexel t = loaded(texelFetch(colours, place, 0), texelFetch(surfaces, place, 0));
        sum.root += t.root * t.root * t.cover; // light is what adds up
        sum.normal += t.normal * t.cover;
        sum.depth += t.depth * t.cover;
        sum.leaf += t.leaf * t.cover;
        sum.cover += t.cover;
    }
    float scale = 1.0 / max(sum.cover, 1e-3);
    ImpostorStore s = stored(ImpostorTexel(sqrt(sum.root * scale), sum.cover * 0.25, normalize(sum.normal), sum.depth * scale, sum.leaf * scale));
    outColour = s.colour;
    outSurface = s.surface;
}
