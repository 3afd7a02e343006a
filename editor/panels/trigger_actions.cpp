#include "editor/panels/trigger_actions.h"

#include "editor/document.h"
#include "editor/project_files.h"
#include "editor/text.h"
#include "editor/widgets.h"
#include "io/files/kept_looks.h"
#include "io/scene/environment_presets.h"
#include "io/scene/fields.h"

#include <algorithm>
#include <set>

namespace editor {
namespace {

constexpr float kButton = 26; // pixels

// What an action may name, as files have it and as a person reads it.
struct Choices {
    std::vector<std::string> names, shown;

    void add(std::string name, std::string text)
    {
        names.push_back(std::move(name));
        shown.push_back(std::move(text));
    }
};

std::set<std::string> objectNames(const io::Scene& scene)
{
    std::set<std::string> names; // several may bear one: all of them come and go
    for (const io::Object& object : scene.objects())
        if (!object.name.empty()) names.insert(object.name);
    return names;
}

Choices choicesFor(const Document& document, io::TriggerDo action)
{
    Choices choices;
    switch (action) {
    case io::TriggerDo::PlaySound:
        for (const std::string& file : filesIn(document.project().folder, "sounds"))
            choices.add(file, file.substr(file.find('/') + 1));
        break;
    case io::TriggerDo::ComeToLook:
        for (const std::string_view name : enumNames(io::Preset{}))
            choices.add(std::string{name}, tr("look." + std::string{name}));
        for (const std::string& name : io::KeptLooks{io::looksFolder()}.names())
            choices.add(name, name);
        break;
    case io::TriggerDo::Show:
    case io::TriggerDo::Hide:
        for (const std::string& name : objectNames(document.scene()))
            choices.add(name, name);
        break;
    case io::TriggerDo::Teleport:
        for (const io::Camera& camera : document.scene().cameras())
            choices.add(camera.name, camera.name);
        break;
    case io::TriggerDo::Message: break;
    }
    return choices;
}

const char* nothingToChoose(io::TriggerDo action)
{
    switch (action) {
    case io::TriggerDo::PlaySound: return "triggers.no_sounds";
    case io::TriggerDo::Teleport: return "triggers.no_cameras";
    default: return "triggers.no_objects";
    }
}

bool chooseWhat(const Document& document, io::TriggerAction& action)
{
    Choices choices = choicesFor(document, action.action);
    if (choices.names.empty() && action.what.empty()) {
        ui::softText(tr(nothingToChoose(action.action)));
        return false;
    }
    auto found = std::ranges::find(choices.names, action.what);
    if (found == choices.names.end()) { // nothing yet, or what is there no longer
        choices.names.insert(choices.names.begin(), action.what);
        choices.shown.insert(choices.shown.begin(), action.what.empty() ? tr("triggers.choose") : trf("triggers.gone", action.what));
        found = choices.names.begin();
    }
    int chosen = int(found - choices.names.begin());
    if (!ui::combo("##what", tr("triggers.what"), choices.shown, chosen)) return false;
    action.what = choices.names[std::size_t(chosen)];
    return true;
}

bool kindOf(io::TriggerAction& action)
{
    std::vector<std::string> kinds;
    for (const std::string_view name : enumNames(io::TriggerDo{}))
        kinds.emplace_back(tr("trigger_do." + std::string{name}));
    int kind = int(action.action);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 3 * kButton - 10);
    if (!ui::combo("##action", tr("triggers.action"), kinds, kind) || kind == int(action.action)) return false;
    action.action = io::TriggerDo(kind);
    action.what.clear(); // a sound is no camera
    return true;
}

bool details(const Document& document, io::TriggerAction& action)
{
    bool changed = false;
    ui::propertyLabel(tr("triggers.what"));
    if (action.action == io::TriggerDo::Message) changed = ui::textField("##what", tr("triggers.message"), action.what);
    else changed = chooseWhat(document, action);
    if (action.action != io::TriggerDo::Message && action.action != io::TriggerDo::ComeToLook) return changed;
    double seconds = action.seconds;
    ui::propertyLabel(tr("triggers.seconds"));
    if (ui::number({.id = "##seconds", .label = tr("triggers.seconds"), .min = 0, .max = 3600, .speed = 0.1, .decimals = 1, .unit = "s"}, seconds)) {
        action.seconds = float(seconds);
        changed = true;
    }
    return changed;
}

enum class Move { None, Up, Down, Remove };

Move moves(std::size_t index, std::size_t count)
{
    Move move = Move::None;
    ImGui::SameLine(0, 4);
    if (ui::iconButton({.id = "up", .icon = Icon::Up, .label = tr("triggers.up"), .enabled = index > 0, .size = kButton})) move = Move::Up;
    ImGui::SameLine(0, 2);
    if (ui::iconButton({.id = "down", .icon = Icon::Down, .label = tr("triggers.down"), .enabled = index + 1 < count, .size = kButton})) move = Move::Down;
    ImGui::SameLine(0, 2);
    if (ui::iconButton({.id = "remove", .icon = Icon::Trash, .label = tr("triggers.remove"), .size = kButton})) move = Move::Remove;
    return move;
}

} // namespace

bool triggerActions(const Document& document, std::vector<io::TriggerAction>& actions, std::string& what)
{
    bool changed = false;
    const auto note = [&](std::string widget) {
        what = std::move(widget);
        changed = true;
    };
    ImGui::PushID("actions");
    ImGui::Dummy({0, 2});
    ui::heading(tr("triggers.actions"));
    if (actions.empty()) ui::softText(tr("triggers.none"));
    for (std::size_t i = 0; i < actions.size(); ++i) {
        ImGui::PushID(int(i));
        if (kindOf(actions[i])) note("kind" + std::to_string(i));
        const Move move = moves(i, actions.size());
        if (move == Move::None && details(document, actions[i])) note("what" + std::to_string(i));
        ImGui::Dummy({0, 4});
        ImGui::PopID();
        if (move == Move::None) continue;
        const auto place = actions.begin() + std::ptrdiff_t(i);
        if (move == Move::Remove) actions.erase(place);
        else std::iter_swap(place, move == Move::Up ? place - 1 : place + 1);
        note("order");
        break; // the rest is drawn in the next frame
    }
    if (ui::button("add", tr("triggers.add"))) {
        actions.emplace_back();
        note("add");
    }
    ImGui::PopID();
    return changed;
}

} // namespace editor
