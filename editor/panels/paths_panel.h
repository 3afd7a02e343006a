// Camera paths panel: flights through a world: their keys, how fast they go, where they look, and a look along them.
#pragma once

#include "editor/panel.h"
#include "io/scene/camera.h"

#include <string>

namespace editor {

class PathsPanel final : public Panel {
public:
    PathsPanel() : Panel{"paths", Icon::Camera} {}
    void draw(Editor& editor) override;

private:
    void list(Editor& editor);
    void rename(Editor& editor, const io::CameraPath& path);
    void keys(Editor& editor, const io::CameraPath& path);
    void pace(Editor& editor, const io::CameraPath& path);
    void aim(Editor& editor, const io::CameraPath& path);
    void preview(Editor& editor, const io::CameraPath& path);

    std::string m_name, m_named; // as it is typed; of the path of that name
};

} // namespace editor
