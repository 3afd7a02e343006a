#include "projects/make/looks.h"

namespace make {

io::Template treeLook(float footprint, float sink, float wind)
{
    return {.scale = {0.85f, 1.18f},
            .tilt = 2.5f,
            .sink = sink,
            .collision = io::Collision::Capsule,
            .footprint = footprint,
            .impostor = true,
            .wind = wind};
}
io::Template stoneLook(glm::vec2 scale, float sink, float tilt)
{
    return {.scale = scale, .tilt = tilt, .alignToGround = true, .sink = sink, .footprint = 0.5f, .impostor = true};
}
io::Template plantLook(glm::vec2 scale, float sink)
{
    return {.scale = scale, .tilt = 5, .sink = sink, .collision = io::Collision::None, .impostor = true, .wind = 0.8f};
}
io::Template tuftLook(glm::vec2 scale)
{
    io::Template look = plantLook(scale, 0.02f);
    look.alignToGround = true;
    look.castShadow = false;
    look.impostor = false;
    look.wind = 1;
    return look;
}
io::Template builtLook(float footprint, float sink)
{
    return {.sink = sink, .footprint = footprint};
}

} // namespace make
