// What playing left other than it was. It is gone with the play, but for what a person chooses to keep of it, property by property.
#pragma once

#include "editor/document.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace editor {

// One object, as it was when the play began and as it was when it ended; nothing: it was hidden.
struct PlayChange {
    io::Object before;
    std::optional<io::Object> after;
};

enum class PlayProperty { Position, Rotation, Shown };

struct PlayRow {
    io::ObjectId id = io::ObjectId::None;
    PlayProperty property = PlayProperty::Position;
    bool keep = false;
};

// What of it can be kept: of objects that are still there, and further from what they are now than a trembling (1 cm, 1 degree).
std::vector<PlayRow> playRows(const Document& document, std::span<const PlayChange> changes);

// Those rows that are marked, as one undo step. What was hidden leaves the world.
void keepPlayChanges(Document& document, std::string name, std::span<const PlayChange> changes, std::span<const PlayRow> rows);

} // namespace editor
