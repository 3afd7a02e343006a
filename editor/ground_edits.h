// The ground as a whole: another one in its place, or the same in other texels, as one step of a document.
#pragma once

#include "editor/document.h"
#include "io/base/result.h"
#include "io/scene/fields.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace editor {

enum class GroundEdge { Extend, Wrap };
constexpr auto enumNames(GroundEdge) { return std::array<std::string_view, 2>{"extend", "wrap"}; }

// The ground that there will be; null cover: nothing is painted on it.
struct NewGround {
    io::HeightGrid heights; // and where they lie
    std::shared_ptr<const io::CoverMap> cover;
    glm::dvec2 movedBy{0}; // m, x and z, that what lies on it goes along: the map of grass
    GroundEdge edge = GroundEdge::Extend; // what of that comes in
    std::optional<glm::dvec2> range; // m, lowest and highest that its file is to hold; none: what the terrain says
};

// Heights, cover and the terrain's fields together. Objects and plants keep their place and, if they follow, their height above the ground
// wherever there was ground and is; layers of rules are evaluated anew. Where a project has other scenes, the new ground gets files of its own, as those may show
// the old ones.
void replaceGround(Document& document, const std::string& name, NewGround ground, bool objectsFollow);

enum class Reshape { Resample, Crop, Offset };
constexpr auto enumNames(Reshape) { return std::array<std::string_view, 3>{"resample", "crop", "offset"}; }

struct Reshaping {
    Reshape kind = Reshape::Resample;
    int width = 0;             // texels along x, over the same metres; 0: as `metresPerTexel` says
    double metresPerTexel = 0; // 0: as `width` says
    bool texels = false;       // the next three count texels from the map's corner, not metres of the world
    glm::dvec2 from{0}, to{0}; // corners of the ground that crop makes, the last texel included; it may be wider than before
    glm::dvec2 by{0};          // x and z that offset moves the heights along; to the nearest texel
    double raise = 0;          // m, up
    GroundEdge edge = GroundEdge::Extend; // what comes in where there were no heights before
    bool operator==(const Reshaping&) const = default;
};

// Those that this kind uses.
void fields(auto& v, io::Of<Reshaping> auto& r)
{
    using enum Reshape;
    if (r.kind == Resample) v("width", r.width, io::Hint{.min = 2, .max = 8193, .unit = "texels"});
    if (r.kind == Resample) v("metres_per_texel", r.metresPerTexel, io::Hint{.min = 0.001, .max = 10'000, .unit = "m", .style = io::Style::Logarithmic});
    if (r.kind != Resample) v("texels", r.texels, io::Hint{});
    if (r.kind == Crop) v("from", r.from, io::Hint{.min = -1e7, .max = 1e7});
    if (r.kind == Crop) v("to", r.to, io::Hint{.min = -1e7, .max = 1e7});
    if (r.kind == Offset) v("by", r.by, io::Hint{.min = -1e7, .max = 1e7});
    if (r.kind == Offset) v("raise", r.raise, io::Hint{.min = -1e5, .max = 1e5, .unit = "m"});
    if (r.kind != Resample) v("edge", r.edge, io::Hint{});
}

// What a reshaping makes of a scene's ground: heights by cubics where texels get smaller and by means where they get larger, cover
// from the nearest texel. An error, in words that name the field, where nothing can be made: a part without two texels to a side,
// more than 8193, or a scene without ground.
io::Result<NewGround> reshaped(const io::Scene& scene, const Reshaping& reshaping);

} // namespace editor
