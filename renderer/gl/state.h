// The fixed-function state of a draw, set as a whole, so that none outlives the draw it was meant for.
#pragma once

#include "renderer/gl/handle.h"

#include <glm/glm.hpp>

namespace renderer::gl {

enum class Blend { None, Alpha, Add, Over }; // Over: source plus source alpha times what is there (fog)

struct DrawState {
    GLenum depthTest = GL_ALWAYS; // reversed depth: GL_GREATER is nearer
    bool depthWrite = false;
    GLenum cull = GL_NONE;        // the face that is dropped
    bool clockwise = false;       // mirrored objects turn their triangles
    bool depthClamp = false;      // casters in front of the near plane are pressed onto it
    bool lines = false;           // edges of triangles only
    glm::vec2 depthOffset{0};     // slope factor, units
    Blend blend = Blend::None;    // of colour target 0
};

void apply(const DrawState& state);
void restoreDefaults(); // what others (ImGui's backend) expect to find

} // namespace renderer::gl
