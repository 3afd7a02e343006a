#include "editor/panels/sound_panel.h"

#include "editor/editor.h"
#include "editor/text.h"
#include "editor/widgets.h"
#include "io/scene/fields.h"

#include <algorithm>

namespace editor {
namespace {

constexpr float kWidest = 460;    // pixels: a volume as wide as the window would be hard to set
constexpr float kNarrowest = 120; // pixels that a note needs beside them

void volume(const char* id, const std::string& label, float& factor)
{
    ui::propertyLabel(label);
    double percent = double(factor) * 100;
    if (ui::number({.id = id, .label = label, .min = 0, .max = 100.0 * double(kLoudest), .speed = 0.5, .decimals = 0, .unit = "%"}, percent))
        factor = float(percent / 100);
}

} // namespace

void SoundPanel::draw(Editor& editor)
{
    SoundSettings& sound = editor.sound;
    ImGui::BeginChild("##volumes", {std::min(kWidest, ImGui::GetContentRegionAvail().x), 0});
    ui::checkbox("hear", tr("hearing.hear"), sound.hear);
    if (ImGui::IsItemHovered()) ui::tooltip(tr("hearing.hear_tip"));
    ImGui::SameLine(0, 24);
    ui::checkbox("muted", tr("hearing.muted"), sound.muted);
    ImGui::Dummy({0, 2});
    if (sound.muted) ImGui::BeginDisabled();
    volume("##master", tr("hearing.master"), sound.master);
    for (std::size_t i = 0; i < sound.groups.size(); ++i) {
        const std::string name{enumNames(io::SoundGroup{})[i]};
        volume(("##" + name).c_str(), tr("value." + name), sound.groups[i]);
    }
    if (sound.muted) ImGui::EndDisabled();
    ImGui::EndChild();
    ImGui::SameLine(0, 24);
    if (ImGui::GetContentRegionAvail().x < kNarrowest) return ImGui::NewLine();
    ImGui::BeginChild("##note");
    ui::softText(tr("hearing.note"));
    ImGui::EndChild();
}

} // namespace editor
