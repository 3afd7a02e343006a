#include "editor/pointer_way.h"

#include <utility>

namespace editor {
namespace {

std::vector<glm::dvec2> g_way; // of the one pointer that there is

} // namespace

void setPointerWay(std::vector<glm::dvec2> points)
{
    g_way = std::move(points);
}

std::span<const glm::dvec2> pointerWay()
{
    return g_way;
}

} // namespace editor
