#include "editor/panels/rendering_panel.h"

#include "editor/editor.h"
#include "editor/field_ui.h"
#include "editor/text.h"
#include "editor/widgets.h"


namespace editor {

void RenderingPanel::draw(Editor& editor)
{
    if (ui::section("passes", tr("section.rendering"))) {
        FieldUi ui{{.prefix = "render.", .defaults = scalarsOf(renderer::Settings{})}};
        fields(ui, editor.renderSettings);
    }
    if (ui::section("show", tr("section.show"))) {
        const auto names = enumNames(editor.show);
        for (std::size_t i = 0; i < names.size(); ++i) {
            bool on = editor.show == renderer::Show(i);
            ImGui::PushID(int(i));
            if (ui::checkbox("show", tr("show." + std::string{names[i]}), on))
                editor.show = on ? renderer::Show(i) : renderer::Show::Final;
            ImGui::PopID();
        }
    }
    if (ui::section("device", tr("section.device")))
        ui::softText(editor.renderer() ? editor.renderer()->deviceName() : "");
}

} // namespace editor
