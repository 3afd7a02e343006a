// Images made ready for the GPU: eight bits a channel, a size of the library's classes, and their chain of mips.
#pragma once

#include "io/scene/image.h"

#include <glm/glm.hpp>
#include <vector>

namespace renderer {

enum class ColourSpace { Srgb, Linear };

using Pixels = std::vector<glm::u8vec4>;

// The side of the square class that an image belongs to: a power of two.
int textureSide(glm::ivec2 size, int largest);

// All mips, largest first. sRGB images are averaged as light and come out as its square root, the encoding of all
// colours on the GPU. With a cutoff (else negative) colour is weighed by
// alpha, so that nothing dark bleeds into the edges of leaves, and each mip keeps the share of texels that pass.
std::vector<Pixels> mipChain(const io::Image& image, int side, ColourSpace space, float alphaCutoff);

io::Image checkerboard(); // what an image that could not be read looks like

} // namespace renderer
