// The simple player's shape: a box along the world's axes. Swept against a convex solid it is a point swept against their
// Minkowski sum, whose faces are normal to those of either or to two edges at once.
#pragma once

#include "app/play/narrow.h"

namespace play {

std::optional<Contact> boxContact(const glm::dvec3& half, const glm::dvec3& at, const Thing& thing, double reach);
std::optional<Hit> sweepBox(const glm::dvec3& half, const glm::dvec3& from, const glm::dvec3& motion, const Thing& thing);

} // namespace play
