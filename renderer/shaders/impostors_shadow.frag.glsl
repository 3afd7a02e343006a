// The outline of an impostor, for the shadow that it casts: the frame seen from nearest to the sun.
#include "shared/bindings.h"
#include "shared/impostor.h"

layout(binding = BASE_COLOUR_UNIT) uniform sampler2DArray colours;
layout(location = 0) in vec2 place;
layout(location = 1) flat in vec4 frame;

const float kEdge = 0.5 / float(IMPOSTOR_FRAME_TEXELS);

void main()
{
    vec2 texels = vec2((IMPOSTOR_FRAME_TEXELS * IMPOSTOR_FRAMES) >> int(frame.w));
    vec2 at = (frame.xy + clamp(place, kEdge, 1.0 - kEdge)) / float(IMPOSTOR_FRAMES);
    if (texelFetch(colours, ivec3(at * texels, frame.z), int(frame.w)).a < 0.5) discard;
}
