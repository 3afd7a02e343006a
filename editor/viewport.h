// Viewport: the panel in the middle, through which a person looks at the world, flies, picks, drags the gizmo and
// places things.
#pragma once

#include "editor/fly_camera.h"
#include "editor/frame_history.h"
#include "editor/gizmo.h"
#include "editor/path_tool.h"
#include "editor/panel.h"
#include "editor/picker.h"
#include "editor/resolution.h"
#include "editor/scatter_brush.h"
#include "editor/selection.h"
#include "editor/sound_shape.h"
#include "editor/stroke.h"
#include "editor/terrain_ray.h"
#include "renderer/renderer.h"

#include <imgui.h>
#include <optional>
#include <string>
#include <vector>

namespace editor {

class Document;

class Viewport final : public Panel {
public:
    Viewport() : Panel{"viewport", Icon::Frame} {}
    void draw(Editor& editor) override;
    bool padded() const override { return false; }

    FlyCamera camera;
    Gizmo gizmo;
    bool gizmoShown = true; // false: the plain selecting tool
    bool snapping = false;  // Ctrl turns it round while dragging
    bool sculpting = false; // the left button draws with the brush
    Brush brush;
    bool objectsFollow = true; // keep their height above ground that is shaped
    bool scattering = false;   // the left button plants
    ScatterBrush scatterBrush;
    io::ScatterId scatterLayer = io::ScatterId::None; // that it plants in
    PathTool path;
    bool showOverlays = true;
    bool showStatistics = false; // over the picture
    bool freezeCulling = false;  // flying on, one sees what was culled then
    FrameHistory frames;

    View view() const { return {camera.camera(), m_size}; }
    void lookFrom(const Document& document); // the first camera that the scene names, or all of it framed
    void frameSelection(Editor& editor);     // of everything when nothing is selected

    void beginPlacing(io::TemplateId id);
    void stopPlacing();
    io::TemplateId placing() const { return m_placing; }
    void placeAtCamera(Editor& editor, io::TemplateId id);
    void sculptWith(Editor& editor, BrushTool tool);
    void scatterWith(Editor& editor, ScatterMode mode);
    const io::ScatterLayer* scatterTarget(const Document& document) const; // null: none is chosen
    void resizeBrush(float factor);
    void stayAbove(const Document& document); // the ground, where it rose over the camera
    void readStamp(const Document& document); // that the brush names, of this project; what cannot be read is said in the console
    std::optional<glm::dvec3> pointUnderPointer(Editor& editor) const; // of the last frame; where a paste goes

    bool pointerHidden() const { return m_drag == Drag::Look; }
    bool flying() const { return m_drag == Drag::Look; }
    bool busy() const; // something moves, or is being dragged
    void reset();      // another document
    double pictureScale() const { return m_resolution.scale(); } // below 1: coarser, to be quick enough

private:
    enum class Drag { None, Look, Orbit, Pan, Click, Box, Gizmo, Sound, Place, Stroke, Scatter, PathKey };
    struct ShownSound {
        io::TemplateId id = io::TemplateId::None;
        SoundFrame frame;
        io::SoundSource sound;
    };

    void drawPicture(Editor& editor);
    void chooseResolution(Editor& editor);
    void input(Editor& editor, double seconds);
    void press(Editor& editor);
    void pressLeft(Editor& editor);
    void hold(Editor& editor, double seconds);
    void release(Editor& editor);
    void wheel(Editor& editor);
    void focusUnderPointer(Editor& editor);
    void updateHover(Editor& editor);

    void click(Editor& editor);
    void selectBox(Editor& editor);
    void promoteSelection(Editor& editor);
    bool beginGizmo(Editor& editor);
    void dragGizmo(Editor& editor);
    void endGizmo(Editor& editor, bool keep);
    std::optional<ShownSound> soundShown(Editor& editor) const;
    void hoverSound(Editor& editor);
    bool beginSound(Editor& editor);
    void dragSound(Editor& editor);
    void endSound(Editor& editor, bool keep);
    void drawSound(Editor& editor) const;
    void openContextMenu(Editor& editor);
    void contextMenu(Editor& editor);

    void beginStroke(Editor& editor);
    void holdStroke(Editor& editor, double seconds);
    void endStroke();
    void updateBrush(Editor& editor);
    void addBrushLines(const Editor& editor, std::vector<renderer::Line>& lines) const;

    void beginScatter(Editor& editor);
    void holdScatter(Editor& editor);
    void endScatter(Editor& editor);
    void updateScatter(Editor& editor);
    void addScatterLines(const Editor& editor, std::vector<renderer::Line>& lines) const;

    void updateGhost(Editor& editor);
    void placeGhost(Editor& editor);
    void takeDrop(Editor& editor);

    renderer::FrameInput frameInput(Editor& editor);
    void refreshSelectionShown(Editor& editor);
    void overlays(Editor& editor);
    void drawGizmo() const;
    void drawBox() const;
    void drawPathKeys(const Editor& editor) const;
    void drawCompass() const;
    void drawHints(Editor& editor) const;
    void drawFaults(Editor& editor) const;
    void drawStatistics(Editor& editor) const;

    std::optional<glm::dvec3> strokeGroundAt(const glm::dvec2& pixel) const;
    glm::dvec2 pointer() const; // pixels from the viewport's top left
    bool clickDistance() const; // the pointer has moved since the press

    ImVec2 m_min{0, 0};
    glm::ivec2 m_size{1, 1};
    Resolution m_resolution;
    bool m_hovered = false;
    Drag m_drag = Drag::None;
    glm::dvec2 m_pressed{0};
    bool m_flew = false; // since the press
    ClickCycle m_cycle;
    std::vector<io::ObjectId> m_dragIds;

    io::TemplateId m_placing = io::TemplateId::None;
    io::TemplateId m_dropping = io::TemplateId::None; // dragged in from the Templates panel
    std::optional<renderer::Ghost> m_ghost;
    std::optional<PickHit> m_anchor; // where the button went down while placing
    float m_anchorYaw = 0;
    std::optional<float> m_yaw;
    std::uint64_t m_seed = 1;

    SoundHandle m_soundHovered;                // or in hand
    std::optional<ShownSound> m_soundDragged; // as it was at the beginning

    std::optional<Stroke> m_stroke;
    TerrainRay m_strokeGround; // as it was when that began
    std::optional<ScatterStroke> m_scatterStroke;
    std::optional<glm::dvec3> m_brushAt; // the ground under the pointer

    std::vector<io::ObjectId> m_tinted;      // the selection with the members of its groups, the primary last
    std::vector<io::Transform> m_transforms; // of those
    std::vector<renderer::Line> m_lines, m_frameLines; // of the selection; with those of the frame
    std::uint64_t m_shownRevision = 0, m_shownSelection = 0;
    double m_speedShown = 0; // s left
};

} // namespace editor
