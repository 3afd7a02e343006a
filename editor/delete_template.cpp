#include "editor/delete_template.h"

#include "io/base/contract.h"

#include <algorithm>

namespace editor {

TemplateUse useOf(const Document& document, io::TemplateId id)
{
    TemplateUse use;
    for (const io::Object& object : document.scene().objects())
        if (object.templateId == id) use.objects.push_back(object.id);
    std::ranges::sort(use.objects);
    use.scenes = io::otherScenesWith(document.world(), document.scene().templateName(id));
    return use;
}

io::Result<std::size_t> deleteTemplate(Document& document, io::TemplateId id, bool withObjects)
{
    EXPECTS(document.scene().find(id));
    const std::string name{document.scene().templateName(id)};
    const TemplateUse use = useOf(document, id);
    if (!use.scenes.empty())
        return io::Error{name, "is used in the scene " + use.scenes.front() + "; delete its objects there first"};
    if (!use.objects.empty() && !withObjects)
        return io::Error{name, "is used by " + std::to_string(use.objects.size()) +
                                   " objects; delete them too, or give them another template first"};
    const Gesture gesture{document, "Delete template"};
    removeObjects(document, "Delete", use.objects);
    setTemplate(document, "Delete template", id, std::nullopt);
    return use.objects.size();
}

} // namespace editor
