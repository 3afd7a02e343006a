// Stroke: a brush drawn over the ground, from press to release, as one undo step. Dabs lie evenly along the way, however many
// frames it took, so the same way leaves the same ground; where the pointer rests, they come at a steady rate.
#pragma once

#include "editor/brush.h"
#include "editor/document.h"
#include "editor/plant_pattern.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace editor {

struct StrokeKeys {
    bool inverted = false; // raises what lowers, and the other way round
    bool smooths = false;  // smooths, whatever the tool
    bool objectsFollow = true; // objects keep their height above the ground
};

BrushTool toolWith(BrushTool tool, const StrokeKeys& keys); // what a tool becomes

class Stroke {
public:
    // Begins a gesture of that name.
    Stroke(Document& document, Brush brush, StrokeKeys keys, std::string name);
    ~Stroke();
    Stroke(const Stroke&) = delete;
    Stroke& operator=(const Stroke&) = delete;

    // The pointer went straight to this point of the ground.
    void to(const glm::dvec3& point);
    void rest(double seconds); // it stayed where it is
    void end();                // makes a ramp, and plants follow their rules; nothing can come after
    void cancel();             // the ground is as it was

    // Makes a patch part of this step; the objects on it follow.
    void change(const HeightPatch& patch);

    const Brush& brush() const { return m_brush; }
    std::optional<glm::dvec3> start() const { return m_start; }

    // What a strength of the brush means: metres at the middle of one dab, or a share of the way.
    static float amountOf(const Brush& brush);

private:
    void dab(const glm::dvec2& at);
    void paint(const Dab& dab);
    void lift(const HeightPatch& patch, const io::HeightMap& before);
    void findObjects();
    void touch(const PlaneRect& part);

    Document& m_document;
    Brush m_brush;
    StrokeKeys m_keys;
    std::string m_name;
    std::optional<Gesture> m_gesture;
    std::optional<glm::dvec3> m_start, m_last;
    double m_toNext = 0;  // m along the way
    double m_rested = 0;  // s since the last dab of a resting pointer
    std::uint32_t m_dabs = 0;
    double m_level = 0;
    std::unordered_map<std::int64_t, std::vector<io::ObjectId>> m_objects; // by cell of the ground
    bool m_objectsFound = false;
    std::optional<PlaneRect> m_touched; // where rules are looked at again when it ends
};

} // namespace editor
