// Scatter panel: the layers of plants of a world, what grows in them and by which rules, and the brush that plants.
#pragma once

#include "editor/panel.h"
#include "io/scene/scatter.h"

#include <string>
#include <vector>

namespace editor {

class ScatterPanel final : public Panel {
public:
    ScatterPanel() : Panel{"scatter", Icon::Tree} {}
    void draw(Editor& editor) override;

private:
    void layers(Editor& editor);
    void grow(Editor& editor, const io::ScatterLayer& layer);
    void brush(Editor& editor, const io::ScatterLayer& layer);
    void species(Editor& editor, const io::ScatterLayer& layer);
    void settings(Editor& editor, const io::ScatterLayer& layer);
    void conversion(Editor& editor, const io::ScatterLayer& layer);
    void work(Editor& editor);
};

} // namespace editor
