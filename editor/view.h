// View: the eye through which a world is looked at, and the pixels it is looked at with.
#pragma once

#include "io/scene/bounds.h"
#include "io/scene/camera.h"

#include <glm/glm.hpp>
#include <optional>

namespace editor {

struct View {
    io::Camera camera;
    glm::ivec2 size{1280, 720}; // pixels, each at least 1
};

io::Ray rayThrough(const View& view, glm::dvec2 pixel); // from the top left, centre of a pixel at .5
std::optional<glm::dvec2> project(const View& view, const glm::dvec3& world);

} // namespace editor
