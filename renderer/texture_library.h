// All textures of all models in a few arrays, one for each size and colour space, so that one bind serves a whole
// multi-draw. The same pixels are kept once.
#pragma once

#include "io/base/content_hash.h"
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

struct TextureContent { // of an image and how it is read
    std::uint64_t hashA = 0, hashB = 0;
    int space = 0;
    int cutoff = -1; // in 255ths
    auto operator<=>(const TextureContent&) const = default;
};

// Textures that stand alone, each held by the libraries that show it and gone with the last of them.
class TexturePool {
public:
    std::shared_ptr<gl::Texture> find(const TextureContent& content) const;
    void keep(const TextureContent& content, const std::shared_ptr<gl::Texture>& texture) { m_known[content] = texture; }
    void forgetUnused();

private:
    std::map<TextureContent, std::weak_ptr<gl::Texture>> m_known;
};

class TextureLibrary {
public:
    explicit TextureLibrary(std::shared_ptr<TexturePool> pool = nullptr); // given one, each texture is an array of its own

    // A null image becomes a checkerboard. `alphaCutoff` is negative where nothing is cut out.
    TextureLayer add(const std::shared_ptr<const io::Image>& image, ColourSpace space, float alphaCutoff);
    void upload(); // what was added since the last call
    const gl::Texture& array(int index) const { return *m_arrays[std::size_t(index)].texture; }
    io::ContentKey pixelsOf(const io::Image* image) const; // of one that was added; zeros for others
    int arrays() const { return int(m_arrays.size()); }
    void clear();

private:
    struct Array {
        std::shared_ptr<gl::Texture> texture;
        int side = 1;
        ColourSpace space = ColourSpace::Srgb;
        int used = 0;
    };
    static TextureContent contentOf(const io::Image& image, ColourSpace space, float alphaCutoff);
    int arrayWithRoom(int side, ColourSpace space);
    void grow(Array& array);
    TextureLayer addAlone(const TextureContent& content, const io::Image& image, ColourSpace space, float alphaCutoff);

    struct Pending {
        TextureLayer place;
        std::shared_ptr<const io::Image> image;
        MipRequest request;
    };

    std::shared_ptr<TexturePool> m_pool;

    std::vector<Array> m_arrays;
    std::vector<Pending> m_pending; // still to be filled
    std::map<TextureContent, TextureLayer> m_known;
    std::map<std::pair<const io::Image*, int>, std::pair<std::shared_ptr<const io::Image>, TextureContent>> m_hashed;
    int m_largestSide = 2048;
    int m_mostLayers = 2048;
};

} // namespace renderer
