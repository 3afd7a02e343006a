#include "editor/script_commands.h"

#include "editor/placement.h"

#include <cmath>
#include <fmt/format.h>

namespace editor {
namespace {

// What move, rotate and scale have in common: how much, of what, seen from where.
struct Task {
    std::vector<io::ObjectId> outermost;
    std::optional<glm::dvec3> by, to;
    bool local = false;
};

Task taskOf(Script& script, Arguments& arguments, bool factors)
{
    Task task{.outermost = script.document().hierarchy().outermost(arguments.ids()),
              .by = factors ? arguments.factors("by") : arguments.triple("by"),
              .to = factors ? arguments.factors("to") : arguments.triple("to")};
    if (task.by.has_value() == task.to.has_value()) arguments.fail("needs either \"by\" or \"to\"");
    const std::string space = arguments.text("space", "world");
    if (space != "world" && space != "local") arguments.fail("\"space\" is world or local");
    task.local = space == "local";
    return task;
}

glm::dvec3 middleOf(const io::Scene& scene, std::span<const io::ObjectId> ids)
{
    glm::dvec3 sum{0};
    for (const io::ObjectId id : ids)
        sum += scene.at(id).transform.position;
    return sum / double(ids.size());
}

// Runs change(transform, the outermost object's transform before, whether it is that) on objects and members, or on
// nothing if a result is out of range.
Answer transformAll(Script& script, const Task& task, const std::string& name, auto&& change)
{
    Document& document = script.document();
    std::vector<SwapObjects::Slot> slots;
    for (const io::ObjectId id : task.outermost) {
        const io::Transform before = document.scene().at(id).transform;
        for (const io::ObjectId member : document.hierarchy().withMembers({&id, 1})) {
            io::Object object = document.scene().at(member);
            io::Transform& t = object.transform;
            change(t, before, member == id);
            for (int axis = 0; axis < 3; ++axis) {
                const double size = std::abs(double(t.scale[axis]));
                if (!(std::abs(t.position[axis]) <= 1e7)) return io::Error{{}, "would leave the world (1e7 m)"};
                if (!(size >= 1e-6 && size <= 1e6)) return io::Error{{}, "would scale beyond 1e-6 to 1e6"};
            }
            slots.emplace_back(member, std::move(object));
        }
    }
    document.run(std::make_unique<SwapObjects>(name, std::move(slots)));
    return io::Value::Object{{"ids", toValue(task.outermost)}};
}

std::string named(const char* verb, const Task& task)
{
    return std::string{verb} + " " + std::to_string(task.outermost.size()) +
           (task.outermost.size() == 1 ? " object" : " objects");
}

Answer move(Script& script, Arguments& arguments)
{
    const Task task = taskOf(script, arguments, false);
    if (const auto fault = arguments.finish()) return *fault;
    const glm::dvec3 by = task.to ? *task.to - middleOf(script.document().scene(), task.outermost) : *task.by;
    return transformAll(script, task, named("Move", task), [&](io::Transform& t, const io::Transform& top, bool isTop) {
        if (task.to && isTop && task.outermost.size() == 1)
            t.position = *task.to; // exactly, not by way of a sum
        else
            t.position += task.local && task.by ? io::orientation(top.rotation) * by : by;
    });
}

Answer rotate(Script& script, Arguments& arguments)
{
    const Task task = taskOf(script, arguments, false);
    if (const auto fault = arguments.finish()) return *fault;
    const glm::dvec3 middle = middleOf(script.document().scene(), task.outermost);
    const glm::dquat given = io::orientation(glm::vec3{task.by ? *task.by : *task.to});
    return transformAll(
        script, task, named("Rotate", task), [&](io::Transform& t, const io::Transform& top, bool isTop) {
            const glm::dquat own = io::orientation(top.rotation);
            const glm::dquat turn = task.to      ? given * glm::inverse(own)
                                    : task.local ? own * given * glm::inverse(own)
                                                 : given;
            const glm::dvec3 pivot = task.by && !task.local && task.outermost.size() > 1 ? middle : top.position;
            if (!(isTop && pivot == top.position)) t.position = pivot + turn * (t.position - pivot);
            t.rotation = isTop && task.to ? glm::vec3{*task.to} : io::eulerDegrees(turn * io::orientation(t.rotation));
        });
}

Answer scale(Script& script, Arguments& arguments)
{
    const Task task = taskOf(script, arguments, true);
    if (const auto fault = arguments.finish()) return *fault;
    const glm::dvec3 middle = middleOf(script.document().scene(), task.outermost);
    return transformAll(script, task, named("Scale", task),
                        [&](io::Transform& t, const io::Transform& top, bool isTop) {
                            const glm::dvec3 factor = task.by ? *task.by : *task.to / glm::dvec3{top.scale};
                            const glm::dvec3 pivot = task.by && !task.local ? middle : top.position;
                            t.position = pivot + (t.position - pivot) * factor;
                            t.scale = isTop && task.to ? glm::vec3{*task.to} : glm::vec3{glm::dvec3{t.scale} * factor};
                        });
}

Answer rename(Script& script, Arguments& arguments)
{
    const io::ObjectId id = arguments.object("id");
    const std::string name = arguments.text("name");
    if (const auto fault = arguments.finish()) return *fault;
    edit(script.document(), "Rename to " + name, {&id, 1}, [&](io::Object& object) { object.name = name; });
    return io::Value::Object{{"id", io::number(id)}};
}

Answer assign(Script& script, Arguments& arguments)
{
    const std::vector<io::ObjectId> ids = arguments.has("id") ? std::vector{arguments.object("id")} : arguments.ids();
    const io::TemplateId what = arguments.templateNamed("template");
    for (const io::ObjectId id : ids)
        if (const io::Object* object = script.document().scene().find(id);
            object && object->templateId == io::TemplateId::None)
            arguments.fail(fmt::format("object {} is a group", io::number(id)));
    if (const auto fault = arguments.finish()) return *fault;
    edit(script.document(), "Assign " + std::string{script.document().scene().templateName(what)}, ids,
         [&](io::Object& object) { object.templateId = what; });
    return io::Value::Object{{"ids", toValue(ids)}};
}

constexpr ScriptCommand kCommands[] = {
    {"move", move}, {"rotate", rotate}, {"scale", scale}, {"rename", rename}, {"assign", assign},
};

} // namespace

std::span<const ScriptCommand> transformCommands()
{
    return kCommands;
}

} // namespace editor
