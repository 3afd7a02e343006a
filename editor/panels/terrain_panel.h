// Terrain panel: the height map of the ground, its measures, and the layers that cover it.
#pragma once

#include "editor/panel.h"
#include "io/scene/terrain.h"

#include <string>
#include <vector>

namespace editor {

class TerrainPanel final : public Panel {
public:
    TerrainPanel() : Panel{"terrain", Icon::Terrain} {}
    void draw(Editor& editor) override;

private:
    void refreshFiles(Editor& editor);
    void wholeGround(Editor& editor);
    void sculpting(Editor& editor);
    void measures(Editor& editor);
    void layers(Editor& editor);
    bool layerButtons(Editor& editor, std::size_t index); // false: the list of layers is another now
    void layerFields(Editor& editor, std::size_t index);
    const std::vector<std::string>& filesFor(std::string_view key) const;

    std::vector<std::string> m_heightMaps, m_textures; // of the project, relative to it
    double m_nextLook = 0;                             // s; when the folders are read again
};

} // namespace editor
