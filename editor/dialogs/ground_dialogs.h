// The dialogs of the ground as a whole: a new landscape of a recipe, with a picture of what it will be, and the ground that is
// there in other texels.
#pragma once

#include "editor/ground_edits.h"
#include "editor/ground_work.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace editor {

class Editor;

class GroundDialogs {
public:
    void showGenerate(Editor& editor); // over what there is, where there is ground
    void showReshape(Editor& editor);
    void draw(Editor& editor);
    bool any() const { return m_which != Which::None; }
    bool working() const { return m_work.busy() || m_preview.busy(); }

private:
    enum class Which { None, Generate, Reshape };
    void drawGenerate(Editor& editor);
    void recipe();
    void picture(float side);
    void drawReshape(Editor& editor);
    void reshapeFields();
    void beginPreview(Editor& editor);
    void takePreview();
    void takeGround(Editor& editor);
    bool buttons(const char* accept, bool enabled); // and Cancel, which closes
    void close();

    Which m_which = Which::None;
    std::string m_fault; // shown in the dialog
    GroundRecipe m_recipe;
    GroundWork m_work, m_preview;
    bool m_making = false;
    std::optional<GroundRecipe> m_shown; // that the preview is of, or will be
    std::vector<std::uint32_t> m_colours; // of the preview
    glm::ivec2 m_size{0};
    Reshaping m_reshaping;
    glm::ivec2 m_oldSize{2};
    double m_oldMetres = 1;
    glm::dvec2 m_origin{0};
    bool m_byWidth = true; // what was changed last
};

} // namespace editor
