// One context and one renderer for the whole test program, and short ways to draw and look.
#pragma once

#include "renderer/renderer.h"
#include "tests/gl/support/test_world.h"

namespace test {

bool haveContext(); // made at the first call; the fault is printed once
renderer::Renderer& shared();

// An environment that is easy to reason about: no clouds, no fog, a lens without faults, the sun where it is put.
io::Environment plainEnvironment(float azimuth, float elevation);

void load(TestWorld& world);
renderer::FrameInput frame(glm::ivec2 size, const io::Camera& camera);

// Mean brightness (0..255) of the picture around where a place of the world shows.
double brightnessAt(const io::Image& image, const io::Camera& camera, const glm::dvec3& place, int radius = 1);

} // namespace test
