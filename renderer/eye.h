// Where the frame is seen from: the camera's matrices in doubles, and the block that shaders read.
#pragma once

#include "io/scene/camera.h"
#include "renderer/renderer.h"
#include "renderer/shaders/shared/view.h"

#include <array>
#include <glm/glm.hpp>

namespace renderer {

struct Eye {
    glm::dvec3 position{0};        // m, world
    glm::dmat4 clipFromRelative{1};
    glm::dvec3 forward{0, 0, -1};
    glm::dvec3 right{1, 0, 0};     // unit
    glm::dvec3 up{0, 1, 0};
    double tanHalfFov = 1;         // vertical
    double aspect = 1;
    glm::ivec2 size{1};            // pixels
};

Eye eyeOf(const io::Camera& camera, glm::ivec2 size);
double pixelAngle(const Eye& eye); // rad, of a pixel in the picture's middle

// `clipFromRelative` may be a shadow cascade's; the rest is the eye's.
glsl::View viewBlock(const Eye& eye, const glm::dmat4& clipFromRelative, double time, double exposure);
glsl::View movedAside(glsl::View view, const Eye& eye, const glm::dvec2& by); // of the picture's half size

// The space that a view can see, as planes in metres from the world's origin: inside where dot(n, p) + d >= 0.
struct Volume {
    std::array<glm::dvec4, 5> planes;
};
Volume volumeOf(const Eye& eye);

} // namespace renderer
