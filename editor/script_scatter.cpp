// Scatter layers: their list, and what brushes and rules do to their plants.
#include "editor/script_commands.h"

#include "editor/scatter_steps.h"
#include "io/scene/field_value.h"

#include <algorithm>
#include <fmt/format.h>

namespace editor {
namespace {

struct Keys {
    std::vector<std::string> names;
    void operator()(const char* key, const auto&, const io::Hint&) { names.emplace_back(key); }
};

std::vector<io::Species> speciesFrom(Arguments& arguments, const io::Value& list)
{
    std::vector<io::Species> species;
    const io::Value::Array* items = list.asArray();
    if (!items || items->size() > io::kMostSpecies) arguments.fail("species: a list of templates, at most 256");
    else
        for (const io::Value& item : *items) {
            io::Species& one = species.emplace_back();
            if (const std::string* name = item.asString()) one.templateName = *name;
            const io::Value::Object* members = item.asObject();
            if (members)
                for (const auto& [key, value] : *members)
                    if (const io::Status set = io::setField(one, key, value); !set) arguments.fail("species: " + set.error().what);
            if (one.templateName.empty()) arguments.fail("species: each is a template's name, or has \"template\"");
        }
    return species;
}

io::Value countsOf(const Document& document, io::ScatterId layer)
{
    return io::Value::Object{{"id", io::number(layer)}, {"count", std::uint64_t(io::instanceCount(document.scene().instances(layer)))}};
}

Answer answer(io::Value value)
{
    return io::Result<io::Value>{std::move(value)};
}

// Adds a layer of that name, changes it, or takes it away with "remove": true.
Answer scatterLayer(Script& script, Arguments& arguments)
{
    Document& document = script.document();
    const std::string name = arguments.text("name");
    const bool remove = arguments.flag("remove", false);
    const io::ScatterLayer* known = document.scene().findScatterLayer(name);
    if (name.empty()) arguments.fail("name: must not be empty");
    if (remove && !known) arguments.fail("there is no scatter layer \"" + name + "\"");
    io::ScatterLayer layer = known ? *known : io::ScatterLayer{.name = name};
    Keys keys;
    fields(keys, layer);
    for (const std::string& key : keys.names) {
        if (key == "id" || key == "name") continue;
        const io::Value* value = arguments.value(key);
        if (!value) continue;
        if (key == "species") layer.species = speciesFrom(arguments, *value);
        else if (const io::Status set = io::setField(layer, key, *value); !set) arguments.fail(key + ": " + set.error().what);
    }
    const std::string renamed = arguments.text("rename", name);
    if (renamed != name && document.scene().findScatterLayer(renamed)) arguments.fail("rename: \"" + renamed + "\" is taken");
    for (const io::Species& species : layer.species)
        if (!document.scene().find(document.scene().findTemplate(species.templateName))) arguments.fail("species: there is no template \"" + species.templateName + "\"");
    if (const auto fault = arguments.finish()) return *fault;
    if (remove) {
        removeScatterLayer(document, "Remove scatter layer", layer.id);
        return io::Value::Object{};
    }
    layer.name = renamed;
    std::vector<io::ScatterLayer> layers{document.scene().scatterLayers().begin(), document.scene().scatterLayers().end()};
    if (known) *std::ranges::find(layers, layer.id, &io::ScatterLayer::id) = layer;
    else {
        layer.id = document.freshScatterId();
        layers.push_back(layer);
    }
    const Gesture gesture{document, known ? "Change scatter layer" : "Add scatter layer"};
    if (known && layer.species != known->species) setSpecies(document, "Change scatter layer", layer.id, layer.species);
    setScatterLayers(document, known ? "Change scatter layer" : "Add scatter layer", std::move(layers));
    return answer(countsOf(document, layer.id));
}

const io::ScatterLayer* layerNamed(Script& script, Arguments& arguments)
{
    const std::string name = arguments.text("layer");
    const io::ScatterLayer* layer = script.document().scene().findScatterLayer(name);
    if (!layer) arguments.fail("there is no scatter layer \"" + name + "\"");
    return layer;
}

// "at" with "radius", "polygon", or "everywhere": true.
PlantRegion regionOf(Arguments& arguments)
{
    const auto at = arguments.ground("at");
    const double radius = arguments.number("radius", 10, 0, 1e6);
    const bool everywhere = arguments.flag("everywhere", false);
    const io::Value* polygon = arguments.value("polygon");
    if (int(at.has_value()) + int(everywhere) + int(polygon != nullptr) != 1) arguments.fail("needs one of \"at\", \"polygon\" and \"everywhere\": true");
    if (everywhere) return PlantRegion::everywhere();
    if (!polygon) return PlantRegion::disc(at.value_or(glm::dvec2{0}), radius);
    std::vector<glm::dvec2> corners;
    const io::Value::Array* list = polygon->asArray();
    if (list)
        for (const io::Value& corner : *list) {
            const io::Value::Array* pair = corner.asArray();
            if (pair && pair->size() == 2 && (*pair)[0].asNumber() && (*pair)[1].asNumber()) corners.push_back({*(*pair)[0].asNumber(), *(*pair)[1].asNumber()});
        }
    if (!list || corners.size() != list->size() || corners.size() < 3) arguments.fail("polygon: at least three [x, z]");
    return PlantRegion::polygon(std::move(corners));
}

std::vector<bool> speciesMeant(Arguments& arguments, const io::ScatterLayer* layer, const char* key)
{
    const io::Value* value = arguments.value(key);
    if (!value || !layer) return {};
    std::vector<bool> meant(layer->species.size());
    const io::Value::Array one{*value};
    for (const io::Value& name : value->asArray() ? *value->asArray() : one) {
        const std::string* text = name.asString();
        const auto found = text ? std::ranges::find(layer->species, *text, &io::Species::templateName) : layer->species.end();
        if (found == layer->species.end()) arguments.fail(std::string{key} + ": is no species of the layer");
        else meant[std::size_t(found - layer->species.begin())] = true;
    }
    return meant;
}

Answer changed(Script& script, const io::ScatterLayer& layer, const char* name, InstanceSlots slots)
{
    const std::size_t before = io::instanceCount(script.document().scene().instances(layer.id));
    const io::ScatterId id = layer.id;
    setInstances(script.document(), name, std::move(slots));
    const std::size_t now = io::instanceCount(script.document().scene().instances(id));
    return io::Value::Object{{"count", std::uint64_t(now)}, {"changed", std::int64_t(now) - std::int64_t(before)}};
}

Answer plant(Script& script, Arguments& arguments)
{
    const io::ScatterLayer* layer = layerNamed(script, arguments);
    const PlantRegion region = regionOf(arguments);
    if (const auto fault = arguments.finish()) return *fault;
    return changed(script, *layer, "Plant", planted(layerTiles(script.document().scene(), *layer), plantingOf(script.document(), *layer, &script.picker()), region));
}

Answer erase(Script& script, Arguments& arguments)
{
    const io::ScatterLayer* layer = layerNamed(script, arguments);
    const PlantRegion region = regionOf(arguments);
    std::vector<bool> species = speciesMeant(arguments, layer, "species");
    if (const auto fault = arguments.finish()) return *fault;
    LayerTiles tiles = layerTiles(script.document().scene(), *layer);
    tiles.species = std::move(species);
    return changed(script, *layer, "Erase plants", erased(tiles, region));
}

Answer thin(Script& script, Arguments& arguments)
{
    const io::ScatterLayer* layer = layerNamed(script, arguments);
    const PlantRegion region = regionOf(arguments);
    std::vector<bool> species = speciesMeant(arguments, layer, "species");
    const double share = arguments.number("share", 0.5, 0, 1);
    if (const auto fault = arguments.finish()) return *fault;
    LayerTiles tiles = layerTiles(script.document().scene(), *layer);
    tiles.species = std::move(species);
    return changed(script, *layer, "Thin plants", thinned(tiles, region, share));
}

Answer replace(Script& script, Arguments& arguments)
{
    const io::ScatterLayer* layer = layerNamed(script, arguments);
    const PlantRegion region = regionOf(arguments);
    if (!arguments.has("from") || !arguments.has("to")) arguments.fail("needs \"from\" and \"to\"");
    const std::vector<bool> from = speciesMeant(arguments, layer, "from"), to = speciesMeant(arguments, layer, "to");
    if (const auto fault = arguments.finish()) return *fault;
    const auto indexOf = [](const std::vector<bool>& meant) { return std::uint8_t(std::ranges::find(meant, true) - meant.begin()); };
    const Document& document = script.document();
    LayerTiles tiles = layerTiles(document.scene(), *layer);
    tiles.species = from;
    const std::size_t count = countIn(tiles, region);
    setInstances(script.document(), "Replace species", replaced(tiles, plantRules(document.scene(), document.assets(), *layer), region, indexOf(from), indexOf(to)));
    return io::Value::Object{{"count", std::uint64_t(io::instanceCount(script.document().scene().instances(tiles.layer)))}, {"changed", std::uint64_t(count)}};
}

// A rule layer anew, besides what was done by hand.
Answer evaluate(Script& script, Arguments& arguments)
{
    const io::ScatterLayer* layer = layerNamed(script, arguments);
    if (layer && !layer->rule) arguments.fail("\"" + layer->name + "\" has no rules; \"plant\" with \"everywhere\": true fills it");
    if (const auto fault = arguments.finish()) return *fault;
    auto slots = evaluated(layerTiles(script.document().scene(), *layer), plantingOf(script.document(), *layer, &script.picker()), PlantRegion::everywhere().bounds());
    return changed(script, *layer, "Evaluate rules", *std::move(slots));
}

Answer clear(Script& script, Arguments& arguments)
{
    const io::ScatterLayer* layer = layerNamed(script, arguments);
    if (const auto fault = arguments.finish()) return *fault;
    clearPlants(script.document(), "Clear plants", layer->id);
    return io::Value::Object{};
}

Answer toObjects(Script& script, Arguments& arguments)
{
    const io::ScatterLayer* layer = layerNamed(script, arguments);
    const PlantRegion region = regionOf(arguments);
    if (const auto fault = arguments.finish()) return *fault;
    const auto ids = plantsToObjects(script.document(), "Plants to objects", layer->id, region);
    return io::Value::Object{{"ids", toValue(ids)}, {"count", std::uint64_t(ids.size())}};
}

Answer plants(Script& script, Arguments& arguments)
{
    const io::ScatterLayer* layer = layerNamed(script, arguments);
    const PlantRegion region = regionOf(arguments);
    if (const auto fault = arguments.finish()) return *fault;
    const io::InstanceTiles& tiles = script.document().scene().instances(layer->id);
    return io::Value::Object{{"count", std::uint64_t(countIn(tiles, region))}, {"hash", fmt::format("{:016x}", io::instanceHash(tiles))}};
}

constexpr ScriptCommand kCommands[] = {
    {"scatter_layer", scatterLayer}, {"plant", plant},       {"erase_plants", erase},          {"thin", thin},
    {"replace_plants", replace},     {"evaluate", evaluate}, {"clear_plants", clear},          {"plants_to_objects", toObjects},
    {"plants", plants},
};

} // namespace

std::span<const ScriptCommand> scatterCommands()
{
    return kCommands;
}

} // namespace editor
