// FlyCamera: how a person moves the eye: look and fly, orbit, pan and dolly about a focus, frame a box.
#pragma once

#include "editor/view.h"
#include "io/scene/bounds.h"

#include <glm/glm.hpp>

namespace editor {

class FlyCamera {
public:
    static constexpr double kMinSpeed = 0.05, kMaxSpeed = 5000; // m/s
    static constexpr double kFast = 4;                          // factor while Shift is held

    const io::Camera& camera() const { return m_camera; }
    void setCamera(const io::Camera& camera); // jumps there; a focus lies ahead at the old distance
    void setFov(float degrees) { m_camera.fov = glm::clamp(degrees, 1.0f, 170.0f); }

    void look(glm::dvec2 pixels); // right and down positive, as a mouse counts
    // Keys that are held: x right, y up, z forward, each -1..1. Called every frame, also with 0, while flying.
    void fly(const glm::dvec3& keys, bool fast, double seconds);
    bool moving() const;                     // still gliding: draw another frame
    void changeSpeed(double steps);          // of the wheel, each a factor of 1.2
    double speed() const { return m_speed; } // m/s
    void setSpeed(double metresPerSecond);

    void orbit(glm::dvec2 pixels);
    void pan(glm::dvec2 pixels, int viewHeight); // what is at the focus stays under the cursor
    void dolly(double steps);                    // towards the focus; each step goes a tenth of the way
    void frame(const io::WorldBox& box, double aspect, bool glide = true);
    void focusOn(const glm::dvec3& point); // orbit about this from now on, without turning
    glm::dvec3 focus() const;

    void update(double seconds); // advances the glide of frame()

private:
    void settle(); // back into bounds, whatever was done

    io::Camera m_camera;
    double m_speed = 10;         // m/s
    double m_focusDistance = 10; // m
    glm::dvec3 m_velocity{0};    // m/s
    bool m_gliding = false;
    double m_glideTime = 0; // s since it began
    glm::dvec3 m_glideFrom{0}, m_glideTo{0};
    double m_glideFromDistance = 10, m_glideToDistance = 10;
};

} // namespace editor
