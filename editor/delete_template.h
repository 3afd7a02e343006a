// Deleting a template: with the objects that are copies of it, as one undo step. Save then removes its file.
#pragma once

#include "editor/document.h"

#include <string>
#include <vector>

namespace editor {

struct TemplateUse {
    std::vector<io::ObjectId> objects; // of this scene
    std::vector<std::string> scenes;   // others of the project that use it, which are not open
};
TemplateUse useOf(const Document& document, io::TemplateId id);

// An error changes nothing: another scene uses it, or this one does and `withObjects` is not set. Answers how many
// objects went with it.
io::Result<std::size_t> deleteTemplate(Document& document, io::TemplateId id, bool withObjects);

} // namespace editor
