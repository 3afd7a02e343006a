#include "io/files/scene_file.h"

#include "io/files/headed_file.h"

#include <algorithm>
#include <future>
#include <span>
#include <thread>
#include <unordered_map>
#include <unordered_set>

namespace io {
namespace {

constexpr const char* kFormat = "wold-scene";
constexpr std::string_view kLastId = "last_id";
constexpr float kSmallestScale = 1e-6f;

ObjectId highestId(const Scene& scene)
{
    ObjectId highest = ObjectId::None;
    for (const Object& object : scene.objects())
        highest = std::max(highest, object.id);
    return highest;
}

// Finds slots by name faster than the scene's own search, for a million objects.
class TemplateNames {
public:
    TemplateNames(Scene& scene, Source& source) : m_scene{scene}, m_source{source} {}

    TemplateId operator()(std::string_view name, const char* at)
    {
        if (name.empty()) return TemplateId::None;
        const auto known = m_ids.find(std::string{name});
        if (known != m_ids.end()) return known->second;
        if (!m_scene.find(m_scene.findTemplate(name)))
            m_source.complain(Severity::Error, at,
                              "template: \"" + std::string{name} +
                                  "\" is no template of this project; add it, or the objects stay empty places");
        return m_ids[std::string{name}] = m_scene.templateSlot(name);
    }

private:
    Scene& m_scene;
    Source& m_source;
    std::unordered_map<std::string, TemplateId> m_ids;
};

class ObjectsReader {
public:
    ObjectsReader(Scene& scene, Source& source) : m_scene{scene}, m_source{source} {}

    void read(JsonValue list)
    {
        if (!isArray(list))
            return m_source.complain(Severity::Error, startOf(list), "objects: expected a list in brackets");
        for (auto item : list.get_array())
            readOne(item.value());
    }
    void finish() // when all ids are known
    {
        for (auto& [object, at] : m_nameless)
            m_scene.exchange(m_scene.freshId(), std::move(object));
        mendParents();
    }

private:
    void readOne(JsonValue value)
    {
        const char* at = startOf(value);
        if (!isObject(value))
            return m_source.complain(Severity::Error, at, "objects: expected an object in braces; left out");
        ObjectLine line;
        readSection(line, value.get_object(), nullptr, Unknown{&line.extra, {}}, m_source,
                    [](auto&&...) { return false; });
        mendScale(line, at);
        if (line.id == ObjectId::None) {
            m_source.complain(Severity::Error, at, "id: missing; the object gets a new one");
            m_nameless.emplace_back(std::move(line), at);
        } else if (m_scene.find(line.id)) {
            m_source.complain(Severity::Error, at,
                              "id: " + std::to_string(number(line.id)) +
                                  " is taken by an object above; this one is left out");
        } else {
            if (line.parent != ObjectId::None) m_children.emplace_back(line.id, at);
            const ObjectId id = line.id;
            m_scene.exchange(id, Object{std::move(line)});
        }
    }
    void mendScale(Object& object, const char* at)
    {
        for (int axis = 0; axis < 3; ++axis) {
            float& s = object.transform.scale[axis];
            if (std::abs(s) >= kSmallestScale) continue;
            m_source.complain(Severity::Error, at, "scale: " + numberText(s) + " is too small; made 0.000001");
            s = std::copysign(kSmallestScale, s);
        }
    }
    void mendParents()
    {
        for (const auto& [id, at] : m_children)
            if (!m_scene.find(m_scene.at(id).parent)) orphan(id, at, "is no object of this scene");
        std::unordered_set<ObjectId> sound; // lead to the top
        for (const auto& [id, at] : m_children) {
            std::unordered_set<ObjectId> path;
            ObjectId up = id;
            while (up != ObjectId::None && !sound.contains(up) && path.insert(up).second)
                up = m_scene.at(up).parent;
            if (path.contains(up)) orphan(id, at, "makes a circle of parents");
            sound.insert(path.begin(), path.end());
        }
    }
    void orphan(ObjectId id, const char* at, const char* why)
    {
        Object object = m_scene.at(id);
        m_source.complain(Severity::Error, at,
                          "parent: " + std::to_string(number(object.parent)) + " " + why + "; removed");
        object.parent = ObjectId::None;
        m_scene.exchange(id, std::move(object));
    }

    Scene& m_scene;
    Source& m_source;
    std::vector<std::pair<ObjectId, const char*>> m_children;
    std::vector<std::pair<Object, const char*>> m_nameless;
};

// Layers are told apart by their ids and shown by their names: neither may be missing or there twice.
std::vector<ScatterLayer> mended(std::vector<ScatterLayer> layers, Scene& scene, const std::string& file, Complaints& complaints)
{
    for (const ScatterLayer& layer : layers)
        scene.takeIdsUpTo(layer.id);
    for (auto layer = layers.begin(); layer != layers.end(); ++layer) {
        const std::string where = "scatter." + std::to_string(layer - layers.begin());
        const auto complain = [&](const std::string& what) { complaints.push_back({Severity::Error, file, where + what}); };
        const auto above = [&](auto part) { return std::find_if(layers.begin(), layer, [&](const ScatterLayer& l) { return l.*part == (*layer).*part; }) != layer; };
        if (layer->id == ScatterId::None || above(&ScatterLayer::id)) {
            complain(layer->id == ScatterId::None ? ".id: missing; the layer gets a new one"
                                                  : ".id: " + std::to_string(number(layer->id)) + " is taken by a layer above; this one gets a new one");
            layer->id = scene.freshScatterId();
        }
        if (layer->name.empty() || above(&ScatterLayer::name)) {
            const std::string name = layer->name + "#" + std::to_string(number(layer->id));
            complain(".name: \"" + layer->name + "\" is " + (layer->name.empty() ? "empty" : "taken by a layer above") + "; renamed " + name);
            layer->name = name;
        }
        if (layer->species.size() <= kMostSpecies) continue;
        complain(".species: " + std::to_string(layer->species.size()) + " where " + std::to_string(kMostSpecies) + " are the most; the last ones are left out");
        layer->species.resize(kMostSpecies);
    }
    return layers;
}

// Writes the members of an object's line, without those that have their default. Compares with the fields of a
// default object, which come in the same order.
class LineWriter {
public:
    LineWriter(std::string& out, const Scene& scene) : m_out{out}, m_scene{scene}
    {
        static const Object kDefaults;
        Collector collect{m_defaults};
        fields(collect, kDefaults);
    }

    void line(const Object& object)
    {
        m_next = 0;
        m_out += "{\"id\":";
        appendNumber(m_out, double(number(object.id)));
        fields(*this, object);
        for (const auto& [path, json] : object.extra.keys()) {
            std::string key;
            if (!keyInSection(path, "", key)) continue;
            name(key);
            m_out += json;
        }
        m_out += '}';
    }
    template <class T> void operator()(std::string_view key, const T& value, const Hint&)
    {
        const bool always = key == "template" || key == "position";
        if (const void* usual = m_defaults[m_next++]; !always && value == *static_cast<const T*>(usual)) return;
        name(key);
        if constexpr (std::is_same_v<T, TemplateId>)
            appendString(m_out, m_scene.templateName(value));
        else
            appendLeaf(m_out, value);
    }

private:
    struct Collector {
        std::vector<const void*>& defaults;
        void operator()(const char*, const auto& value, const Hint&) { defaults.push_back(&value); }
    };

    void name(std::string_view key)
    {
        m_out += ',';
        appendString(m_out, key);
        m_out += ':';
    }

    std::string& m_out;
    const Scene& m_scene;
    std::vector<const void*> m_defaults;
    std::size_t m_next = 0;
};

// One line for each object, of many by all processors: what each writes is put together in their order.
void appendLines(std::string& out, const Scene& scene, std::span<const ObjectId> ids)
{
    constexpr std::size_t kFewest = 10'000; // of a thread
    const std::size_t count = std::clamp<std::size_t>(ids.size() / kFewest, 1, std::max(1u, std::thread::hardware_concurrency()));
    const auto write = [&](std::string& to, std::size_t part) {
        LineWriter lines{to, scene};
        for (std::size_t i = ids.size() * part / count; i < ids.size() * (part + 1) / count; ++i) {
            to += i == 0 ? "\n" : ",\n";
            lines.line(scene.at(ids[i]));
        }
    };
    std::vector<std::future<std::string>> others; // which hand on what they throw: want of memory is told, not died of
    for (std::size_t part = 1; part < count; ++part)
        others.push_back(std::async(std::launch::async, [&write, &ids, count, part] {
            std::string lines;
            lines.reserve(ids.size() / count * 128);
            write(lines, part);
            return lines;
        }));
    write(out, 0);
    for (std::future<std::string>& other : others)
        out += other.get();
}

} // namespace

Result<std::string> readSceneText(std::string text, const std::string& name, Scene& scene, Complaints& complaints)
{
    const std::size_t size = text.size();
    text.append(simdjson::SIMDJSON_PADDING, '\0');
    Complaints found;
    Source source{name, std::string_view{text}.substr(0, size), found};
    source.templateNamed = TemplateNames{scene, source};
    ObjectsReader objects{scene, source};
    ObjectId last = ObjectId::None;
    Result<SceneBody> body =
        readHeaded<SceneBody>(source, kFormat, [&](std::string_view key, JsonValue& value, const Place& place) {
            if (key == kLastId)
                readLeaf(last, value, kIdHint, place, source);
            else if (key == "objects")
                objects.read(value);
            else
                return false;
            return true;
        });
    if (!body) return body.error();
    scene.takeIdsUpTo(last);
    objects.finish();
    scene.lastSavedId = std::max(last, highestId(scene));
    source.finish();
    complaints.insert(complaints.end(), found.begin(), found.end());
    scene.exchange(std::move(body->terrain));
    scene.exchange(std::move(body->grass));
    scene.exchange(mended(std::move(body->scatter), scene, name, complaints));
    scene.extra = std::move(body->extra);
    return std::move(body->environment);
}

std::string sceneText(const Scene& scene, const std::string& environmentFile)
{
    return sceneText(scene, environmentFile, scene.terrain());
}

std::string sceneText(const Scene& scene, const std::string& environmentFile, const Terrain& terrain)
{
    std::string out;
    out.reserve(512 + scene.objects().size() * 128);
    FieldWriter writer{out, 0, &scene.extra};
    out += '{';
    const Headed<SceneBody> head{kFormat, kFileVersion, {environmentFile, terrain, scene.grass(), {scene.scatterLayers().begin(), scene.scatterLayers().end()}, {}}};
    fields(writer, head);
    const std::vector<ObjectId> ids = scene.sortedIds();
    if (scene.lastSavedId > (ids.empty() ? ObjectId::None : ids.back())) {
        writer.name(kLastId);
        appendNumber(out, double(number(scene.lastSavedId)));
    }
    writer.extras();
    writer.name("objects");
    out += '[';
    appendLines(out, scene, ids);
    out += ids.empty() ? "]\n}\n" : "\n]}\n";
    return out;
}

} // namespace io
