#include "renderer/impostors.h"

#include "renderer/shaders/shared/impostor.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

// How far the quad stands before the centre, of the bounds' depth: clear of the ground around its foot, and in as much
// of its own shadow as what it shows. One does not see into a rock, but into a crown, the more so the slimmer it is.
float forwardOf(const ImpostorShape& shape)
{
    if (shape.leaves < 0.3f) return 0.75f;
    const float width = (shape.extent.x + shape.extent.z) / 2;
    return glm::clamp(0.5f - 0.13f * shape.extent.y / std::max(width, 1e-6f), 0.1f, 0.4f); // fitted to the trees of the valley
}

gl::Texture makeArray(std::string_view label, int layers)
{
    return gl::Texture{{.label = label,
                        .size = glm::ivec2{IMPOSTOR_FRAMES * IMPOSTOR_FRAME_TEXELS},
                        .layers = layers,
                        .format = GL_RGBA8,
                        .mips = IMPOSTOR_MIPS,
                        .nearestMip = true}}; // shaders ask for whole ones
}

void grow(gl::Texture& texture, std::string_view label, int layers, int kept)
{
    gl::Texture larger = makeArray(label, layers);
    for (int mip = 0; mip < larger.mips() && kept > 0; ++mip) {
        const glm::ivec2 size = larger.size(mip);
        glCopyImageSubData(texture.id(), GL_TEXTURE_2D_ARRAY, mip, 0, 0, 0, larger.id(), GL_TEXTURE_2D_ARRAY, mip, 0, 0,
                           0, size.x, size.y, kept);
    }
    texture = std::move(larger);
}

float meanRoughness(const io::Model& model, const io::Material& material)
{
    const int index = material.metallicRoughnessTexture.image;
    const io::Image* image = index >= 0 && std::size_t(index) < model.images.size() ? model.images[std::size_t(index)].get() : nullptr;
    if (!image || image->type != io::PixelType::U8 || image->channels < 2) return material.roughness;
    const std::size_t texels = image->bytes.size() / std::size_t(image->channels);
    const std::size_t step = std::max<std::size_t>(texels / 4096, 1) | 1; // odd, so that it does not run along a column
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < texels; i += step, ++count)
        sum += double(image->bytes[i * std::size_t(image->channels) + 1]);
    return count > 0 ? material.roughness * float(sum / count / 255) : material.roughness;
}

} // namespace

int ImpostorAtlas::add(int model)
{
    m_models.push_back(model);
    return int(m_models.size()) - 1;
}

void ImpostorAtlas::reserve()
{
    const int needed = int(m_models.size());
    if (needed <= m_colours.layers()) return;
    const int layers = m_filled == 0 ? needed : std::min(std::max(needed, m_colours.layers() * 2), kMost);
    grow(m_colours, "impostor colours", layers, m_filled);
    grow(m_surfaces, "impostor surfaces", layers, m_filled);
}

std::array<PackedVertex, 4> impostorQuad(const ImpostorShape& shape)
{
    const auto half = [](float value) { return std::uint32_t(std::lround(glm::clamp(value, 0.0f, 1.0f) * 32767)); };
    const glm::vec3 extent = glm::ceil(glm::clamp(shape.extent / shape.radius, 0.0f, 1.0f) * 255.0f);
    std::array<PackedVertex, 4> quad;
    for (int i = 0; i < 4; ++i)
        quad[std::size_t(i)] = {.position = shape.centre,
                                .normal = half(shape.leafRoughness) | half(shape.roughness) << 16,
                                .colour = glm::u8vec4{extent, 255 * forwardOf(shape)},
                                .uv0 = glm::vec2{i & 1 ? 1 : -1, i & 2 ? 1 : -1},
                                .uv1 = {shape.radius, float(shape.layer)}};
    return quad;
}

void measureSurface(const io::Model& model, ImpostorShape& shape)
{
    double sums[2] = {}, weights[2] = {};
    for (const io::Part& part : model.parts) {
        if (part.material < 0 || std::size_t(part.material) >= model.materials.size()) continue;
        const io::Material& material = model.materials[std::size_t(part.material)];
        const bool leaf = material.alphaMode == io::AlphaMode::Mask && material.doubleSided;
        sums[leaf] += double(part.indexCount) * meanRoughness(model, material);
        weights[leaf] += part.indexCount;
    }
    if (weights[0] > 0) shape.roughness = float(sums[0] / weights[0]);
    if (weights[1] > 0) shape.leafRoughness = float(sums[1] / weights[1]);
    if (weights[1] > 0) shape.leaves = float(weights[1] / (weights[0] + weights[1]));
}

} // namespace renderer
