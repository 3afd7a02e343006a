// Arranging many: duplicate, copy and paste as text, group and ungroup. Each is one undo step.
#pragma once

#include "editor/document.h"
#include "editor/picker.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace editor {

// The new ids of the outermost copies, in the order of `ids`.
std::vector<io::ObjectId> duplicate(Document& document, std::span<const io::ObjectId> ids, const glm::dvec3& offset);

// JSON lines: a first line that says what it is, then one object a line, groups with their members.
std::string copyAsText(const Document& document, std::span<const io::ObjectId> ids);
bool holdsObjects(std::string_view clipboard); // whether paste() would take it

// The copied objects keep their places to each other; the middle of their bottom comes to `at`. An error changes
// nothing: text that is no copy of objects, or a template that this project lacks.
io::Result<std::vector<io::ObjectId>> paste(Document& document, std::string_view text, const glm::dvec3& at);

// A new group that holds them, inside the group that all are in, if there is one. None for no ids.
io::ObjectId group(Document& document, std::span<const io::ObjectId> ids, std::string name = {});
// Dissolves those of the ids that are groups; answers their members.
std::vector<io::ObjectId> ungroup(Document& document, std::span<const io::ObjectId> ids);
// Moves them into a group, or out of all with None. A group never goes into itself: false, and nothing changes.
bool reparent(Document& document, std::span<const io::ObjectId> ids, io::ObjectId group);

// Applies `delta` to objects and, where they are groups, to their members.
void moveBy(Document& document, std::string name, std::span<const io::ObjectId> ids, const glm::dvec3& delta);

} // namespace editor
