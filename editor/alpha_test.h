// Whether a ray that meets a triangle of a model sees it there, as the renderer's alpha test decides.
#pragma once

#include "io/scene/model.h"

#include <glm/glm.hpp>

namespace editor {

// Position inside triangle `firstIndex / 3` as barycentric weights of its second and third corner.
bool seenAt(const io::Model& model, const io::Material& material, std::size_t firstIndex, glm::vec2 barycentric);

// Alpha of the finest level, bilinear, 1 where there is no image or no alpha in it.
float sampleAlpha(const io::Image& image, const io::TextureUse& use, glm::vec2 uv);

} // namespace editor
