#include "editor/panels/environment_panel.h"

#include "editor/editor.h"
#include "editor/field_ui.h"
#include "editor/panels/sun_dial.h"
#include "editor/search_text.h"
#include "editor/text.h"
#include "editor/widgets.h"

namespace editor {

void EnvironmentPanel::draw(Editor& editor)
{
    if (!editor.document()) return;
    Document& document = *editor.document();
    io::Environment shown = document.scene().environment();
    const bool byHand = shown.sun.mode == io::SunMode::Manual;
    bool sunDragged = false;

    ImGui::SetNextItemWidth(-1);
    ui::searchField("##search", tr("environment.search"), m_search);
    ImGui::Dummy({0, 2});
    FieldUiOptions options{.defaults = scalarsOf(io::Environment{}), .filter = lowerCase(m_search)};
    options.enabled = [byHand](std::string_view key) {
        return byHand || (key != "sun.azimuth" && key != "sun.elevation");
    };
    options.before = [&](std::string_view section) {
        if (section == "sun." && m_search.empty()) sunDragged = sunDial(shown);
    };
    FieldUi ui{std::move(options)};
    fields(ui, shown);

    if (sunDragged) {
        editor.beginEdit("environment.sun", tr("undo.sun"));
        setEnvironment(document, tr("undo.sun"), std::move(shown));
    } else if (!ui.changes().empty()) {
        editor.beginEdit("environment." + ui.changedKey(), trf("undo.edit", ui.changedLabel()));
        setEnvironment(document, ui.changedLabel(), std::move(shown));
    }
}

} // namespace editor
