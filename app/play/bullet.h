// Between GLM's types and Bullet's. For the sources of this folder; no header that others include shows Bullet.
#pragma once

#include "io/scene/bounds.h"

#include <LinearMath/btTransform.h>
#include <glm/gtc/quaternion.hpp>

namespace play {

inline btVector3 bullet(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}
inline glm::dvec3 plain(const btVector3& v)
{
    return {v.x(), v.y(), v.z()};
}
inline btQuaternion bullet(const glm::dquat& q)
{
    return {q.x, q.y, q.z, q.w};
}
inline glm::dquat plain(const btQuaternion& q)
{
    return {q.w(), q.x(), q.y(), q.z()};
}

} // namespace play
