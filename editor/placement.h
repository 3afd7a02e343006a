// Placement: where a thing stands when it is put on a surface, dropped onto it or lined up.
#pragma once

#include "editor/document.h"
#include "editor/picker.h"

#include <cstdint>
#include <optional>
#include <span>

namespace editor {

struct PlaceOptions {
    std::uint64_t seed = 1;
    std::optional<float> yaw;   // degrees; drawn from the template's range when not given
    std::optional<float> scale; // factor; likewise
};

// The bottom of the model's bounds stands on the hit, less the template's sink; up is the normal when it aligns.
io::Transform placedOn(const io::Template& what, const io::Box& modelBounds, const glm::dvec3& position,
                       const glm::dvec3& normal, const PlaceOptions& options = {});

// The same with the template's own model.
io::Transform placedOn(const Document& document, io::TemplateId id, const PickHit& hit,
                       const PlaceOptions& options = {});

// Places one copy as one step; None when there is no such template.
io::ObjectId place(Document& document, io::TemplateId id, const io::Transform& transform);

// Turns `transform` so that its up axis is `up`, keeping its heading.
io::Transform alignedTo(const io::Transform& transform, const glm::dvec3& up);

enum class DropTurn { Keep, Align }; // Align: the up axis becomes the normal of the surface below

// Each object, or group as one piece, down onto the ground or what is below it; what is buried comes up. The picker
// must be up to date. Answers the ids that found ground.
std::vector<io::ObjectId> dropToGround(Document& document, const Picker& picker, std::span<const io::ObjectId> ids,
                                       DropTurn turn = DropTurn::Keep);

enum class AlignTo { Min, Centre, Max, Primary }; // of the selection's bounds, or the last id's own place
void alignAlong(Document& document, std::span<const io::ObjectId> ids, int axis, AlignTo to);

// The bounds of the objects and of the members of groups.
io::WorldBox boundsOf(const Document& document, std::span<const io::ObjectId> ids);

} // namespace editor
