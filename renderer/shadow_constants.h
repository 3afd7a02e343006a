// A scene's shadows and the frame's cascades as shaders read them.
#pragma once

#include "renderer/cascades.h"
#include "renderer/shaders/shared/shadows.h"

#include <span>
#include <string>

namespace renderer {

glsl::Shadows shadowConstants(const io::Shadows& shadows, std::span<const Cascade> cascades, const glm::dvec3& towardLight);

// The defines that shadows.glsl asks for.
std::vector<std::string> shadowDefines(const glsl::Shadows& shadows);

} // namespace renderer
