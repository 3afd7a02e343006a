#include "editor/view.h"

#include "renderer/renderer.h"

namespace editor {

io::Ray rayThrough(const View& view, glm::dvec2 pixel)
{
    return renderer::rayThrough(view.camera, view.size, pixel);
}

std::optional<glm::dvec2> project(const View& view, const glm::dvec3& world)
{
    return renderer::project(view.camera, view.size, world);
}

} // namespace editor
