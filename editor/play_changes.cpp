#include "editor/play_changes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace editor {
namespace {

constexpr double kMoved = 0.01; // m
constexpr double kTurned = 1;   // degrees

double degreesBetween(const glm::vec3& a, const glm::vec3& b)
{
    const double share = std::min(1.0, std::abs(glm::dot(io::orientation(a), io::orientation(b))));
    return glm::degrees(2 * std::acos(share));
}

} // namespace

std::vector<PlayRow> playRows(const Document& document, std::span<const PlayChange> changes)
{
    std::vector<PlayRow> rows;
    for (const PlayChange& change : changes) {
        const io::Object* now = document.scene().find(change.before.id);
        if (!now) continue;
        if (!change.after) {
            rows.push_back({now->id, PlayProperty::Shown});
            continue;
        }
        const io::Transform& after = change.after->transform;
        if (glm::length(after.position - now->transform.position) > kMoved) rows.push_back({now->id, PlayProperty::Position});
        if (degreesBetween(after.rotation, now->transform.rotation) > kTurned) rows.push_back({now->id, PlayProperty::Rotation});
    }
    return rows;
}

void keepPlayChanges(Document& document, std::string name, std::span<const PlayChange> changes, std::span<const PlayRow> rows)
{
    std::map<io::ObjectId, std::optional<io::Object>> kept;
    for (const PlayRow& row : rows) {
        const io::Object* now = document.scene().find(row.id);
        const auto change = std::ranges::find(changes, row.id, [](const PlayChange& one) { return one.before.id; });
        if (!row.keep || !now || change == changes.end()) continue;
        std::optional<io::Object>& object = kept.try_emplace(row.id, *now).first->second;
        if (row.property == PlayProperty::Shown) object.reset();
        else if (!object || !change->after) continue;
        else if (row.property == PlayProperty::Position) object->transform.position = change->after->transform.position;
        else object->transform.rotation = change->after->transform.rotation;
    }
    if (kept.empty()) return;
    document.run(std::make_unique<SwapObjects>(std::move(name), std::vector<SwapObjects::Slot>{kept.begin(), kept.end()}));
}

} // namespace editor
