#include "editor/alpha_test.h"

#include <cmath>

namespace editor {
namespace {

constexpr float kClear = 0.02f; // alpha of a blended surface below which nobody sees it

int wrapped(int texel, int size, io::Wrap wrap)
{
    if (wrap == io::Wrap::Clamp) return glm::clamp(texel, 0, size - 1);
    const int period = wrap == io::Wrap::Mirror ? 2 * size : size;
    const int inside = ((texel % period) + period) % period;
    return inside < size ? inside : period - 1 - inside;
}

float alphaOf(const io::Image& image, int x, int y)
{
    const std::size_t at = std::size_t(x) * image.channels + image.channels - 1;
    switch (image.type) {
    case io::PixelType::U8:
        return float(image.row<std::uint8_t>(y)[at]) / 255.0f;
    case io::PixelType::U16:
        return float(image.row<std::uint16_t>(y)[at]) / 65535.0f;
    case io::PixelType::F32:
        return image.row<float>(y)[at];
    }
    return 1;
}

glm::vec2 transformed(const io::TextureUse& use, glm::vec2 uv)
{
    const glm::vec2 scaled = use.scale * uv;
    const float c = std::cos(use.rotation), s = std::sin(use.rotation);
    return use.offset + glm::vec2{c * scaled.x + s * scaled.y, -s * scaled.x + c * scaled.y};
}

} // namespace

float sampleAlpha(const io::Image& image, const io::TextureUse& use, glm::vec2 uv)
{
    const bool hasAlpha = image.channels == 2 || image.channels == 4;
    if (!hasAlpha || image.size.x < 1 || image.size.y < 1) return 1;
    const glm::vec2 at = transformed(use, uv) * glm::vec2{image.size} - 0.5f;
    if (!(std::abs(at.x) < 1e9f && std::abs(at.y) < 1e9f)) return 1;
    const glm::vec2 corner = glm::floor(at);
    const glm::vec2 part = at - corner;
    const int x0 = wrapped(int(corner.x), image.size.x, use.wrapU),
              x1 = wrapped(int(corner.x) + 1, image.size.x, use.wrapU);
    const int y0 = wrapped(int(corner.y), image.size.y, use.wrapV),
              y1 = wrapped(int(corner.y) + 1, image.size.y, use.wrapV);
    return glm::mix(glm::mix(alphaOf(image, x0, y0), alphaOf(image, x1, y0), part.x),
                    glm::mix(alphaOf(image, x0, y1), alphaOf(image, x1, y1), part.x), part.y);
}

bool seenAt(const io::Model& model, const io::Material& material, std::size_t firstIndex, glm::vec2 barycentric)
{
    if (material.alphaMode == io::AlphaMode::Opaque) return true;
    const io::Vertex& a = model.vertices[model.indices[firstIndex]];
    const io::Vertex& b = model.vertices[model.indices[firstIndex + 1]];
    const io::Vertex& c = model.vertices[model.indices[firstIndex + 2]];
    const auto mixed = [&](auto x, auto y, auto z) {
        return x * (1 - barycentric.x - barycentric.y) + y * barycentric.x + z * barycentric.y;
    };
    float alpha = material.baseColour.a * mixed(float(a.colour.a), float(b.colour.a), float(c.colour.a)) / 255.0f;
    const io::TextureUse& use = material.baseColourTexture;
    const bool known = use.image >= 0 && std::size_t(use.image) < model.images.size() && model.images[use.image];
    if (known) {
        const glm::vec2 uv = use.uvSet == 1 ? mixed(a.uv1, b.uv1, c.uv1) : mixed(a.uv0, b.uv0, c.uv0);
        alpha *= sampleAlpha(*model.images[use.image], use, uv);
    }
    return alpha >= (material.alphaMode == io::AlphaMode::Mask ? material.alphaCutoff : kClear);
}

} // namespace editor
