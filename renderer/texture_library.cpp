#include "renderer/texture_library.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace renderer {
namespace {

constexpr std::uint64_t kLargestArray = std::uint64_t(512) << 20; // bytes; beyond it another array is begun

std::shared_ptr<gl::Texture> makeArray(int side, ColourSpace space, int layers)
{
    return std::make_shared<gl::Texture>(
        gl::TextureDesc{.label = space == ColourSpace::Srgb ? "colour textures" : "value textures",
                        .size = glm::ivec2{side},
                        .layers = layers,
                        .format = GL_RGBA8,
                        .mips = gl::fullMipCount(glm::ivec2{side}),
                        .wrap = GL_REPEAT,
                        .anisotropic = true});
}

void fill(gl::Texture& texture, int layer, const std::vector<Pixels>& mips)
{
    for (std::size_t mip = 0; mip < mips.size(); ++mip)
        texture.upload(mips[mip].data(), GL_RGBA, GL_UNSIGNED_BYTE, int(mip), layer);
}

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value)
{
    hash = (hash ^ value) * 0x9fb21c651e98df25ull;
    return hash ^ (hash >> 29);
}

} // namespace

std::shared_ptr<gl::Texture> TexturePool::find(const TextureContent& content) const
{
    const auto known = m_known.find(content);
    return known == m_known.end() ? nullptr : known->second.lock();
}

void TexturePool::forgetUnused()
{
    std::erase_if(m_known, [](const auto& known) { return known.second.expired(); });
}

TextureLibrary::TextureLibrary(std::shared_ptr<TexturePool> pool) : m_pool{std::move(pool)}
{
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &m_mostLayers);
    clear();
}

void TextureLibrary::clear()
{
    m_arrays.clear();
    m_pending.clear();
    m_known.clear();
    m_hashed.clear();
    Array& white = m_arrays.emplace_back();
    white.texture = makeArray(1, ColourSpace::Srgb, 1);
    white.used = 1;
    const glm::u8vec4 texel{255};
    white.texture->upload(&texel, GL_RGBA, GL_UNSIGNED_BYTE);
}

TextureContent TextureLibrary::contentOf(const io::Image& image, ColourSpace space, float alphaCutoff)
{
    TextureContent content{.hashA = 0x243f6a8885a308d3ull, .hashB = 0x13198a2e03707344ull, .space = int(space)};
    content.cutoff = alphaCutoff < 0 ? -1 : int(std::lround(alphaCutoff * 255));
    for (const int value : {image.size.x, image.size.y, image.channels, int(image.type)}) {
        content.hashA = mixed(content.hashA, std::uint64_t(value));
        content.hashB = mixed(content.hashB, ~std::uint64_t(value));
    }
    for (std::size_t at = 0; at < image.bytes.size(); at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, image.bytes.data() + at, std::min<std::size_t>(8, image.bytes.size() - at));
        content.hashA = mixed(content.hashA, word);
        content.hashB = mixed(content.hashB, word * 0xd6e8feb86659fd93ull + at);
    }
    return content;
}

io::ContentKey TextureLibrary::pixelsOf(const io::Image* image) const
{
    const auto hashed = m_hashed.lower_bound({image, 0});
    if (!image || hashed == m_hashed.end() || hashed->first.first != image) return {};
    return {hashed->second.second.hashA, hashed->second.second.hashB};
}

int TextureLibrary::arrayWithRoom(int side, ColourSpace space)
{
    const std::uint64_t layerBytes = std::uint64_t(side) * side * 4;
    const int most = int(std::clamp<std::uint64_t>(kLargestArray / layerBytes, 1, std::uint64_t(m_mostLayers)));
    for (std::size_t i = 1; i < m_arrays.size(); ++i)
        if (m_arrays[i].side == side && m_arrays[i].space == space && m_arrays[i].used < most) return int(i);
    m_arrays.push_back({.texture = makeArray(side, space, 1), .side = side, .space = space});
    return int(m_arrays.size()) - 1;
}

void TextureLibrary::grow(Array& array)
{
    std::shared_ptr<gl::Texture> larger =
        makeArray(array.side, array.space, std::min(array.texture->layers() * 2, m_mostLayers));
    for (int mip = 0; mip < larger->mips(); ++mip) {
        const glm::ivec2 size = larger->size(mip);
        glCopyImageSubData(array.texture->id(), GL_TEXTURE_2D_ARRAY, mip, 0, 0, 0, larger->id(), GL_TEXTURE_2D_ARRAY, mip, 0,
                           0, 0, size.x, size.y, array.used);
    }
    array.texture = std::move(larger);
}

TextureLayer TextureLibrary::add(const std::shared_ptr<const io::Image>& image, ColourSpace space, float alphaCutoff)
{
    static const auto kMissing = std::make_shared<const io::Image>(checkerboard());
    const bool usable = image && image->size.x > 0 && image->size.y > 0 && image->channels >= 1 && image->channels <= 4 &&
                        image->bytes.size() >= image->rowBytes() * std::size_t(image->size.y);
    const std::shared_ptr<const io::Image>& source = usable ? image : kMissing;

    const std::pair key{source.get(), int(space) + (alphaCutoff < 0 ? 0 : 2 + int(std::lround(alphaCutoff * 255)))};
    auto hashed = m_hashed.find(key);
    if (hashed == m_hashed.end())
        hashed = m_hashed.emplace(key, std::pair{source, contentOf(*source, space, alphaCutoff)}).first;
    const TextureContent& content = hashed->second.second;
    if (const auto known = m_known.find(content); known != m_known.end()) return known->second;

    if (m_pool) return m_known.emplace(content, addAlone(content, *source, space, alphaCutoff)).first->second;

    const int side = textureSide(source->size, m_largestSide);
    const int index = arrayWithRoom(side, space);
    Array& array = m_arrays[std::size_t(index)];
    if (array.used == array.texture->layers()) grow(array);
    const TextureLayer place{.array = index, .layer = array.used++};
    m_pending.push_back({place, source, {source.get(), side, space, alphaCutoff}});
    m_known.emplace(content, place);
    return place;
}

void TextureLibrary::upload()
{
    std::vector<MipRequest> requests;
    for (const Pending& pending : m_pending)
        requests.push_back(pending.request);
    mipChains(requests, [&](std::size_t number, std::vector<Pixels>& mips) {
        const TextureLayer& place = m_pending[number].place;
        fill(*m_arrays[std::size_t(place.array)].texture, place.layer, mips);
    });
    m_pending.clear();
}

TextureLayer TextureLibrary::addAlone(const TextureContent& content, const io::Image& image, ColourSpace space, float alphaCutoff)
{
    const int side = textureSide(image.size, m_largestSide);
    std::shared_ptr<gl::Texture> texture = m_pool->find(content);
    if (!texture) {
        texture = makeArray(side, space, 1);
        fill(*texture, 0, mipChain({&image, side, space, alphaCutoff}));
        m_pool->keep(content, texture);
    }
    m_arrays.push_back({.texture = std::move(texture), .side = side, .space = space, .used = 1});
    return {.array = int(m_arrays.size()) - 1, .layer = 0};
}

} // namespace renderer
