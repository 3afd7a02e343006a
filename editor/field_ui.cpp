#include "editor/field_ui.h"

#include "editor/numbers_text.h"
#include "editor/search_text.h"
#include "editor/text.h"
#include "editor/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <limits>
#include <utility>

namespace editor {
namespace {

constexpr float kResetWidth = 24; // pixels kept free at the end of a row

std::string shownUnit(std::string_view unit)
{
    if (unit == "deg") return "°";
    if (unit == "1e-6/m") return "10⁻⁶/m";
    if (unit == "x") return "×";
    if (unit == "texels") return tr("unit.texels");
    return std::string{unit};
}

int decimalsFor(const io::Hint& hint, bool whole)
{
    const double range = hint.max - hint.min;
    if (whole) return 0;
    return range <= 2 ? 3 : range <= 50 || range > ui::kOpenRange ? 2 : 1;
}

constexpr double kShare = 0.01;     // of the value, or of a usual one, that a pixel of dragging changes
constexpr double kFieldWidth = 200; // pixels in which a drag crosses the whole range at most

// Of what is never far from anything in its range: shares, angles, hours.
bool isEven(const io::Hint& hint)
{
    const bool small = hint.max - hint.min <= 2 && hint.style != io::Style::Logarithmic;
    return small || std::string_view{hint.unit} == "h";
}

double speedFor(const io::Hint& hint, bool whole, double value, double usual)
{
    const double range = hint.max - hint.min;
    const bool open = range > ui::kOpenRange;
    if (whole && !open) return range < 100 ? 0.04 : 0;
    if (whole) return std::max(1.0, std::abs(value) * 0.005); // what is less than one would be rounded away
    const double most = open ? std::numeric_limits<double>::max() : range / kFieldWidth;
    if (std::string_view{hint.unit} == "deg") return std::min(0.5, most);
    if (open && std::string_view{hint.unit} == "m") return 0.05;
    if (isEven(hint)) return 0;
    double size = std::max(std::abs(value), std::abs(usual));
    if (size == 0) size = open ? 0.5 : std::min(range / 10, 10.0);
    return std::min(size * kShare, most);
}

} // namespace

struct FieldUi::Row {
    std::string key, label; // dotted, with the prefix; translated
    std::size_t place = 0;
    int count = 1;
    bool differs = false; // from the default
    bool enabled = true;
};

bool FieldUi::beginSection(const char* key)
{
    const std::string id = m_options.prefix + m_path + key;
    if (m_options.filter.empty()) {
        ImGui::Dummy({0, 2});
        if (!ui::section(id.c_str(), tr("section." + id))) return false;
    } else {
        m_section = tr("section." + id);
        m_headed = false;
    }
    m_path += std::string{key} + ".";
    return true;
}

void FieldUi::endSection()
{
    m_section.clear();
    m_path.pop_back();
    const std::size_t dot = m_path.rfind('.');
    m_path.erase(dot == std::string::npos ? 0 : dot + 1);
}

// Each word of the filter somewhere in what a person may know the row by. The first of a section brings its name.
bool FieldUi::matches(const Row& row, std::string_view unit)
{
    if (m_options.filter.empty()) return true;
    const std::string hint = "hint." + row.key;
    const std::string text = fmt::format("{} {} {} {} {}", m_section, row.label, row.key, unit, hasText(hint) ? tr(hint) : "");
    if (!holdsWords(text, m_options.filter)) return false;
    if (!m_section.empty() && !std::exchange(m_headed, true)) {
        ImGui::Dummy({0, 2});
        ui::heading(m_section.c_str());
        mapItem("section", m_section, true);
    }
    return m_found = true;
}

bool FieldUi::beginRow(Row& row, const char* key, int count, std::string_view unit, std::string_view unitAtLabel)
{
    row.key = m_options.prefix + m_path + key;
    row.label = tr("field." + row.key);
    row.place = m_place;
    row.count = count;
    m_place += std::size_t(count);
    if (!matches(row, unit)) return false;
    row.enabled = !m_options.enabled || m_options.enabled(row.key);
    if (!row.enabled) ImGui::BeginDisabled();
    ImGui::PushID(row.key.c_str());
    ui::propertyLabel(row.label, unitAtLabel);
    const std::string hint = "hint." + row.key;
    if (ImGui::IsItemHovered() && hasText(hint)) ui::tooltip(tr(hint));
    return true;
}

void FieldUi::endRow(const Row& row)
{
    ImGui::PopID();
    if (!row.enabled) ImGui::EndDisabled();
}

// The arrow at the end of a row whose value is not the default.
bool FieldUi::resetButton(const Row& row)
{
    if (m_options.defaults.empty() || !row.differs || !row.enabled) return false;
    ImGui::SameLine(0, 1);
    return ui::iconButton({.id = "reset",
                           .icon = Icon::Reset,
                           .label = trf("common.reset_field", row.label),
                           .size = ImGui::GetFrameHeight(),
                           .colour = palette::kSoftText});
}

void FieldUi::note(const Row& row, ScalarChange change)
{
    m_changes.push_back(std::move(change));
    m_changedKey = row.key;
    m_changedLabel = row.label;
}

bool FieldUi::choice(const char* key, const std::vector<std::string_view>& names, int& chosen)
{
    Row row;
    if (!beginRow(row, key, 1)) return false;
    row.differs = !m_options.defaults.empty() && m_options.defaults[row.place] != Scalar{double(chosen)};
    std::vector<std::string> items;
    for (const std::string_view name : names)
        items.emplace_back(tr("value." + std::string{name}));
    if (!m_options.defaults.empty()) ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - kResetWidth);
    bool changed = ui::combo("##value", row.label, items, chosen, isMixed(row.place));
    if (resetButton(row)) chosen = int(std::get<double>(m_options.defaults[row.place])), changed = true;
    if (changed) note(row, {row.place, double(chosen)});
    endRow(row);
    return changed;
}

bool FieldUi::toggle(const char* key, bool& value)
{
    Row row;
    if (!beginRow(row, key, 1)) return false;
    row.differs = !m_options.defaults.empty() && m_options.defaults[row.place] != Scalar{value};
    bool changed = ui::checkbox("##value", isMixed(row.place) ? tr("common.mixed") : "", value, row.label);
    if (row.differs) {
        ImGui::SameLine(0, 0);
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - kResetWidth);
    }
    if (resetButton(row)) value = std::get<bool>(m_options.defaults[row.place]), changed = true;
    if (changed) note(row, {row.place, value});
    endRow(row);
    return changed;
}

// The files, what is named now though it is none of them, and nothing at all.
bool FieldUi::fileChoice(const Row& row, std::vector<std::string> files, std::string& value)
{
    if (!value.empty() && std::ranges::find(files, value) == files.end()) files.push_back(value);
    files.insert(files.begin(), "");
    int chosen = int(std::ranges::find(files, value) - files.begin());
    std::vector<std::string> shown = files;
    shown.front() = tr("common.no_file");
    if (!ui::combo("##value", row.label, shown, chosen)) return false;
    value = files[std::size_t(chosen)];
    return true;
}

bool FieldUi::text(const char* key, std::string& value)
{
    Row row;
    if (!beginRow(row, key, 1)) return false;
    ImGui::SetNextItemWidth(-1);
    std::vector<std::string> files = m_options.files ? m_options.files(row.key) : std::vector<std::string>{};
    const bool changed = files.empty()
                             ? ui::textField("##value", isMixed(row.place) ? tr("common.mixed") : "", value)
                             : fileChoice(row, std::move(files), value);
    if (changed) note(row, {row.place, value});
    endRow(row);
    return changed;
}

bool FieldUi::numbers(const char* key, double* values, int count, const io::Hint& hint, bool whole)
{
    Row row;
    const std::string unit = shownUnit(hint.unit);
    if (!beginRow(row, key, count, unit, count > 1 ? unit : "")) return false;
    const bool resets = !m_options.defaults.empty();
    for (int i = 0; i < count && resets; ++i)
        row.differs |= m_options.defaults[row.place + std::size_t(i)] != Scalar{values[i]};
    const auto usual = [&](std::size_t place) { return resets ? std::get<double>(m_options.defaults[place]) : 0.0; };
    const float room = ImGui::GetContentRegionAvail().x - (resets ? kResetWidth : 0);
    bool changed = false;

    if (hint.style == io::Style::Colour && count == 3) {
        float rgb[3] = {float(values[0]), float(values[1]), float(values[2])};
        ImGui::PushItemWidth(room);
        changed = ui::colourField("value", row.label, rgb, float(hint.max), isMixed(row.place), room);
        ImGui::PopItemWidth();
        for (int i = 0; i < 3 && changed; ++i)
            note(row, {row.place + std::size_t(i), double(values[i] = rgb[i])});
    } else {
        constexpr float kBetween = 4;
        const float width = std::floor((room - kBetween * float(count - 1)) / float(count));
        for (int i = 0; i < count; ++i) {
            if (i > 0) ImGui::SameLine(0, kBetween);
            ImGui::PushID(i);
            const std::size_t place = row.place + std::size_t(i);
            const double old = values[i];
            const std::string label = count == 1 ? row.label : row.label + " " + std::string(1, "XYZW"[i]);
            TypedNumber typed;
            if (ui::number({.id = "##value",
                            .label = label,
                            .min = hint.min,
                            .max = hint.max,
                            .speed = speedFor(hint, whole, old, usual(place)),
                            .decimals = decimalsFor(hint, whole),
                            .unit = count == 1 ? unit : "",
                            .logarithmic = hint.style == io::Style::Logarithmic,
                            .mixed = isMixed(place),
                            .axis = count == 3 ? i : -1,
                            .width = width,
                            .shown = std::string_view{hint.unit} == "h" ? clockShown(old) : ""},
                           values[i], &typed)) {
                if (whole) values[i] = std::round(values[i]);
                const bool dragged = ImGui::IsMouseDown(ImGuiMouseButton_Left);
                note(row, {.place = place,
                           .value = values[i],
                           .relative = typed.relative || dragged,
                           .delta = typed.relative ? typed.delta : values[i] - old,
                           .factor = typed.factor});
                changed = true;
            }
            ImGui::PopID();
        }
    }
    if (resetButton(row)) {
        for (int i = 0; i < count; ++i) {
            values[i] = std::get<double>(m_options.defaults[row.place + std::size_t(i)]);
            note(row, {row.place + std::size_t(i), values[i]});
        }
        changed = true;
    }
    endRow(row);
    return changed;
}

} // namespace editor
