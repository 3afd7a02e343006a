// A picture being painted: colour (sRGB), coverage and height of each texel. The height becomes the normal map.
#pragma once

#include "io/scene/image.h"

#include <glm/glm.hpp>
#include <memory>
#include <vector>

namespace make {

struct Texel {
    glm::vec3 colour{0}; // sRGB, 0..1
    float alpha = 1;
    float height = 0; // texels
};

class Canvas {
public:
    Canvas(int side, Texel fill) : m_side{side}, m_texels(std::size_t(side) * side, fill) {}

    int side() const { return m_side; }
    Texel& at(int x, int y) { return m_texels[std::size_t(y) * m_side + x]; }
    const Texel& at(int x, int y) const { return m_texels[std::size_t(y) * m_side + x]; }
    Texel& wrapped(int x, int y) { return at(x & (m_side - 1), y & (m_side - 1)); } // the side is a power of two

    // paint(texel, place) for each texel; place is 0..1 in both directions, y down.
    template <class Paint> void each(Paint paint)
    {
        for (int y = 0; y < m_side; ++y)
            for (int x = 0; x < m_side; ++x)
                paint(at(x, y), (glm::vec2{x, y} + 0.5f) / float(m_side));
    }

    // paint(texel, offset) for the texels within `radius` of `centre` (texels), across the edges when it tiles.
    template <class Paint> void stamp(glm::vec2 centre, float radius, bool tiles, Paint paint)
    {
        const glm::ivec2 low{glm::floor(centre - radius)}, high{glm::ceil(centre + radius)};
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                if (tiles || (x >= 0 && y >= 0 && x < m_side && y < m_side))
                    paint(wrapped(x, y), glm::vec2{x, y} + 0.5f - centre);
    }

private:
    int m_side;
    std::vector<Texel> m_texels;
};

Canvas halved(const Canvas& canvas); // each texel the mean of four: painting at twice the size smooths edges

// Gives the texels without coverage the colour of their neighbourhood, so that smaller mip levels have no dark rims.
void bleedColour(Canvas& canvas);

using Picture = std::shared_ptr<const io::Image>;

// `step` is the distance between neighbouring 8-bit values: 4 halves the size of the PNG of a noisy texture.
Picture colourPicture(const Canvas& canvas, bool withAlpha, int step);
Picture normalPicture(const Canvas& canvas, float strength, int step); // tangent space, +Y up; tiles

glm::vec3 rgb(int hex); // 0xrrggbb

} // namespace make
