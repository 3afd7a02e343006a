// Copied objects as text, so that they can go through the system's clipboard and into another project.
#include "editor/arrange.h"

#include "editor/placement.h"
#include "io/files/json.h"
#include "io/scene/field_value.h"

#include <unordered_map>

namespace editor {
namespace {

constexpr std::string_view kMark = "wold_objects"; // the key of the first line; its value is the version
constexpr int kVersion = 1;

std::string lineOf(const Document& document, const io::Object& object)
{
    io::Value value = io::toValue(object);
    value["template"] = document.scene().templateName(object.templateId);
    value["id"] = io::number(object.id);
    if (!object.extra.keys().empty()) {
        io::Value::Object extra;
        for (const auto& [path, json] : object.extra.keys())
            extra.emplace_back(path, json);
        value["extra"] = std::move(extra);
    }
    return io::writeJson(value) + '\n';
}

io::Result<io::Object> objectOf(const Document& document, const io::Value& value, const std::string& where)
{
    io::Object object;
    for (const char* key : {"name", "position", "rotation", "scale"})
        if (const io::Value* field = value.find(key)) {
            const io::Status set = io::setField(object, key, *field);
            if (!set) return io::Error{where, set.error().text()};
        }
    const io::Value* kind = value.find("template");
    const std::string* name = kind ? kind->asString() : nullptr;
    if (!name) return io::Error{where, "has no template's name; copy the objects again"};
    object.templateId = document.scene().findTemplate(*name);
    if (!name->empty() && !document.scene().find(object.templateId))
        return io::Error{where, "this project has no template \"" + *name + "\"; import it first"};
    if (const io::Value* extra = value.find("extra"); extra && extra->asObject())
        for (const auto& [path, json] : *extra->asObject())
            if (json.asString()) object.extra.add(path, *json.asString());
    return object;
}

std::uint32_t numberAt(const io::Value& value, std::string_view key)
{
    const io::Value* found = value.find(key);
    const double* number = found ? found->asNumber() : nullptr;
    return number && *number >= 0 && *number <= 4294967295.0 ? std::uint32_t(*number) : 0;
}

std::string_view nextLine(std::string_view& text)
{
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return line;
}

glm::dvec3 anchorOf(const Document& document, std::span<const io::Object> objects)
{
    io::WorldBox all;
    for (const io::Object& object : objects) {
        const io::WorldBox own = io::worldBounds(document.assets(), object);
        if (!own.empty())
            all.add(own);
        else
            all.add(object.transform.position);
    }
    return {all.centre().x, all.min.y, all.centre().z};
}

} // namespace

std::string copyAsText(const Document& document, std::span<const io::ObjectId> ids)
{
    std::string text = "{\"" + std::string{kMark} + "\":" + std::to_string(kVersion) + "}\n";
    for (const io::ObjectId id : document.hierarchy().withMembers(ids))
        if (const io::Object* object = document.scene().find(id)) text += lineOf(document, *object);
    return text;
}

bool holdsObjects(std::string_view clipboard)
{
    return clipboard.starts_with("{\"" + std::string{kMark} + "\":") && clipboard.find('\n') + 1 < clipboard.size();
}

io::Result<std::vector<io::ObjectId>> paste(Document& document, std::string_view text, const glm::dvec3& at)
{
    if (!holdsObjects(text)) return io::Error{"clipboard", "holds no objects; copy some first"};
    const io::Result<io::Value> head = io::parseJson(nextLine(text), "clipboard");
    if (!head || numberAt(*head, kMark) != std::uint32_t(kVersion))
        return io::Error{"clipboard", "was copied by another version of Wold; copy the objects again"};

    std::vector<io::Object> objects;
    std::vector<std::uint32_t> parents;
    std::unordered_map<std::uint32_t, io::ObjectId> pasted; // id in the text -> new id
    for (int line = 2; !text.empty(); ++line) {
        const std::string where = "clipboard:" + std::to_string(line);
        const std::string_view words = nextLine(text);
        if (words.empty()) continue;
        const io::Result<io::Value> value = io::parseJson(words, where);
        if (!value) return value.error();
        io::Result<io::Object> object = objectOf(document, *value, where);
        if (!object) return object.error();
        object->id = document.freshId();
        pasted[numberAt(*value, "id")] = object->id;
        parents.push_back(numberAt(*value, "parent"));
        objects.push_back(std::move(*object));
    }
    if (objects.empty()) return io::Error{"clipboard", "holds no objects; copy some first"};
    const glm::dvec3 delta = at - anchorOf(document, objects);
    std::vector<io::ObjectId> outermost;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        objects[i].transform.position += delta;
        const auto group = pasted.find(parents[i]);
        if (group != pasted.end() && group->second != objects[i].id)
            objects[i].parent = group->second;
        else
            outermost.push_back(objects[i].id);
    }
    const std::size_t count = outermost.size();
    addObjects(document, "Paste " + std::to_string(count) + (count == 1 ? " object" : " objects"), std::move(objects));
    return outermost;
}

} // namespace editor
