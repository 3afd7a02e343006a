// Images made ready for the GPU: eight bits a channel, a size of the library's classes, and their chain of mips.
#pragma once

#include "io/scene/image.h"

#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace renderer {

enum class ColourSpace { Srgb, Linear };

using Pixels = std::vector<glm::u8vec4>;

// The side of the square class that an image belongs to: a power of two.
int textureSide(glm::ivec2 size, int largest);

// All mips, largest first. sRGB images are averaged as light and come out as its square root, the encoding of all
// colours on the GPU. With a cutoff (else negative) colour is weighed by
// alpha, so that nothing dark bleeds into the edges of leaves, and each mip keeps the share of texels that pass.
struct MipRequest {
    const io::Image* image = nullptr;
    int side = 1; // of the largest mip
    ColourSpace space = ColourSpace::Linear;
    float alphaCutoff = -1;
};
std::vector<Pixels> mipChain(const MipRequest& request);

// The same of many, on all processors. `take(number, mips)` is called on this thread, in order.
void mipChains(std::span<const MipRequest> requests,
               const std::function<void(std::size_t, std::vector<Pixels>&)>& take);

io::Image checkerboard(); // what an image that could not be read looks like

} // namespace renderer
