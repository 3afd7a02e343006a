#include "editor/properties.h"

#include "io/files/json.h"
#include "io/scene/field_order.h"
#include "io/scene/field_value.h"
#include "io/scene/shadow_ends.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace editor {
namespace {

// "camera.Lookout.fov" cut into its kind, the thing's name and the path inside. Names may hold dots, so the names
// that exist decide where one ends.
struct Key {
    std::string_view kind, rest;
};

Key cut(std::string_view key)
{
    const std::size_t dot = key.find('.');
    return {key.substr(0, dot), dot == std::string_view::npos ? std::string_view{} : key.substr(dot + 1)};
}

template <class Thing> Thing* longestNamed(std::span<Thing> things, std::string_view rest, std::string_view& path)
{
    Thing* best = nullptr;
    for (Thing& thing : things) {
        const std::string& name = thing.name;
        const bool named = rest.starts_with(name) && (rest.size() == name.size() || rest[name.size()] == '.');
        if (!named || (best && best->name.size() >= name.size())) continue;
        best = &thing;
        path = rest.substr(std::min(name.size() + 1, rest.size()));
    }
    return best;
}

template <class T> io::Result<io::Value> valueAt(const T& thing, std::string_view path)
{
    if (path.empty()) return io::toValue(thing);
    return io::getField(thing, path);
}

io::Error unknown(std::string_view what, std::string_view rest)
{
    return io::Error{{}, "there is no " + std::string{what} + " \"" + std::string{rest} + "\""};
}

const io::Object* objectNamed(const Document& document, std::string_view rest, std::string_view& path)
{
    const Key parts = cut(rest);
    std::uint32_t id = 0;
    const auto [end, fault] = std::from_chars(parts.kind.data(), parts.kind.data() + parts.kind.size(), id);
    if (fault != std::errc{} || end != parts.kind.data() + parts.kind.size()) return nullptr;
    path = parts.rest;
    return document.scene().find(io::ObjectId{id});
}

io::Result<io::Value> getObject(const Document& document, const io::Object& object, std::string_view path)
{
    if (path == "template") return io::Value{document.scene().templateName(object.templateId)};
    io::Result<io::Value> value = valueAt(object, path);
    if (value && path.empty()) (*value)["template"] = document.scene().templateName(object.templateId);
    return value;
}

// What fields() cannot know: names of templates, groups that exist and no ring of them, no flat objects.
io::Status setInObject(const Document& document, io::Object& object, std::string_view path, const io::Value& value)
{
    if (path == "template") {
        const std::string* name = value.asString();
        const io::TemplateId id = name ? document.scene().findTemplate(*name) : io::TemplateId::None;
        if (!document.scene().find(id)) return io::Error{{}, "names no template of this project"};
        if (object.templateId == io::TemplateId::None) return io::Error{{}, "a group has no template"};
        object.templateId = id;
        return {};
    }
    if (const io::Status set = io::setField(object, path, value); !set) return set;
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(object.transform.scale[axis]) < 1e-6f)
            return io::Error{{}, "a scale of 0 would leave nothing to see"};
    if (object.parent != io::ObjectId::None) {
        const io::Object* group = document.scene().find(object.parent);
        if (!group || group->templateId != io::TemplateId::None) return io::Error{{}, "the parent is no group"};
        const auto inside = document.hierarchy().withMembers({&object.id, 1});
        if (std::ranges::find(inside, object.parent) != inside.end())
            return io::Error{{}, "a group cannot be inside itself"};
    }
    return {};
}

io::Status setObject(Document& document, std::string_view key, std::string_view rest, const io::Value& value)
{
    std::string_view path;
    const io::Object* object = objectNamed(document, rest, path);
    if (!object) return unknown("object", rest);
    io::Object changed = *object;
    if (const io::Status set = setInObject(document, changed, path, value); !set) return set;
    const io::ObjectId id = object->id;
    edit(document, "Set " + std::string{key}, {&id, 1}, [&](io::Object& o) { o = changed; });
    return {};
}

io::Status setInCamera(Document& document, std::string_view key, std::string_view rest, const io::Value& value)
{
    std::vector<io::Camera> cameras(document.scene().cameras().begin(), document.scene().cameras().end());
    std::string_view path;
    io::Camera* camera = longestNamed(std::span{cameras}, rest, path);
    if (!camera) return unknown("camera", rest);
    if (const io::Status set = io::setField(*camera, path, value); !set) return set;
    const auto named = std::ranges::count(cameras, camera->name, &io::Camera::name);
    if (camera->name.empty() || named > 1) return io::Error{{}, "a camera needs a name of its own"};
    setCameras(document, "Set " + std::string{key}, std::move(cameras));
    return {};
}

io::Status setInPath(Document& document, std::string_view key, std::string_view rest, const io::Value& value)
{
    std::vector<io::CameraPath> paths(document.scene().paths().begin(), document.scene().paths().end());
    std::string_view path;
    io::CameraPath* found = longestNamed(std::span{paths}, rest, path);
    if (!found) return unknown("camera path", rest);
    if (const io::Status set = io::setField(*found, path, value); !set) return set;
    if (!std::ranges::is_sorted(found->keys, {}, &io::PathKey::time))
        return io::Error{{}, "the times of a path must rise"};
    setPaths(document, "Set " + std::string{key}, std::move(paths));
    return {};
}

io::Status setInTemplate(Document& document, std::string_view key, std::string_view rest, const io::Value& value)
{
    std::string_view path;
    const io::Scene::TemplateSlot* slot = longestNamed(document.scene().templates(), rest, path);
    if (!slot || !slot->value) return unknown("template", rest);
    io::Template changed = *slot->value;
    if (const io::Status set = io::setField(changed, path, value); !set) return set;
    setTemplate(document, "Set " + std::string{key}, document.scene().findTemplate(slot->name), std::move(changed));
    return {};
}

io::Status setAny(Document& document, std::string_view key, const io::Value& value)
{
    const auto [kind, rest] = cut(key);
    const std::string name = "Set " + std::string{key};
    if (kind == "terrain") {
        io::Terrain changed = document.scene().terrain();
        if (const io::Status set = io::setField(changed, rest, value); !set) return set;
        return setTerrain(document, name, std::move(changed));
    }
    if (kind == "camera") return setInCamera(document, key, rest, value);
    if (kind == "path") return setInPath(document, key, rest, value);
    if (kind == "template") return setInTemplate(document, key, rest, value);
    if (kind == "object") return setObject(document, key, rest, value);
    return io::Error{{}, "keys begin with environment, terrain, camera, path, template or object"};
}

// Those of `keys` that begin with this, without it.
std::vector<std::string_view> keysUnder(std::string_view section, const std::vector<std::string_view>& keys)
{
    std::vector<std::string_view> under;
    for (const std::string_view key : keys)
        if (key.starts_with(section)) under.push_back(key.substr(section.size()));
    return under;
}

// What was set stays, what must be in order with it makes room; an error where both were set.
io::Status mendOrder(io::Environment& environment, const std::vector<std::string_view>& set)
{
    constexpr std::string_view kShadows = "shadows.";
    if (const auto keys = keysUnder(kShadows, set); !keys.empty())
        if (const std::optional<io::EndFault> fault = io::spreadEnds(environment.shadows, keys))
            return io::Error{"environment.shadows." + fault->key, fault->what};
    for (const io::OrderFault& fault : io::orderFaults(environment)) {
        const bool less = std::ranges::count(set, fault.less), greater = std::ranges::count(set, fault.greater);
        if (less && greater) return io::Error{"environment." + std::string{fault.greater}, fault.what};
        if (less || greater) io::keepOrder(environment, less ? fault.less : fault.greater);
    }
    return {};
}

io::Result<io::Value> getAny(const Document& document, std::string_view key)
{
    const auto [kind, rest] = cut(key);
    const io::Scene& scene = document.scene();
    std::string_view path;
    if (kind == "environment") return valueAt(scene.environment(), rest);
    if (kind == "terrain") return valueAt(scene.terrain(), rest);
    if (kind == "camera") {
        const io::Camera* camera = longestNamed(scene.cameras(), rest, path);
        return camera ? valueAt(*camera, path) : io::Result<io::Value>{unknown("camera", rest)};
    }
    if (kind == "path") {
        const io::CameraPath* found = longestNamed(scene.paths(), rest, path);
        return found ? valueAt(*found, path) : unknown("camera path", rest);
    }
    if (kind == "template") {
        const io::Scene::TemplateSlot* slot = longestNamed(scene.templates(), rest, path);
        return slot && slot->value ? valueAt(*slot->value, path) : unknown("template", rest);
    }
    if (kind == "object") {
        const io::Object* object = objectNamed(document, rest, path);
        return object ? getObject(document, *object, path) : unknown("object", rest);
    }
    return io::Error{{}, "keys begin with environment, terrain, camera, path, template or object"};
}

// One name of the key in front: the whole one.
io::Error under(std::string_view key, const io::Error& error)
{
    return io::Error{std::string{key}, error.what};
}

} // namespace

io::Result<io::Value> getProperty(const Document& document, std::string_view key)
{
    io::Result<io::Value> value = getAny(document, key);
    if (!value) return under(key, value.error());
    return value;
}

io::Status setProperty(Document& document, std::string_view key, const io::Value& value)
{
    if (cut(key).kind == "environment") return setProperties(document, {{std::string{key}, value}});
    const io::Status set = setAny(document, key, value);
    if (!set) return under(key, set.error());
    return {};
}

io::Status setProperties(Document& document, const std::vector<Property>& properties)
{
    io::Environment changed = document.scene().environment();
    std::vector<std::string_view> keys;
    for (const Property& property : properties) {
        keys.push_back(cut(property.key).rest);
        if (const io::Status set = io::setField(changed, keys.back(), property.value); !set)
            return under(property.key, set.error());
    }
    if (io::Status ordered = mendOrder(changed, keys); !ordered) return ordered;
    if (!properties.empty()) setEnvironment(document, "Set " + properties.front().key, std::move(changed));
    return {};
}

io::Value valueFromText(std::string_view text)
{
    if (text.starts_with('['))
        if (io::Result<io::Value> list = io::parseJson(text, "value")) return std::move(*list);
    return text;
}

} // namespace editor
