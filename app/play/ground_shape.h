// The ground to Bullet's world: the triangles of the height map, without those of holes. It has no inside: what lies on it is kept
// up by app/play/ground_contacts.h, while rays and fast things meet these triangles.
#pragma once

#include "io/scene/scene.h"

#include <memory>

class btCollisionShape;
class btConcaveShape;

namespace play {

// Null: there is no ground. The scene must outlive it.
std::unique_ptr<btConcaveShape> groundShape(const io::Scene& scene);
bool isGround(const btCollisionShape& shape);
const io::Scene& sceneOf(const btCollisionShape& ground);

} // namespace play
