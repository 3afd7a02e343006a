// Brushes of the ground: what one dab makes of the heights under it. All of it is plain arithmetic on a copy of those heights,
// so a dab is the same wherever and whenever it is made.
#pragma once

#include "io/scene/cover_map.h"
#include "io/scene/fields.h"
#include "io/scene/grass.h"
#include "io/scene/height_map.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace editor {

enum class BrushTool { Raise, Lower, Smooth, Flatten, Ramp, Terrace, Noise, Erode, Slump, Stamp, Paint, Erase, Replace, Hole, Grow, Mow, GrassHeight };
enum class BrushCurve { Smooth, Linear, Dome, Point }; // how a dab fades between its full part and its edge
enum class BrushNoise { Simplex, Fbm, Ridged };

constexpr auto enumNames(BrushTool)
{
    return std::array<std::string_view, 17>{"raise", "lower", "smooth", "flatten", "ramp", "terrace", "noise", "erode", "slump", "stamp", "paint", "erase", "replace", "hole", "grow", "mow", "grass_height"};
}
constexpr auto enumNames(BrushCurve) { return std::array<std::string_view, 4>{"smooth", "linear", "dome", "point"}; }
constexpr auto enumNames(BrushNoise) { return std::array<std::string_view, 3>{"simplex", "fbm", "ridged"}; }

struct Brush {
    BrushTool tool = BrushTool::Raise;
    float radius = 20;      // m
    float strength = 0.5f;  // 0..1
    float falloff = 1;      // share of the radius over which it fades, 0 a hard edge
    BrushCurve curve = BrushCurve::Smooth;
    glm::vec2 slope{0, 90};          // degrees; steeper or flatter ground stays
    glm::vec2 altitude{-1e5f, 1e5f}; // m; higher or lower ground stays
    bool levelGiven = false;         // flatten aims at `level`, not at the ground where the stroke begins
    float level = 0;                 // m
    float step = 4;                  // m, of terraces
    float scale = 30;                // m, of noise's largest swells
    BrushNoise noise = BrushNoise::Fbm;
    int seed = 1;
    float talus = 33;                // degrees, at which loose ground comes to rest
    float rotation = 0;              // degrees, of a stamp
    int layer = 0;                   // that is painted, of the terrain's
    int replaced = 0;                // in whose place
    int kind = 0;                    // of grass, that is grown or mown
    bool everyKind = false;          // mows all of them
    float density = 1;               // share of the kind's own that is grown
    float height = 1;                // factor of the kinds' own
    std::string stampFile;           // of the project, as "textures/crater.png"
    std::shared_ptr<const io::HeightGrid> stamp; // 0..1, its longer sides as long as the brush is wide; null: none
    bool operator==(const Brush&) const = default;
};

constexpr bool growsGrass(BrushTool tool) { return tool >= BrushTool::Grow; } // its map
constexpr bool paints(BrushTool tool) { return tool >= BrushTool::Paint && !growsGrass(tool); } // the cover
constexpr bool shapes(BrushTool tool) { return tool < BrushTool::Paint; } // heights

// Those that this tool uses; layers are chosen by name.
void fields(auto& v, io::Of<Brush> auto& b)
{
    using enum BrushTool;
    v("radius", b.radius, io::Hint{.min = 0.5, .max = 500, .unit = "m", .style = io::Style::Logarithmic});
    if (b.tool != Ramp && b.tool != Replace && b.tool != Hole) v("strength", b.strength, io::Hint{.min = 0, .max = 1});
    if (b.tool != Hole) v("falloff", b.falloff, io::Hint{.min = 0, .max = 1});
    if (b.tool != Hole) v("curve", b.curve, io::Hint{});
    if (b.tool == Flatten) v("level_given", b.levelGiven, io::Hint{});
    if (b.tool == Flatten && b.levelGiven) v("level", b.level, io::Hint{.min = -1e5, .max = 1e5, .unit = "m"});
    if (b.tool == Terrace) v("step", b.step, io::Hint{.min = 0.1, .max = 200, .unit = "m", .style = io::Style::Logarithmic});
    if (b.tool == Noise) v("noise", b.noise, io::Hint{});
    if (b.tool == Noise) v("scale", b.scale, io::Hint{.min = 1, .max = 2000, .unit = "m", .style = io::Style::Logarithmic});
    if (b.tool == Noise || b.tool == Erode) v("seed", b.seed, io::Hint{.min = 0, .max = 9999});
    if (b.tool == Slump) v("talus", b.talus, io::Hint{.min = 5, .max = 80, .unit = "deg"});
    if (b.tool == Stamp) v("stamp", b.stampFile, io::Hint{});
    if (b.tool == Stamp) v("rotation", b.rotation, io::Hint{.min = -180, .max = 180, .unit = "deg"});
    if (b.tool == Grow) v("density", b.density, io::Hint{.min = 0.01, .max = 1});
    if (b.tool == Grow || b.tool == GrassHeight) v("height", b.height, io::Hint{.min = 0.05, .max = 1.99});
    if (b.tool == Mow) v("every_kind", b.everyKind, io::Hint{});
    v("slope", b.slope, io::Hint{.min = 0, .max = 90, .unit = "deg"});
    v("altitude", b.altitude, io::Hint{.min = -1e5, .max = 1e5, .unit = "m"});
}

struct Dab {
    glm::dvec2 centre{0};  // world x and z
    float amount = 1;      // m at the centre, or the share of the way to what the tool aims at: smooth, flatten, terrace, slump; hole: below 0 closes
    double level = 0;      // m, that flatten aims at
    std::uint32_t number = 0; // of a stroke: chance differs from dab to dab
};

// Parts of a map that a dab changes, and their new heights.
struct HeightPatch {
    glm::ivec2 at{0}; // texel of the first
    io::HeightGrid heights;
    io::TexelRect rect() const { return {at, at + heights.size}; }
};

struct CoverPatch { // of the cover, or of the map of grass
    glm::ivec2 at{0}, size{0};
    std::vector<std::uint32_t> texels;
    io::TexelRect rect() const { return {at, at + size}; }
};

// 1 in the middle, 0 at the edge and beyond; `away` in radii.
float fading(const Brush& brush, float away);

// Nothing where the brush lies beside the ground. It reaches a texel far at least. The tool shapes, and is anything but Ramp.
std::optional<HeightPatch> dabOn(const io::HeightMap& map, const Brush& brush, const Dab& dab);

// The tool paints. `everywhere`: not only under the brush, but where its slopes and heights let it.
std::optional<CoverPatch> paintOn(const io::HeightMap& map, const io::CoverMap& cover, const Brush& brush, const Dab& dab, bool everywhere = false);
io::Cover painted(io::Cover cover, BrushTool tool, int layer, int replaced, float share); // one texel

// The tool grows grass.
std::optional<CoverPatch> growOn(const io::HeightMap& map, const io::GrassMap& grass, const Brush& brush, const Dab& dab, bool everywhere = false);
io::GrassCover grown(io::GrassCover cover, const Brush& brush, float share); // one texel

// An even way from one point of the ground to another, as wide as the brush.
std::optional<HeightPatch> rampOn(const io::HeightMap& map, const Brush& brush, const glm::dvec3& from, const glm::dvec3& to, float amount);

// Either of the two, as the tool says, on ground that begins at `from`: world x and z. Flatten aims at the ground there.
std::optional<HeightPatch> patchOf(const io::HeightMap& map, const Brush& brush, const glm::dvec2& from, const glm::dvec2& to, float amount);

} // namespace editor
