// All textures of all models in a few arrays, one for each size and colour space, so that one bind serves a whole
// multi-draw. The same pixels are kept once.
#pragma once

#include "io/scene/image.h"
#include "renderer/gl/texture.h"
#include "renderer/pixels.h"

#include <map>
#include <memory>
#include <vector>

namespace renderer {

struct TextureLayer {
    int array = 0;  // 0 is the array of one white texel
    int layer = -1; // -1: no texture
};

class TextureLibrary {
public:
    TextureLibrary();

    // A null image becomes a checkerboard. `alphaCutoff` is negative where nothing is cut out.
    TextureLayer add(const std::shared_ptr<const io::Image>& image, ColourSpace space, float alphaCutoff);
    const gl::Texture& array(int index) const { return m_arrays[std::size_t(index)].texture; }
    int arrays() const { return int(m_arrays.size()); }
    void clear();

private:
    struct Array {
        gl::Texture texture;
        int side = 1;
        ColourSpace space = ColourSpace::Srgb;
        int used = 0;
    };
    struct Content { // of an image and how it is read
        std::uint64_t hashA = 0, hashB = 0;
        int space = 0;
        int cutoff = -1; // in 255ths
        auto operator<=>(const Content&) const = default;
    };
    static Content contentOf(const io::Image& image, ColourSpace space, float alphaCutoff);
    int arrayWithRoom(int side, ColourSpace space);
    void grow(Array& array);

    std::vector<Array> m_arrays;
    std::map<Content, TextureLayer> m_known;
    std::map<std::pair<const io::Image*, int>, std::pair<std::shared_ptr<const io::Image>, Content>> m_hashed;
    int m_largestSide = 2048;
    int m_mostLayers = 2048;
};

} // namespace renderer
