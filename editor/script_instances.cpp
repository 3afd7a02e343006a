// Instances of scatter layers in scripts.
#include "editor/instance_edits.h"
#include "editor/script_commands.h"
#include "io/scene/field_words.h"
#include "io/scene/instance_walk.h"

namespace editor {
namespace {

const io::ScatterLayer* layerNamed(Script& script, Arguments& arguments)
{
    if (!arguments.has("layer")) return nullptr;
    const std::string name = arguments.text("layer");
    const io::ScatterLayer* layer = script.document().scene().findScatterLayer(name);
    if (!layer) arguments.fail("there is no scatter layer \"" + name + "\"");
    return layer;
}

io::Value brief(const io::Scene& scene, io::ObjectId id, const io::ScatterLayer& layer, io::TemplateId templateId, const io::Transform& transform)
{
    return io::Value::Object{{"id", io::number(id)},
                             {"layer", layer.name},
                             {"template", scene.templateName(templateId)},
                             {"position", toValue(transform.position)},
                             {"rotation", toValue(glm::dvec3{transform.rotation})},
                             {"scale", io::decimal(transform.scale.x)}};
}

Answer instances(Script& script, Arguments& arguments)
{
    const io::Scene& scene = script.document().scene();
    const io::ScatterLayer* only = layerNamed(script, arguments);
    const io::TemplateId what = arguments.has("template") ? arguments.templateNamed("template") : io::TemplateId::None;
    const double limit = arguments.number("limit", 1e9, 0, 1e9);
    if (const auto fault = arguments.finish()) return *fault;
    io::Value::Array list, layers;
    std::uint64_t count = 0;
    for (const io::ScatterLayer& layer : scene.scatterLayers()) {
        if (only && only != &layer) continue;
        const std::uint64_t before = count;
        for (const auto& [place, tile] : scene.instances(layer.id))
            io::eachInstance(scene, {layer.id, place}, [&](io::ObjectId id, io::TemplateId templateId, const io::Transform& transform) {
                if (what != io::TemplateId::None && templateId != what) return;
                if (double(count++) < limit) list.push_back(brief(scene, id, layer, templateId, transform));
            });
        layers.push_back(io::Value::Object{{"id", io::number(layer.id)}, {"name", layer.name}, {"count", count - before}});
    }
    return io::Value::Object{{"count", count}, {"layers", std::move(layers)}, {"instances", std::move(list)}};
}

Answer promote(Script& script, Arguments& arguments)
{
    const std::vector<io::ObjectId> ids = arguments.instances();
    if (const auto fault = arguments.finish()) return *fault;
    const std::vector<io::ObjectId> made = editor::promote(script.document(), "Turn into objects", ids);
    script.follow();
    script.selection().set(made);
    return io::Value::Object{{"ids", toValue(made)}};
}

Answer demote(Script& script, Arguments& arguments)
{
    const std::vector<io::ObjectId> ids = arguments.ids();
    const io::ScatterLayer* layer = layerNamed(script, arguments);
    if (const auto fault = arguments.finish()) return *fault;
    const Demoted done = editor::demote(script.document(), "Turn into instances", ids, layer ? layer->id : io::ScatterId::None);
    if (done.instances.empty()) return io::Error{{}, "none of them can be an instance: their templates must be species of a scatter layer, their scale one factor"};
    script.follow();
    std::vector<io::ObjectId> made;
    for (const io::InstanceRef& instance : done.instances)
        made.push_back(script.document().scene().idOf(instance));
    script.selection().set(made);
    return io::Value::Object{{"ids", toValue(made)}, {"left", std::uint64_t(done.left)}};
}

constexpr ScriptCommand kCommands[] = {{"instances", instances}, {"promote", promote}, {"demote", demote}};

} // namespace

std::span<const ScriptCommand> instanceCommands()
{
    return kCommands;
}

} // namespace editor
