#include "renderer/terrain_layers.h"

#include "renderer/pixels.h"
#include "renderer/shaders/shared/bindings.h"

#include <algorithm>

namespace renderer {
namespace {

constexpr int kLargestLayer = 1024; // texels
static_assert(TERRAIN_LAYERS == io::kMostLayers);

// Brightness stands for the height of a cover's texels where nothing else does: stones over the earth between them.
std::uint8_t brightness(const glm::u8vec4& p)
{
    return std::uint8_t((p.x * 54 + p.y * 183 + p.z * 19) >> 8);
}

using Images = std::vector<std::shared_ptr<const io::Image>>;

int sideFor(const Images& images)
{
    int side = 1;
    for (const auto& image : images)
        if (image) side = std::max(side, textureSide(image->size, kLargestLayer));
    return side;
}

// With a channel of its own from other images, or where a layer has none, from its own texel.
struct Channel {
    const Images* images;
    glm::length_t at; // of the texel
    std::uint8_t (*otherwise)(const glm::u8vec4&);
};

gl::Texture layerArray(std::string_view label, const Images& images, ColourSpace space, const Channel& channel)
{
    const int side = std::max(sideFor(images), sideFor(*channel.images));
    gl::Texture array{{.label = label,
                       .size = glm::ivec2{side},
                       .layers = std::max(int(images.size()), 1),
                       .mips = gl::fullMipCount(glm::ivec2{side}),
                       .wrap = GL_REPEAT,
                       .anisotropic = true,
                       .lodBias = -0.6f}}; // the ground mostly runs away from the eye
    static const io::Image flat{.size = {1, 1}, .channels = 4, .bytes = std::vector<std::byte>{std::byte{128}, std::byte{128}, std::byte{255}, std::byte{255}}};
    std::vector<MipRequest> requests, extras;
    std::vector<std::size_t> layers, extraLayers; // of the requests
    for (std::size_t layer = 0; layer < images.size(); ++layer) {
        const io::Image *own = images[layer].get(), *extra = (*channel.images)[layer].get();
        if (!own && !extra) continue;
        requests.push_back({own ? own : &flat, side, space});
        layers.push_back(layer);
        if (!extra) continue;
        extras.push_back({extra, side, ColourSpace::Linear});
        extraLayers.push_back(layer);
    }
    std::vector<std::vector<Pixels>> given(images.size());
    mipChains(extras, [&](std::size_t number, std::vector<Pixels>& mips) { given[extraLayers[number]] = std::move(mips); });
    mipChains(requests, [&](std::size_t number, std::vector<Pixels>& mips) {
        const std::vector<Pixels>& extra = given[layers[number]];
        for (std::size_t mip = 0; mip < mips.size(); ++mip) {
            for (std::size_t i = 0; i < mips[mip].size(); ++i)
                mips[mip][i][channel.at] = extra.empty() ? channel.otherwise(mips[mip][i]) : extra[mip][i].x;
            array.upload(mips[mip].data(), GL_RGBA, GL_UNSIGNED_BYTE, int(mip), int(layers[number]));
        }
    });
    return array;
}

// Rise at the low end and fall at the high one, each over twice the half width; ends of the scale have no border.
glm::vec4 rampsOf(const glm::vec2& range, float half, const glm::vec2& scale)
{
    const float factor = 0.5f / half;
    glm::vec4 ramps{0, 1, 0, 1};
    if (range.x > scale.x) ramps.x = factor, ramps.y = 0.5f - range.x * factor;
    if (range.y < scale.y) ramps.z = -factor, ramps.w = 0.5f + range.y * factor;
    return ramps;
}

glsl::TerrainLayer layerBlock(const io::TerrainLayer& layer, bool colour, bool normal, int index)
{
    const float blend = std::max(layer.blend, 1e-3f);
    glsl::TerrainLayer block{};
    block.colour = layer.colour;
    block.repeats = 1 / std::max(layer.metres, 1e-3f);
    block.slopeRamps = rampsOf(layer.slope, blend * 7.5f, {0, 90});
    block.altitudeRamps = rampsOf(layer.altitude, blend * 20, {-1e5f, 1e5f});
    block.flowRamps = rampsOf(layer.flow, blend * 0.1f, {0, 1});
    block.ragged = {blend * 12, blend * 40};
    block.roughness = layer.roughness;
    block.colourLayer = colour ? float(index) : -1.0f;
    block.normalLayer = normal ? float(index) : -1.0f;
    return block;
}

} // namespace

void TerrainLayers::update(const io::Terrain& terrain, const io::Assets& assets, glsl::Terrain& block)
{
    const std::size_t count = std::min<std::size_t>(terrain.layers.size(), TERRAIN_LAYERS);
    Images colours(count), normals(count), roughness(count), heights(count);
    for (std::size_t i = 0; i < count && i < assets.layers.size(); ++i) {
        colours[i] = assets.layers[i].colour;
        normals[i] = assets.layers[i].normal;
        roughness[i] = assets.layers[i].roughness;
        if (colours[i]) heights[i] = assets.layers[i].height; // a plain colour has no texels to stand out
    }
    block.layers = int(count);
    m_asksForFlow = std::ranges::any_of(terrain.layers, [](const io::TerrainLayer& layer) { return layer.flow != glm::vec2{0, 1}; });
    for (std::size_t i = 0; i < count; ++i)
        block.layer[i] = layerBlock(terrain.layers[i], colours[i] != nullptr, normals[i] || roughness[i], int(i));
    if (count == 0) { // bare earth
        block.layers = 1;
        block.layer[0] = layerBlock({.colour = {0.16f, 0.17f, 0.11f}}, false, false, 0);
    }
    Images images = colours;
    for (const Images* more : {&normals, &roughness, &heights})
        images.insert(images.end(), more->begin(), more->end());
    if (images == m_images && m_colours) return; // a rule or a colour changed, no picture
    m_colours = layerArray("ground colours", colours, ColourSpace::Srgb, {&heights, 3, brightness});
    m_normals = layerArray("ground bumps", normals, ColourSpace::Linear, {&roughness, 2, [](const glm::u8vec4&) { return std::uint8_t{255}; }});
    m_images = std::move(images);
}

void TerrainLayers::bind(GpuFrame& gpu) const
{
    gpu.bind({{LAYER_COLOURS_UNIT, &m_colours}, {LAYER_NORMALS_UNIT, &m_normals}});
}

} // namespace renderer
