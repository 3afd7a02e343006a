// How loud a sound is on its way from its place to its radius, and changes of the curve that says so.
#pragma once

#include "io/scene/template.h"

#include <cstddef>
#include <span>
#include <vector>

namespace io {

float falloffAt(std::span<const FalloffKey> keys, float at); // `at`: share of the radius, 0..1; no keys: 1 - at, squared

// The first key of a curve that had none brings its ends along. Answers which one it is.
std::size_t addFalloffKey(std::vector<FalloffKey>& keys, FalloffKey key);
// It stays between its neighbours.
void moveFalloffKey(std::vector<FalloffKey>& keys, std::size_t index, FalloffKey to);

} // namespace io
