#include "editor/script_commands.h"

#include "editor/painting.h"
#include "editor/scatter_steps.h"
#include "editor/stamp_file.h"
#include "editor/stroke.h"

#include <algorithm>

namespace editor {
namespace {

template <class Enum> Enum named(Arguments& arguments, const char* key, Enum usual)
{
    if (!arguments.has(key)) return usual;
    const std::string word = arguments.text(key, "");
    const auto names = enumNames(usual);
    std::string all;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (word == names[i]) return Enum(i);
        all += (i > 0 ? ", " : "") + std::string{names[i]};
    }
    arguments.fail(std::string{key} + ": \"" + word + "\" is none of " + all);
    return usual;
}

// One dab of a brush, or a ramp, as one step.
Answer sculpt(Script& script, Arguments& arguments)
{
    Brush brush;
    if (!arguments.has("tool")) arguments.fail("needs \"tool\"");
    brush.tool = named(arguments, "tool", brush.tool);
    const auto at = arguments.pair("at"), to = arguments.pair("to");
    if (!at) arguments.fail("needs \"at\"");
    if (brush.tool == BrushTool::Ramp && !to) arguments.fail("a ramp needs \"to\"");
    if (brush.tool == BrushTool::Ramp && at && to && glm::distance(*at, *to) < 1e-3) arguments.fail("\"at\" and \"to\" of a ramp are one place");
    if (!shapes(brush.tool)) arguments.fail("layers are painted by \"do\":\"paint\", grass by \"do\":\"grass\"");
    brush.radius = float(arguments.number("radius", double(brush.radius), 0.01, 1e5));
    const double strength = arguments.number("strength", 1, -1e5, 1e5);
    brush.falloff = float(arguments.number("falloff", 1, 0, 1));
    brush.curve = named(arguments, "curve", brush.curve);
    brush.noise = named(arguments, "noise", brush.noise);
    brush.scale = float(arguments.number("scale", double(brush.scale), 0.01, 1e5));
    brush.step = float(arguments.number("step", double(brush.step), 0.01, 1e4));
    brush.talus = float(arguments.number("talus", double(brush.talus), 1, 89));
    brush.seed = int(arguments.number("seed", 1, 0, 1e9));
    brush.levelGiven = arguments.has("level");
    brush.level = float(arguments.number("level", 0, -1e5, 1e5));
    brush.slope = glm::vec2{arguments.pair("slope").value_or(glm::dvec2{brush.slope})};
    brush.altitude = glm::vec2{arguments.pair("altitude").value_or(glm::dvec2{brush.altitude})};
    if (brush.tool == BrushTool::Stamp) {
        brush.stampFile = arguments.text("stamp");
        brush.rotation = float(arguments.number("rotation", 0, -360, 360));
    }
    if (!script.document().scene().heights()) arguments.fail("this scene has no ground");
    if (const auto fault = arguments.finish()) return *fault;
    if (brush.tool == BrushTool::Stamp) {
        auto stamp = readStamp(script.document().project().folder, brush.stampFile);
        if (!stamp) return stamp.error();
        brush.stamp = *std::move(stamp);
    }
    const std::optional<HeightPatch> patch = patchOf(*script.document().scene().heights(), brush, *at, to.value_or(*at), float(strength));
    if (!patch) return io::Error{{}, "there is no ground there"};
    Stroke stroke{script.document(), brush, {}, "Sculpt"};
    stroke.change(*patch);
    stroke.end();
    return io::Value::Object{{"texels", io::Value::Array{patch->heights.size.x, patch->heights.size.y}}};
}

int layerNamed(Script& script, Arguments& arguments, const char* key)
{
    const io::Value* value = arguments.value(key);
    const auto& layers = script.document().scene().terrain().layers;
    if (!value) arguments.fail(std::string{"needs \""} + key + "\"");
    else if (const double* number = value->asNumber(); number && *number >= 0 && *number < double(std::min<std::size_t>(layers.size(), io::kMostLayers))) return int(*number);
    else if (const std::string* name = value->asString())
        for (std::size_t i = 0; i < std::min<std::size_t>(layers.size(), io::kMostLayers); ++i)
            if (layers[i].name == *name) return int(i);
    arguments.fail(std::string{key} + ": is no layer of the ground");
    return 0;
}

// One dab of a layer as one step; "tool" erase or replace (of "replaced") in place of paint.
Answer paint(Script& script, Arguments& arguments)
{
    Brush brush{.tool = BrushTool::Paint};
    if (arguments.has("tool")) brush.tool = named(arguments, "tool", brush.tool);
    if (!paints(brush.tool)) arguments.fail("tool: must be paint, erase, replace or hole");
    if (brush.tool == BrushTool::Paint || brush.tool == BrushTool::Replace) brush.layer = layerNamed(script, arguments, "layer");
    if (brush.tool == BrushTool::Replace) brush.replaced = layerNamed(script, arguments, "replaced");
    const auto at = arguments.pair("at");
    const bool everywhere = arguments.flag("everywhere", false);
    if (!at && !everywhere) arguments.fail("needs \"at\", or \"everywhere\": true");
    brush.radius = float(arguments.number("radius", double(brush.radius), 0.01, 1e5));
    brush.falloff = float(arguments.number("falloff", 1, 0, 1));
    brush.slope = glm::vec2{arguments.pair("slope").value_or(glm::dvec2{brush.slope})};
    brush.altitude = glm::vec2{arguments.pair("altitude").value_or(glm::dvec2{brush.altitude})};
    const auto strength = float(arguments.number("strength", 1, brush.tool == BrushTool::Hole ? -1 : 0, 1));
    const io::Scene& scene = script.document().scene();
    if (!scene.heights()) arguments.fail("this scene has no ground");
    if (const auto fault = arguments.finish()) return *fault;
    const auto patch = paintOn(*scene.heights(), coverOf(scene), brush, {.centre = at.value_or(glm::dvec2{0}), .amount = strength}, everywhere);
    if (!patch) return io::Error{{}, "there is no ground there"};
    const PlantRegion touched = everywhere ? PlantRegion::everywhere() : PlantRegion::disc(*at, double(brush.radius));
    const Gesture gesture{script.document(), "Paint"};
    changeCover(script.document(), "Paint", *patch);
    followRules(script.document(), "Paint", touched.bounds());
    return io::Value::Object{{"texels", io::Value::Array{patch->size.x, patch->size.y}}};
}

int grassNamed(Script& script, Arguments& arguments)
{
    const io::Value* value = arguments.value("kind");
    const auto& kinds = script.document().scene().grass().kinds;
    const std::string* name = value ? value->asString() : nullptr;
    const auto found = std::ranges::find_if(kinds, [&](const io::GrassKind& kind) { return name && kind.name == *name; });
    if (found == kinds.end()) arguments.fail("kind: is no kind of grass of this scene");
    return int(found - kinds.begin());
}

// One dab of grass as one step; "tool" mow or grass_height in place of grow.
Answer growGrass(Script& script, Arguments& arguments)
{
    Brush brush{.tool = BrushTool::Grow};
    brush.tool = named(arguments, "tool", brush.tool);
    if (!growsGrass(brush.tool)) arguments.fail("tool: must be grow, mow or grass_height");
    brush.everyKind = brush.tool == BrushTool::Mow && !arguments.has("kind");
    if (brush.tool == BrushTool::Grow || arguments.has("kind")) brush.kind = grassNamed(script, arguments);
    const auto at = arguments.pair("at");
    const bool everywhere = arguments.flag("everywhere", false);
    if (!at && !everywhere) arguments.fail("needs \"at\", or \"everywhere\": true");
    brush.radius = float(arguments.number("radius", double(brush.radius), 0.01, 1e5));
    brush.falloff = float(arguments.number("falloff", 0, 0, 1));
    brush.density = float(arguments.number("density", 1, 0, 1));
    brush.height = float(arguments.number("height", 1, 0.05, 1.99));
    brush.slope = glm::vec2{arguments.pair("slope").value_or(glm::dvec2{brush.slope})};
    brush.altitude = glm::vec2{arguments.pair("altitude").value_or(glm::dvec2{brush.altitude})};
    const auto strength = float(arguments.number("strength", 1, 0, 1));
    const io::Scene& scene = script.document().scene();
    if (!scene.heights()) arguments.fail("this scene has no ground");
    if (const auto fault = arguments.finish()) return *fault;
    const auto patch = growOn(*scene.heights(), grassMapOf(scene), brush, {.centre = at.value_or(glm::dvec2{0}), .amount = strength}, everywhere);
    if (!patch) return io::Error{{}, "there is no ground there"};
    changeGrassMap(script.document(), "Grass", *patch);
    return io::Value::Object{{"texels", io::Value::Array{patch->size.x, patch->size.y}}};
}

constexpr ScriptCommand kCommands[] = {{"sculpt", sculpt}, {"paint", paint}, {"grass", growGrass}};

} // namespace

std::span<const ScriptCommand> groundCommands()
{
    return kCommands;
}

} // namespace editor
