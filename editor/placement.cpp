#include "editor/placement.h"

#include "editor/instance_edits.h"
#include "editor/random.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace editor {
namespace {

constexpr glm::dvec3 kUp{0, 1, 0};
constexpr double kStandsUpright = 0.5; // cosine; what leans more than 60 degrees lies, and rests on its side

// The shortest turn that takes one unit vector to another.
glm::dquat arc(const glm::dvec3& from, const glm::dvec3& to)
{
    const double cosine = glm::dot(from, to);
    if (cosine < -1 + 1e-12) { // opposite: any axis at a right angle will do
        const glm::dvec3 side = std::abs(from.x) < 0.9 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 0, 1};
        const glm::dvec3 axis = glm::normalize(glm::cross(from, side));
        return {0, axis.x, axis.y, axis.z};
    }
    const glm::dvec3 axis = glm::cross(from, to);
    return glm::normalize(glm::dquat{1 + cosine, axis.x, axis.y, axis.z});
}

glm::dvec3 upOf(const io::Transform& transform)
{
    return io::orientation(transform.rotation) * kUp;
}

// From an object's position to the point of it that rests on the ground.
glm::dvec3 footOf(const io::Transform& transform, const io::Box& modelBounds)
{
    if (modelBounds.empty()) return glm::dvec3{0};
    const glm::dvec3 up = upOf(transform);
    if (up.y > kStandsUpright) return up * double(modelBounds.min.y * transform.scale.y);
    io::Transform atOrigin = transform;
    atOrigin.position = glm::dvec3{0};
    return {0, io::transformed(modelBounds, io::worldFromModel(atOrigin)).min.y, 0};
}

} // namespace

io::Transform placedOn(const io::Template& what, const io::Box& modelBounds, const glm::dvec3& position,
                       const glm::dvec3& normal, const PlaceOptions& options)
{
    Random random{options.seed};
    const double yaw = random.in(what.yaw.x, what.yaw.y);
    const double scale = random.in(what.scale.x, what.scale.y);
    const double lean = glm::radians(random.in(0, what.tilt));
    const double leanTowards = random.in(0, glm::two_pi<double>());

    const glm::dvec3 up = what.alignToGround ? normal : kUp;
    const glm::dquat turn = glm::angleAxis(glm::radians(options.yaw ? double(*options.yaw) : yaw), kUp);
    const glm::dquat leaning = glm::angleAxis(lean, glm::dvec3{std::cos(leanTowards), 0, std::sin(leanTowards)});

    io::Transform result;
    result.scale = glm::vec3{options.scale ? *options.scale : float(scale)};
    // A typed yaw of 30 on level ground is written as 30, not as what comes back from a quaternion.
    const bool upright = lean == 0 && up == kUp;
    result.rotation = upright ? glm::vec3{0, float(options.yaw ? double(*options.yaw) : yaw), 0}
                              : io::eulerDegrees(arc(kUp, up) * leaning * turn);
    result.position = position - footOf(result, modelBounds) - up * double(what.sink);
    return result;
}

io::Transform placedOn(const Document& document, io::TemplateId id, const PickHit& hit, const PlaceOptions& options)
{
    const io::Template* what = document.scene().find(id);
    const io::Model* model = document.assets().model(id);
    return placedOn(what ? *what : io::Template{}, model ? model->bounds : io::Box{}, hit.position, hit.normal,
                    options);
}

io::ObjectId place(Document& document, io::TemplateId id, const io::Transform& transform)
{
    if (!document.scene().find(id)) return io::ObjectId::None;
    const io::ObjectId fresh = document.freshId();
    const std::string name = "Place " + std::string{document.scene().templateName(id)};
    addObjects(document, name, {{.id = fresh, .templateId = id, .transform = transform}});
    return fresh;
}

io::Transform alignedTo(const io::Transform& transform, const glm::dvec3& up)
{
    io::Transform result = transform;
    result.rotation = io::eulerDegrees(arc(upOf(transform), up) * io::orientation(transform.rotation));
    return result;
}

io::WorldBox boundsOf(const Document& document, std::span<const io::ObjectId> ids)
{
    io::WorldBox all;
    for (const io::ObjectId id : document.hierarchy().withMembers(ids)) {
        const io::Object* object = document.scene().find(id);
        const auto instance = document.scene().findInstance(id);
        if (instance) all.add(io::worldBounds(document.assets(), objectOf(document.scene(), *instance)));
        if (!object) continue;
        const io::WorldBox own = io::worldBounds(document.assets(), *object);
        if (!own.empty())
            all.add(own);
        else if (object->templateId != io::TemplateId::None)
            all.add(object->transform.position);
    }
    return all;
}

namespace {

// The surface below a thing that fills `bounds`, or above it when it is buried.
PickHit groundBelow(const Picker& picker, const glm::dvec3& foot, const io::WorldBox& bounds,
                    std::span<const io::ObjectId> skip)
{
    constexpr double kSky = 1e5; // m, above any ground
    const PickHit ground = picker.pick({.origin = {foot.x, kSky, foot.z}, .direction = -kUp}, {.objects = false});
    if (ground && ground.position.y > bounds.max.y) return ground;
    return picker.pick({.origin = {foot.x, bounds.max.y + 1e-3, foot.z}, .direction = -kUp}, {.skip = skip});
}

} // namespace

std::vector<io::ObjectId> dropToGround(Document& document, const Picker& picker, std::span<const io::ObjectId> ids,
                                       DropTurn turn)
{
    const Hierarchy& hierarchy = document.hierarchy();
    std::vector<io::ObjectId> skip = hierarchy.withMembers(ids);
    std::ranges::sort(skip);
    std::vector<io::ObjectId> dropped;
    std::vector<SwapObjects::Slot> slots;
    for (const io::ObjectId id : hierarchy.outermost(ids)) {
        const io::Object* object = document.scene().find(id);
        const io::WorldBox bounds = boundsOf(document, {&id, 1});
        if (!object || bounds.empty()) continue;
        const io::Model* model = document.assets().model(object->templateId);
        const bool alone = object->templateId != io::TemplateId::None;

        io::Transform transform = object->transform;
        glm::dvec3 foot = alone ? transform.position + footOf(transform, model ? model->bounds : io::Box{})
                                : glm::dvec3{bounds.centre().x, bounds.min.y, bounds.centre().z};
        const PickHit ground = groundBelow(picker, foot, bounds, skip);
        if (!ground) continue;
        const io::Template* what = document.scene().find(object->templateId);
        glm::dvec3 to = ground.position;
        if (alone && turn == DropTurn::Align) {
            transform = alignedTo(transform, ground.normal);
            foot = transform.position + footOf(transform, model ? model->bounds : io::Box{});
        }
        if (what) to -= (what->alignToGround && turn == DropTurn::Align ? ground.normal : kUp) * double(what->sink);
        // Straight down: only a turned thing also shifts, so that its foot stays where it stood.
        const glm::dvec3 delta = turn == DropTurn::Align ? to - foot : glm::dvec3{0, to.y - foot.y, 0};
        dropped.push_back(id);
        for (const io::ObjectId member : hierarchy.withMembers({&id, 1})) {
            io::Object moved = document.scene().at(member);
            if (member == id) moved.transform = transform;
            moved.transform.position += delta;
            slots.emplace_back(member, std::move(moved));
        }
    }
    document.run(std::make_unique<SwapObjects>(turn == DropTurn::Align ? "Align to ground" : "Drop to ground",
                                               std::move(slots)));
    return dropped;
}

void alignAlong(Document& document, std::span<const io::ObjectId> ids, int axis, AlignTo to)
{
    if (ids.empty()) return;
    const io::WorldBox all = boundsOf(document, ids);
    const io::Object* primary = document.scene().find(ids.back());
    if (!primary || all.empty()) return;
    std::vector<SwapObjects::Slot> slots;
    for (const io::ObjectId id : document.hierarchy().outermost(ids)) {
        const io::Object* object = document.scene().find(id);
        const io::WorldBox own = boundsOf(document, {&id, 1});
        if (!object || own.empty()) continue;
        const double delta = to == AlignTo::Min   ? all.min[axis] - own.min[axis]
                             : to == AlignTo::Max ? all.max[axis] - own.max[axis]
                             : to == AlignTo::Centre
                                 ? all.centre()[axis] - own.centre()[axis]
                                 : primary->transform.position[axis] - object->transform.position[axis];
        for (const io::ObjectId member : document.hierarchy().withMembers({&id, 1})) {
            io::Object moved = document.scene().at(member);
            moved.transform.position[axis] += delta;
            slots.emplace_back(member, std::move(moved));
        }
    }
    document.run(std::make_unique<SwapObjects>("Align", std::move(slots)));
}

} // namespace editor
