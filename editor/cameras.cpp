#include "editor/cameras.h"

#include <utility>

namespace editor {

io::Camera& Cameras::named(std::string_view name)
{
    const auto found = m_cameras.find(name);
    if (found != m_cameras.end()) return found->second;
    io::Camera& made = m_cameras[std::string{name}];
    made.name = name;
    return made;
}

const io::Camera& Cameras::look(std::string_view name, io::Camera from)
{
    io::Camera& camera = named(name);
    camera = std::move(from);
    camera.name = name;
    return camera;
}

const io::Camera* Cameras::find(std::string_view name) const
{
    const auto found = m_cameras.find(name);
    return found == m_cameras.end() ? nullptr : &found->second;
}

void Cameras::forget(std::string_view name)
{
    if (const auto found = m_cameras.find(name); found != m_cameras.end()) m_cameras.erase(found);
}

std::vector<std::string> Cameras::names() const
{
    std::vector<std::string> names;
    for (const auto& [name, camera] : m_cameras)
        names.push_back(name);
    return names;
}

} // namespace editor
