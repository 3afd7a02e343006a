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

io::Template fireLook()
{
    return {.alignToGround = true,
            .footprint = 1.1f,
            .light = {.kind = io::LightKind::Point,
                      .colour = {1, 0.5f, 0.18f},
                      .intensity = 0.35f,
                      .range = 12,
                      .offset = {0, 0.6f, 0},
                      .castShadow = true},
            .particles = {.kind = io::ParticleKind::Fire,
                          .rate = 46,
                          .life = 0.95f,
                          .size = 0.42f,
                          .rise = 0.55f,
                          .spread = 0.24f,
                          .offset = {0, 0.12f, 0}}};
}
io::ParticleSource smokeOfFire()
{
    return {.kind = io::ParticleKind::Smoke, .rate = 7, .life = 7, .size = 1.3f, .rise = 1.2f, .spread = 0.12f, .offset = {0, 0.75f, 0}};
}

} // namespace make
