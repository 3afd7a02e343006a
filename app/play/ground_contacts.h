// Where a body touches the ground. Triangles have no inside to be pushed out of, and asking Bullet for each of them would cost most of a
// step. But over a height map it is known at once what is below it: corners of the body against the triangle they are over, and
// ridges of the ground against the sides of the body.
#pragma once

#include "app/play/bulk.h"

class btCollisionAlgorithm;
class btCollisionDispatcher;
class btCollisionObject;

namespace play {

constexpr int kGroundContactsSize = 320; // bytes, for which the pool of the dispatcher must have room

// For Bullet's pair of the two, which owns it. A body whose centre is below the ground is not met: it is in a cave.
btCollisionAlgorithm* groundContacts(btCollisionDispatcher& dispatcher, const Bulk& bulk, const btCollisionObject& body, const btCollisionObject& ground);

} // namespace play
