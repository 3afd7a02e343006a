#include "editor/panels/environment_panel.h"

#include "editor/editor.h"
#include "editor/field_ui.h"
#include "editor/panels/sun_dial.h"
#include "editor/search_text.h"
#include "editor/text.h"
#include "editor/widgets.h"
#include "io/scene/field_order.h"
#include "io/scene/shadow_ends.h"

#include <algorithm>
#include <initializer_list>

namespace editor {
namespace {

// Whether a field of the shadows has anything to say beside the others.
bool counts(const io::Shadows& shadows, std::string_view key)
{
    constexpr std::string_view kEnd = "end_";
    if (!shadows.on) return key == "on";
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
    if (key.starts_with("clouds.")) return e.clouds.on || key == "clouds.on";
    if (key.starts_with("fog.")) return e.fog.on || key == "fog.on";
    if (key.starts_with("occlusion.")) return e.occlusion.on || key == "occlusion.on";
    return true;
}

// An end that is dragged takes its neighbours along; those that begin to count find a place between the others.
void keepInOrder(io::Environment& environment, std::string_view changedKey)
{
    constexpr std::string_view kShadows = "shadows.";
    io::keepOrder(environment, changedKey);
    if (!changedKey.starts_with(kShadows)) return;
    io::Shadows& shadows = environment.shadows;
    const std::string_view key = changedKey.substr(kShadows.size());
    if (key == "distance" || key.starts_with("end_")) io::pushEnds(shadows, key);
    else io::spreadEnds(shadows);
}

bool isClock(std::string_view key)
{
    return isOneOf(key, {"time", "day_of_year", "year"});
}

// What was changed of what is shown. The hours that a running day has gone on are no part of it, unless it is the clock that was set.
void take(const FieldUi& ui, const io::Environment& shown, io::Environment& changed)
{
    std::vector<ScalarChange> changes = ui.changes();
    for (ScalarChange& change : changes)
        change.relative = false;
    applyChanges(changed, changes);
    if (isClock(ui.changedKey())) {
        changed.time = shown.time;
        changed.dayOfYear = shown.dayOfYear;
        changed.year = shown.year;
    }
    keepInOrder(changed, ui.changedKey());
}

void nothingFound()
{
    ui::softText(tr("common.nothing_found"));
    mapItem("label", tr("common.nothing_found"));
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

    if (!ui.found()) nothingFound();
    if (!sunDragged && ui.changes().empty()) return;
    editor.live().settle(document); // a step of its own, so that undo takes back this edit alone
    io::Environment changed = document.scene().environment();
    if (sunDragged) {
        changed.sun = shown.sun;
        editor.beginEdit("environment.sun", tr("undo.sun"));
        setEnvironment(document, tr("undo.sun"), std::move(changed));
    } else {
        take(ui, shown, changed);
        if (isClock(ui.changedKey())) editor.live().goOnFrom(changed);
        editor.beginEdit("environment." + ui.changedKey(), trf("undo.edit", ui.changedLabel()));
        setEnvironment(document, ui.changedLabel(), std::move(changed));
    }
}

} // namespace editor
