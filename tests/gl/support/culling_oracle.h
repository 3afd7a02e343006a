// The oracle of culling: an object that owns a pixel while nothing is culled owns one, too, while things are.
#pragma once

#include "tests/gl/support/shared_renderer.h"

#include <cstdint>
#include <functional>
#include <random>

namespace test {

// Boxes of many shapes in the hills: turned, stretched, mirrored, some beside their own origin, long walls and towers
// among them that hide the rest.
TestWorld oracleWorld(int objects);

io::Camera cameraIn(const TestWorld& world, std::mt19937& random); // above the ground, looking anywhere

struct OracleCounts {
    std::uint64_t cameras = 0;
    std::uint64_t ids = 0;           // that own a pixel while nothing is culled
    std::uint64_t cpuMissing = 0;    // of those, with the CPU culling
    std::uint64_t gpuCutMissing = 0; // with the GPU, in the first frame of a camera
    std::uint64_t gpuMissing = 0;    // in the next, which knows what that saw
    std::uint64_t drawn = 0;         // instances, by the CPU
    std::uint64_t gpuDrawn = 0;      // by the GPU, which leaves out what others hide; about
    std::uint64_t tooSmall = 0;      // in view, left out for their size

    std::uint64_t missing() const { return cpuMissing + gpuCutMissing + gpuMissing; }
};

struct Missing {
    const char* how = ""; // "cpu", "gpu after a cut", "gpu"
    io::Camera camera;
    std::uint32_t id = 0;
    std::uint32_t pixels = 0; // that it should own
};

// Draws one camera's four pictures of the loaded world, and counts what they disagree about.
void askOracle(const io::Camera& camera, glm::ivec2 size, OracleCounts& counts,
               const std::function<void(const Missing&)>& tell = {});

} // namespace test
