#include "editor/panels/environment_panel.h"

#include "editor/editor.h"
#include "editor/field_ui.h"
#include "editor/panels/sun_dial.h"
#include "editor/search_text.h"
#include "editor/text.h"
#include "editor/widgets.h"
#include "io/scene/shadow_ends.h"

#include <algorithm>
#include <initializer_list>

namespace editor {
namespace {

// Whether a field of the shadows has anything to say beside the others.
bool counts(const io::Shadows& shadows, std::string_view key)
{
    constexpr std::string_view kEnd = "end_";
    const bool byHand = shadows.splits == io::Splits::Manual;
    if (key == "lambda") return !byHand && shadows.cascades > 1;
    if (key == "splits" || key == "blend") return shadows.cascades > 1;
    if (key.starts_with(kEnd)) return byHand && key[kEnd.size()] - '0' < shadows.cascades;
    return true;
}

bool isOneOf(std::string_view key, std::initializer_list<std::string_view> keys)
{
    return std::ranges::find(keys, key) != keys.end();
}

// Whether a field has anything to say beside what the others are.
bool counts(const io::Environment& e, std::string_view key)
{
    if (key.starts_with("shadows.")) return counts(e.shadows, key.substr(std::string_view{"shadows."}.size()));
    if (isOneOf(key, {"sun.azimuth", "sun.elevation"})) return e.sun.mode == io::SunMode::Manual;
    if (isOneOf(key, {"moon.azimuth", "moon.elevation", "moon.phase"})) return e.moon.mode == io::SunMode::Manual;
    if (key == "time_zone") return e.clock == io::Clock::Zone;
    if (key.starts_with("auto_exposure.")) return e.autoExposure.on || key == "auto_exposure.on";
    if (key.starts_with("water.")) return e.water.on || key == "water.on";
    return true;
}

// An end that is dragged takes its neighbours along; those that begin to count find a place between the others.
void keepInOrder(io::Shadows& shadows, std::string_view changedKey)
{
    constexpr std::string_view kShadows = "shadows.";
    if (!changedKey.starts_with(kShadows)) return;
    const std::string_view key = changedKey.substr(kShadows.size());
    if (key == "distance" || key.starts_with("end_")) io::pushEnds(shadows, key);
    else io::spreadEnds(shadows);
}

} // namespace

void EnvironmentPanel::draw(Editor& editor)
{
    if (!editor.document()) return;
    Document& document = *editor.document();
    const io::Environment& own = document.scene().environment();
    io::Environment shown = editor.live().shown(own).value_or(own); // what is edited is what is seen
    bool sunDragged = false;

    m_looks.draw(editor);
    ImGui::SetNextItemWidth(-1);
    ui::searchField("##search", tr("environment.search"), m_search);
    ImGui::Dummy({0, 2});
    if (m_search.empty()) sunDragged = sunDial(shown);
    FieldUiOptions options{.defaults = scalarsOf(io::Environment{}), .filter = lowerCase(m_search)};
    options.enabled = [now = shown](std::string_view key) { return counts(now, key); };
    FieldUi ui{std::move(options)};
    fields(ui, shown);

    if (sunDragged || !ui.changes().empty()) editor.live().goOnFrom(shown);
    if (sunDragged) {
        editor.beginEdit("environment.sun", tr("undo.sun"));
        setEnvironment(document, tr("undo.sun"), std::move(shown));
    } else if (!ui.changes().empty()) {
        keepInOrder(shown.shadows, ui.changedKey());
        editor.beginEdit("environment." + ui.changedKey(), trf("undo.edit", ui.changedLabel()));
        setEnvironment(document, ui.changedLabel(), std::move(shown));
    }
}

} // namespace editor
