// ScatterStroke: the brush that plants, drawn from press to release as one undo step, over a scatter layer's instances or over
// objects of its species.
#pragma once

#include "editor/scatter_steps.h"
#include "io/scene/fields.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace editor {

enum class ScatterMode { Plant, Erase, Thin, Reseed, Single, Lasso, Replace };
enum class ScatterTarget { Instances, Objects };
constexpr auto enumNames(ScatterMode) { return std::array<std::string_view, 7>{"plant", "erase", "thin", "reseed", "single", "lasso", "replace"}; }
constexpr auto enumNames(ScatterTarget) { return std::array<std::string_view, 2>{"instances", "objects"}; }

struct ScatterBrush {
    ScatterMode mode = ScatterMode::Plant;
    ScatterTarget target = ScatterTarget::Instances;
    float radius = 20;  // m
    float share = 0.5f; // that stays when thinned
    int species = -1;   // of the layer, that erasing and thinning mean and that is replaced; -1: all
    int instead = 0;    // that comes in its place
    bool operator==(const ScatterBrush&) const = default;
};

// Those that this mode uses; species are chosen by name.
void fields(auto& v, io::Of<ScatterBrush> auto& b)
{
    using enum ScatterMode;
    v("target", b.target, io::Hint{});
    if (b.mode != Single && b.mode != Lasso) v("radius", b.radius, io::Hint{.min = 0.5, .max = 500, .unit = "m", .style = io::Style::Logarithmic});
    if (b.mode == Thin) v("share", b.share, io::Hint{.min = 0, .max = 1});
}

ScatterMode modeWith(ScatterMode mode, bool erases, bool thins); // what a mode becomes by Ctrl and Shift

class ScatterStroke {
public:
    // Begins a gesture of that name. The picker is asked where plants grow on meshes, and is kept up to date.
    ScatterStroke(Document& document, const Picker& picker, ScatterBrush brush, io::ScatterId layer, std::string name);
    ScatterStroke(const ScatterStroke&) = delete;
    ScatterStroke& operator=(const ScatterStroke&) = delete;

    void to(const glm::dvec3& point); // the pointer went straight there
    void end();                       // fills a lasso; nothing can follow
    void cancel();                    // all is as it was

    const ScatterBrush& brush() const { return m_brush; }
    const std::vector<glm::dvec3>& way() const { return m_way; }

private:
    void dab(const glm::dvec2& at);
    void work(const PlantRegion& region);
    void workOnObjects(const PlantRegion& region);
    void plantOne(const glm::dvec3& point);
    LayerTiles tiles() const;
    std::vector<io::TemplateId> meant() const;

    Document& m_document;
    ScatterBrush m_brush;
    io::ScatterLayer m_layer;
    std::string m_name;
    Planting m_planting;
    std::optional<Gesture> m_gesture;
    std::vector<glm::dvec3> m_way;
    double m_toNext = 0; // m along the way
};

} // namespace editor
