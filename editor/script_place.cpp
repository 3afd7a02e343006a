#include "editor/script_commands.h"

#include "editor/arrange.h"
#include "editor/delete_template.h"
#include "editor/placement.h"
#include "editor/scatter.h"
#include "io/scene/ground.h"

#include <algorithm>
#include <fmt/format.h>

namespace editor {
namespace {

// Where "at" [x,y,z] or [x,z], "pixel" or "camera" say.
std::optional<PickHit> target(Script& script, Arguments& arguments)
{
    const bool atCamera = arguments.flag("camera", false);
    const io::Value* at = arguments.value("at");
    const bool onGround = at && at->asArray() && at->asArray()->size() == 2;
    const auto ground = onGround ? arguments.pair("at") : std::nullopt;
    const auto point = onGround ? std::nullopt : arguments.triple("at");
    const auto pixel = arguments.pair("pixel");
    if (int(atCamera) + int(at != nullptr) + int(pixel.has_value()) != 1) {
        arguments.fail("needs one of \"at\", \"pixel\" and \"camera\"");
        return std::nullopt;
    }
    if (atCamera) return PickHit{.surface = Surface::Terrain, .position = script.view().camera.eye};
    if (pixel) {
        const PickHit hit = script.picker().pick(script.view(), *pixel);
        if (!hit) arguments.fail("there is nothing under that pixel");
        return hit;
    }
    const auto& heights = script.document().scene().heights();
    const glm::dvec2 flat = ground ? *ground : glm::dvec2{point->x, point->z};
    const auto height = io::groundHeight(script.document().scene(), flat.x, flat.y);
    const glm::dvec3 normal =
        heights ? heights->normal(flat.x, flat.y).value_or(glm::dvec3{0, 1, 0}) : glm::dvec3{0, 1, 0};
    if (ground && !height) {
        arguments.fail("there is no ground there");
        return std::nullopt;
    }
    return PickHit{.surface = Surface::Terrain,
                   .position = point ? *point : glm::dvec3{flat.x, *height, flat.y},
                   .normal = normal};
}

Answer place(Script& script, Arguments& arguments)
{
    const io::TemplateId what = arguments.templateNamed("template");
    const std::optional<PickHit> at = target(script, arguments);
    PlaceOptions options{.seed =
                             std::uint64_t(arguments.number("seed", double(script.document().revision()), 0, 1e15))};
    if (arguments.has("yaw")) options.yaw = float(arguments.number("yaw", 0, -1e6, 1e6));
    if (arguments.has("scale")) options.scale = float(arguments.number("scale", 1, 1e-6, 1e6));
    if (const auto fault = arguments.finish()) return *fault;
    const io::ObjectId id = editor::place(script.document(), what, placedOn(script.document(), what, *at, options));
    return io::Value::Object{{"id", io::number(id)}};
}

Answer scatter(Script& script, Arguments& arguments)
{
    const Document& document = script.document();
    PlantRules rules = plantRules(document.scene(), document.assets(), templatesOf(arguments));
    const auto centre = arguments.ground("center");
    if (!centre) arguments.fail("needs \"center\"");
    const double radius = arguments.number("radius", 10, 0, 1e6);
    rules.density = arguments.number("density", 0.05, 0, 1e4);
    rules.spacing = arguments.number("spacing", 0, 0, 1000);
    rules.seed = std::uint64_t(arguments.number("seed", 1, 0, 1e15));
    rules.slope = arguments.pair("slope").value_or(rules.slope);
    rules.altitude = arguments.pair("altitude").value_or(rules.altitude);
    if (rules.density * 3.1416 * radius * radius > double(kMostScattered))
        arguments.fail(fmt::format("would place more than {} objects", kMostScattered));
    if (!document.scene().heights()) arguments.fail("this scene has no ground");
    if (const auto fault = arguments.finish()) return *fault;
    const Planting planting{std::move(rules), document.scene()};
    const auto ids = editor::scatter(script.document(), "Scatter objects", planting, PlantRegion::disc(*centre, radius));
    return io::Value::Object{{"count", std::uint64_t(ids.size())}, {"ids", toValue(ids)}};
}

Answer idsAnswer(std::span<const io::ObjectId> ids)
{
    return io::Value::Object{{"ids", toValue(ids)}, {"count", std::uint64_t(ids.size())}};
}

// The copies, the group or its members are what one goes on with.
Answer selected(Script& script, std::span<const io::ObjectId> ids)
{
    script.selection().set(ids);
    return idsAnswer(ids);
}

Answer duplicate(Script& script, Arguments& arguments)
{
    const auto ids = arguments.ids();
    const glm::dvec3 by = arguments.triple("by").value_or(glm::dvec3{1, 0, 1});
    if (const auto fault = arguments.finish()) return *fault;
    return selected(script, editor::duplicate(script.document(), ids, by));
}

Answer remove(Script& script, Arguments& arguments)
{
    const auto ids = arguments.ids();
    if (const auto fault = arguments.finish()) return *fault;
    const auto all = script.document().hierarchy().withMembers(ids);
    removeObjects(script.document(),
                  "Delete " + std::to_string(all.size()) + (all.size() == 1 ? " object" : " objects"), ids);
    return idsAnswer(all);
}

Answer removeTemplate(Script& script, Arguments& arguments)
{
    const io::TemplateId what = arguments.templateNamed("template");
    const bool withObjects = arguments.flag("objects", false);
    if (const auto fault = arguments.finish()) return *fault;
    const auto count = deleteTemplate(script.document(), what, withObjects);
    if (!count) return count.error();
    return io::Value::Object{{"objects", std::uint64_t(*count)}};
}

Answer group(Script& script, Arguments& arguments)
{
    const auto ids = arguments.ids();
    const std::string name = arguments.text("name", "");
    if (const auto fault = arguments.finish()) return *fault;
    const io::ObjectId holder = editor::group(script.document(), ids, name);
    return selected(script, {&holder, 1});
}

Answer ungroup(Script& script, Arguments& arguments)
{
    const auto ids = arguments.ids();
    if (const auto fault = arguments.finish()) return *fault;
    const auto members = editor::ungroup(script.document(), ids);
    if (members.empty()) return io::Error{{}, "none of them is a group with members"};
    return selected(script, members);
}

Answer drop(Script& script, Arguments& arguments)
{
    const auto ids = arguments.ids();
    const bool turn = arguments.flag("align", false);
    if (const auto fault = arguments.finish()) return *fault;
    const auto dropped = dropToGround(script.document(), script.picker(), ids, turn ? DropTurn::Align : DropTurn::Keep);
    return idsAnswer(dropped);
}

// Without an axis: up along the ground's normal. With one: lined up along it.
Answer align(Script& script, Arguments& arguments)
{
    const auto ids = arguments.ids();
    const std::string axis = arguments.text("axis", "");
    const std::string to = arguments.text("to", "primary");
    constexpr std::array<std::string_view, 4> kTo{"min", "centre", "max", "primary"};
    const auto found = std::ranges::find(kTo, to);
    if (axis.size() > 1 || (!axis.empty() && (axis[0] < 'x' || axis[0] > 'z'))) arguments.fail("\"axis\" is x, y or z");
    if (found == kTo.end()) arguments.fail("\"to\" is min, centre, max or primary");
    if (const auto fault = arguments.finish()) return *fault;
    if (axis.empty()) return idsAnswer(dropToGround(script.document(), script.picker(), ids, DropTurn::Align));
    alignAlong(script.document(), ids, axis[0] - 'x', AlignTo(found - kTo.begin()));
    return idsAnswer(ids);
}

constexpr ScriptCommand kCommands[] = {
    {"place", place}, {"scatter", scatter}, {"duplicate", duplicate}, {"delete", remove},
    {"group", group}, {"ungroup", ungroup}, {"drop", drop},           {"align", align},
    {"delete_template", removeTemplate},
};

} // namespace

std::span<const ScriptCommand> placeCommands()
{
    return kCommands;
}

} // namespace editor
