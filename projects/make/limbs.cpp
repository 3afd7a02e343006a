#include "projects/make/limbs.h"

#include <algorithm>
#include <cmath>

namespace make {

Ring ringAt(const Limb& limb, float share)
{
    const float place = std::clamp(share, 0.0f, 1.0f) * float(limb.rings.size() - 1);
    const std::size_t i = std::min(std::size_t(place), limb.rings.size() - 2);
    const float t = place - float(i);
    const Ring &a = limb.rings[i], &b = limb.rings[i + 1];
    return {.centre = glm::mix(a.centre, b.centre, t),
            .radius = glm::mix(a.radius, b.radius, t),
            .light = glm::mix(a.light, b.light, t)};
}

glm::vec3 directionAt(const Limb& limb, float share)
{
    const glm::vec3 step = ringAt(limb, share + 0.05f).centre - ringAt(limb, share - 0.05f).centre;
    return glm::normalize(step + glm::vec3{0, 1e-5f, 0});
}

Limb growTrunk(const TrunkPlan& plan, Random& random)
{
    Limb trunk;
    const glm::vec2 lean = glm::vec2{random.bell(), random.bell()} * plan.lean * 2.0f;
    glm::vec2 offset{0}, drift{0};
    for (int i = 0; i < plan.rings; ++i) {
        const float t = float(i) / float(plan.rings - 1);
        const float share = i == 0 ? 0 : std::pow(t, 1.45f); // rings stand closer at the foot
        const float height = i == 0 ? -0.35f : share * plan.height;
        if (i > 1) {
            drift = drift * 0.6f + glm::vec2{random.bell(), random.bell()} * plan.gnarl;
            offset += drift * (plan.height / float(plan.rings));
        }
        const glm::vec2 at = offset + lean * std::max(0.0f, height);
        const float taper = glm::mix(1.0f, plan.tipShare, std::pow(share, 0.9f));
        const float foot = 0.55f * std::exp(-std::max(0.0f, height) / (plan.radius * 2.2f));
        trunk.rings.push_back({.centre = {at.x, height, at.y},
                               .radius = plan.radius * taper * (1 + foot),
                               .flare = plan.flare * std::exp(-std::max(0.0f, height) / (plan.radius * 1.6f))});
    }
    return trunk;
}

Limb growLimb(const LimbPlan& plan, Random& random)
{
    Limb limb;
    glm::vec3 at = plan.from, direction = plan.direction;
    const float step = plan.length / float(plan.rings - 1);
    for (int i = 0; i < plan.rings; ++i) {
        const float t = float(i) / float(plan.rings - 1);
        limb.rings.push_back({.centre = at, .radius = glm::mix(plan.radius, plan.tipRadius, std::pow(t, 0.8f))});
        const glm::vec3 bend = random.direction() * plan.gnarl +
                               glm::vec3{0, plan.upturn / float(plan.rings) * 1.5f - plan.droop * t * 1.3f, 0};
        direction = glm::normalize(direction + bend);
        at += direction * step;
    }
    return limb;
}

} // namespace make
