#include "editor/arrange.h"

#include "editor/placement.h"

#include <algorithm>
#include <unordered_map>

namespace editor {
namespace {

// "Delete Oak 17", "Delete 3 objects": what an undo step did and to how many.
std::string counted(const char* verb, std::size_t count)
{
    return std::string{verb} + " " + std::to_string(count) + (count == 1 ? " object" : " objects");
}

bool holds(const std::vector<io::ObjectId>& ids, io::ObjectId id)
{
    return std::ranges::find(ids, id) != ids.end();
}

} // namespace

std::vector<io::ObjectId> duplicate(Document& document, std::span<const io::ObjectId> ids, const glm::dvec3& offset)
{
    const std::vector<io::ObjectId> sources = document.hierarchy().outermost(ids);
    std::unordered_map<std::uint32_t, io::ObjectId> copyOf;
    std::vector<io::Object> copies;
    for (const io::ObjectId id : document.hierarchy().withMembers(sources)) {
        const io::Object* object = document.scene().find(id);
        if (!object) continue;
        io::Object& copy = copies.emplace_back(*object);
        copy.id = copyOf[io::number(id)] = document.freshId();
        copy.transform.position += offset;
    }
    for (io::Object& copy : copies)
        if (const auto group = copyOf.find(io::number(copy.parent)); group != copyOf.end()) copy.parent = group->second;
    std::vector<io::ObjectId> result;
    for (const io::ObjectId id : sources)
        if (const auto copy = copyOf.find(io::number(id)); copy != copyOf.end()) result.push_back(copy->second);
    addObjects(document, counted("Duplicate", result.size()), std::move(copies));
    return result;
}

io::ObjectId group(Document& document, std::span<const io::ObjectId> ids, std::string name)
{
    std::vector<io::ObjectId> members = document.hierarchy().outermost(ids);
    std::erase_if(members, [&](io::ObjectId id) { return !document.scene().find(id); });
    if (members.empty()) return io::ObjectId::None;
    const io::ObjectId parent = document.scene().at(members.front()).parent;
    const bool common =
        std::ranges::all_of(members, [&](io::ObjectId id) { return document.scene().at(id).parent == parent; });

    const io::WorldBox bounds = boundsOf(document, members);
    io::Object holder{
        .id = document.freshId(), .parent = common ? parent : io::ObjectId::None, .name = std::move(name)};
    if (!bounds.empty()) holder.transform.position = {bounds.centre().x, bounds.min.y, bounds.centre().z};
    std::vector<SwapObjects::Slot> slots;
    slots.emplace_back(holder.id, holder);
    for (const io::ObjectId id : members) {
        io::Object member = document.scene().at(id);
        member.parent = holder.id;
        slots.emplace_back(id, std::move(member));
    }
    document.run(std::make_unique<SwapObjects>(counted("Group", members.size()), std::move(slots)));
    return holder.id;
}

std::vector<io::ObjectId> ungroup(Document& document, std::span<const io::ObjectId> ids)
{
    std::vector<SwapObjects::Slot> slots;
    std::vector<io::ObjectId> members;
    for (const io::ObjectId id : document.hierarchy().outermost(ids)) {
        const io::Object* holder = document.scene().find(id);
        if (!holder || holder->templateId != io::TemplateId::None) continue;
        for (const io::ObjectId child : document.hierarchy().children(id)) {
            io::Object member = document.scene().at(child);
            member.parent = holder->parent;
            slots.emplace_back(child, std::move(member));
            members.push_back(child);
        }
        slots.emplace_back(id, std::nullopt);
    }
    if (!slots.empty()) document.run(std::make_unique<SwapObjects>("Ungroup", std::move(slots)));
    return members;
}

bool reparent(Document& document, std::span<const io::ObjectId> ids, io::ObjectId group)
{
    if (group != io::ObjectId::None) {
        const io::Object* holder = document.scene().find(group);
        if (!holder || holder->templateId != io::TemplateId::None) return false;
        if (holds(document.hierarchy().withMembers(ids), group)) return false;
    }
    const std::vector<io::ObjectId> moved = document.hierarchy().outermost(ids);
    edit(document, counted("Move into group", moved.size()), moved, [&](io::Object& object) { object.parent = group; });
    return true;
}

void moveBy(Document& document, std::string name, std::span<const io::ObjectId> ids, const glm::dvec3& delta)
{
    edit(document, std::move(name), document.hierarchy().withMembers(ids),
         [&](io::Object& object) { object.transform.position += delta; });
}

} // namespace editor
