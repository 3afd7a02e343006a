// PathTool: the camera path in hand in the viewport: its line, its keys to drag, and a flight along it.
#pragma once

#include "editor/fly_camera.h"
#include "editor/view.h"
#include "io/scene/scene.h"
#include "renderer/renderer.h"

#include <optional>
#include <string>
#include <vector>

namespace editor {

class Document;

class PathTool {
public:
    std::string path; // that is shown, by name; empty: none
    double time = 0;  // s, where on it one looks

    const io::CameraPath* target(const Document& document) const; // null: none is shown
    void reset() { *this = {}; }

    std::optional<std::size_t> keyUnder(const Document& document, const View& view, glm::dvec2 pixel) const;
    bool begin(Document& document, const View& view, glm::dvec2 pixel); // false: no key lies there
    void drag(Document& document, const View& view, glm::dvec2 pixel);  // in the plane that faces the eye
    void end(Document& document, bool keep);

    void fly(FlyCamera& camera);  // from `time` on
    void show(const Document& document, FlyCamera& camera, double seconds); // what is seen from there, standing still
    void stop(FlyCamera& camera); // back to where one looked from before
    void update(const Document& document, FlyCamera& camera, double seconds);
    bool flying() const { return m_before.has_value(); } // or standing on it
    bool moving() const { return flying() && m_goes; }

    void addLines(const Document& document, std::vector<renderer::Line>& lines) const;
    std::vector<std::optional<glm::dvec2>> keysOnScreen(const Document& document, const View& view) const; // pixels; none: behind the eye

private:
    std::optional<std::size_t> m_dragged;
    glm::dvec3 m_grabbed{0}; // from where the key was grabbed to its place, m
    std::optional<io::Camera> m_before;
    bool m_goes = false;
};

} // namespace editor
