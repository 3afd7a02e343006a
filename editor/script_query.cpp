#include "editor/script_commands.h"

#include "editor/instance_edits.h"
#include "editor/placement.h"
#include "editor/properties.h"
#include "io/scene/ground.h"
#include "io/scene/ground_layers.h"

#include <algorithm>

namespace editor {

io::Value describe(const PickHit& hit, const io::Scene& scene)
{
    io::Value::Object members{{"surface", nameOf(hit.surface)}};
    if (hit.id != io::ObjectId::None) {
        members.emplace_back("id", io::number(hit.id));
        members.emplace_back("template", scene.templateName(hit.templateId));
    }
    if (const auto instance = scene.findInstance(hit.id)) members.emplace_back("layer", scene.find(instance->at.layer)->name);
    if (hit) {
        members.emplace_back("position", toValue(hit.position));
        members.emplace_back("normal", toValue(hit.normal));
        members.emplace_back("distance", hit.distance);
    }
    return members;
}

namespace {

io::Value brief(const io::Scene& scene, const io::Object& object)
{
    io::Value::Object members{{"id", io::number(object.id)},
                              {"template", scene.templateName(object.templateId)},
                              {"position", toValue(object.transform.position)}};
    if (!object.name.empty()) members.emplace_back("name", object.name);
    if (object.parent != io::ObjectId::None) members.emplace_back("parent", io::number(object.parent));
    return members;
}

Answer objects(Script& script, Arguments& arguments)
{
    const io::Scene& scene = script.document().scene();
    const bool all = !arguments.has("template");
    const io::TemplateId what = all ? io::TemplateId::None : arguments.templateNamed("template");
    const double limit = arguments.number("limit", 1e9, 0, 1e9);
    if (const auto fault = arguments.finish()) return *fault;
    io::Value::Array list;
    std::uint64_t count = 0;
    for (const io::ObjectId id : scene.sortedIds()) {
        const io::Object& object = scene.at(id);
        if (!all && object.templateId != what) continue;
        if (double(count++) < limit) list.push_back(brief(scene, object));
    }
    return io::Value::Object{{"count", count}, {"objects", std::move(list)}};
}

Answer object(Script& script, Arguments& arguments)
{
    const io::ObjectId id = arguments.object("id");
    if (const auto fault = arguments.finish()) return *fault;
    io::Result<io::Value> value = getProperty(script.document(), "object." + std::to_string(io::number(id)));
    if (!value) return value.error();
    (*value)["id"] = io::number(id);
    const io::WorldBox bounds = boundsOf(script.document(), {&id, 1});
    if (!bounds.empty()) (*value)["bounds"] = io::Value::Array{toValue(bounds.min), toValue(bounds.max)};
    return value;
}

Answer selection(Script& script, Arguments& arguments)
{
    if (const auto fault = arguments.finish()) return *fault;
    return io::Value::Object{{"ids", toValue(script.selection().ids())},
                             {"primary", io::number(script.selection().primary())},
                             {"count", std::uint64_t(script.selection().size())}};
}

Answer height(Script& script, Arguments& arguments)
{
    const auto at = arguments.ground("at");
    if (!at) arguments.fail("needs \"at\"");
    const bool layer = arguments.flag("layer", false);
    if (const auto fault = arguments.finish()) return *fault;
    const io::Scene& scene = script.document().scene();
    const auto& heights = scene.heights();
    const auto height = io::groundHeight(script.document().scene(), at->x, at->y);
    if (!height) return io::Error{{}, "there is no ground there"};
    const glm::dvec3 normal = heights->normal(at->x, at->y).value_or(glm::dvec3{0, 1, 0});
    io::Value::Object found{{"height", *height}, {"normal", toValue(normal)}};
    if (layer && !scene.terrain().layers.empty()) { // that shows most, without the noise at their borders
        const io::GroundLayers::Shares shares = io::GroundLayers{heights, scene.cover(), scene.terrain().layers}.at(at->x, at->y);
        const auto most = std::size_t(std::ranges::max_element(shares) - shares.begin());
        if (shares[most] > 0) found.emplace_back("layer", scene.terrain().layers[most].name);
    }
    return found;
}

Answer pick(Script& script, Arguments& arguments)
{
    const auto pixel = arguments.pair("pixel");
    const bool all = arguments.flag("all", false);
    if (!pixel) arguments.fail("needs \"pixel\"");
    if (const auto fault = arguments.finish()) return *fault;
    const io::Scene& scene = script.document().scene();
    if (!all) return describe(script.picker().pick(script.view(), *pixel), scene);
    io::Value::Array hits;
    for (const PickHit& hit : script.picker().pickAll(script.view(), *pixel))
        hits.push_back(describe(hit, scene));
    return io::Value::Object{{"hits", std::move(hits)}};
}

Answer stats(Script& script, Arguments& arguments)
{
    if (const auto fault = arguments.finish()) return *fault;
    const Document& document = script.document();
    std::uint64_t instances = 0, triangles = 0;
    for (const io::Object& object : document.scene().objects()) {
        instances += object.templateId != io::TemplateId::None;
        if (const io::Model* model = document.assets().model(object.templateId)) triangles += model->triangles();
    }
    instances += document.scene().instanceCount();
    for (const io::ScatterLayer& layer : document.scene().scatterLayers())
        triangles += trianglesOf(document, layer);
    const auto templates =
        std::ranges::count_if(document.scene().templates(), [](const auto& slot) { return slot.value.has_value(); });
    io::Value::Object members{{"objects", std::uint64_t(document.scene().objects().size())},
                              {"instances", instances},
                              {"triangles", triangles},
                              {"templates", std::uint64_t(templates)},
                              {"selected", std::uint64_t(script.selection().size())},
                              {"modified", document.modified()},
                              {"undo_steps", std::uint64_t(document.history().position())},
                              {"undo_bytes", std::uint64_t(document.history().bytes())}};
    if (script.hooks().stats) {
        const io::Value more = script.hooks().stats();
        if (const io::Value::Object* extra = more.asObject())
            members.insert(members.end(), extra->begin(), extra->end());
    }
    return members;
}

Answer history(Script& script, Arguments& arguments)
{
    if (const auto fault = arguments.finish()) return *fault;
    const History& history = script.document().history();
    io::Value::Array steps;
    for (std::string& name : history.names())
        steps.emplace_back(std::move(name));
    return io::Value::Object{
        {"steps", std::move(steps)}, {"position", std::uint64_t(history.position())}, {"dropped", history.dropped()}};
}

constexpr ScriptCommand kCommands[] = {
    {"objects", objects}, {"object", object}, {"selection", selection}, {"height", height},
    {"pick", pick},       {"stats", stats},   {"history", history},
};

} // namespace

std::span<const ScriptCommand> queryCommands()
{
    return kCommands;
}

} // namespace editor
