// Cameras: the eyes through which the views look, by unique name: one is made when it is first asked for, and it is the same one
// from then on.
#pragma once

#include "io/scene/camera.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace editor {

inline constexpr std::string_view kEditCamera = "edit", kPlayCamera = "play";

class Cameras {
public:
    io::Camera& named(std::string_view name); // stays where it is until it is forgotten
    const io::Camera& look(std::string_view name, io::Camera from); // that one looks from there now
    const io::Camera* find(std::string_view name) const; // null: nobody has asked for it
    void forget(std::string_view name);
    std::vector<std::string> names() const; // in the alphabet's order

private:
    std::map<std::string, io::Camera, std::less<>> m_cameras;
};

} // namespace editor
