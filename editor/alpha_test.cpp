#include "editor/alpha_test.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

constexpr float kClear = 0.02f; // alpha of a blended surface below which nobody sees it

int wrapped(int texel, int size, io::Wrap wrap)
{
    if (texel >= 0 && texel < size) return texel;
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

bool hasAlpha(const io::Image& image)
{
    return (image.channels == 2 || image.channels == 4) && image.size.x > 0 && image.size.y > 0;
}

// The turn and scale of KHR_texture_transform, without its offset.
glm::vec2 turned(const io::TextureUse& use, glm::vec2 uv)
{
    const glm::vec2 scaled = use.scale * uv;
    if (use.rotation == 0) return scaled;
    const float c = std::cos(use.rotation), s = std::sin(use.rotation);
    return {c * scaled.x + s * scaled.y, -s * scaled.x + c * scaled.y};
}

template <class Texel> float bilinear(glm::ivec2 size, const io::TextureUse& use, glm::vec2 uv, Texel&& texel)
{
    const glm::vec2 at = uv * glm::vec2{size} - 0.5f;
    if (!(std::abs(at.x) < 1e9f && std::abs(at.y) < 1e9f)) return 1;
    const glm::vec2 corner = glm::floor(at);
    const glm::vec2 part = at - corner;
    const int x0 = wrapped(int(corner.x), size.x, use.wrapU), x1 = wrapped(int(corner.x) + 1, size.x, use.wrapU);
    const int y0 = wrapped(int(corner.y), size.y, use.wrapV), y1 = wrapped(int(corner.y) + 1, size.y, use.wrapV);
    return glm::mix(glm::mix(texel(x0, y0), texel(x1, y0), part.x), glm::mix(texel(x0, y1), texel(x1, y1), part.x),
                    part.y);
}

using Plane = std::vector<float>;

Plane halved(const Plane& from, glm::ivec2 size)
{
    const glm::ivec2 to = glm::max(size / 2, glm::ivec2{1});
    Plane result;
    result.reserve(std::size_t(to.x) * to.y);
    for (int y = 0; y < to.y; ++y)
        for (int x = 0; x < to.x; ++x) {
            const std::size_t row0 = std::size_t(std::min(2 * y, size.y - 1)) * size.x;
            const std::size_t row1 = std::size_t(std::min(2 * y + 1, size.y - 1)) * size.x;
            const int x0 = std::min(2 * x, size.x - 1), x1 = std::min(2 * x + 1, size.x - 1);
            result.push_back((from[row0 + x0] + from[row0 + x1] + from[row1 + x0] + from[row1 + x1]) / 4);
        }
    return result;
}

// The factor with which `share` of the texels reach the cutoff.
float factorFor(Plane plane, float share, float cutoff)
{
    if (share <= 0 || share >= 1) return 1;
    const auto rank = plane.begin() + std::ptrdiff_t((1 - share) * float(plane.size() - 1));
    std::ranges::nth_element(plane, rank);
    return *rank > 1e-3f ? std::clamp(cutoff / *rank, 0.5f, 4.0f) : 1.0f;
}

} // namespace

void AlphaMips::make()
{
    glm::ivec2 size = m_image->size;
    Plane plane;
    plane.reserve(std::size_t(size.x) * size.y);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            plane.push_back(alphaOf(*m_image, x, y));
    const auto passing = std::ranges::count_if(plane, [&](float alpha) { return alpha >= m_cutoff; });
    const float share = float(passing) / float(plane.size());
    while (size != glm::ivec2{1}) {
        plane = halved(plane, size);
        size = glm::max(size / 2, glm::ivec2{1});
        const float factor = std::max(size.x, size.y) >= 4 ? factorFor(plane, share, m_cutoff) : 1;
        Level& level = m_levels.emplace_back(Level{.size = size});
        for (const float alpha : plane)
            level.alpha.push_back(std::uint8_t(std::clamp(alpha * factor, 0.0f, 1.0f) * 255 + 0.5f));
    }
}

float AlphaMips::sample(const io::TextureUse& use, glm::vec2 uv, float lod)
{
    if (!hasAlpha(*m_image)) return 1;
    if (lod > 0 && m_levels.empty()) make();
    const glm::vec2 at = use.offset + turned(use, uv);
    const auto level = [&](int number) {
        if (number == 0) return bilinear(m_image->size, use, at, [&](int x, int y) { return alphaOf(*m_image, x, y); });
        const Level& one = m_levels[std::size_t(number) - 1];
        return bilinear(one.size, use, at,
                        [&](int x, int y) { return float(one.alpha[std::size_t(y) * one.size.x + x]) / 255.0f; });
    };
    const float exact = lod > 0 ? std::min(lod, float(m_levels.size())) : 0; // also for a lod that is no number
    const int finer = int(exact);
    const float blend = exact - float(finer);
    return blend > 0 ? glm::mix(level(finer), level(finer + 1), blend) : level(finer);
}

PixelSteps pixelSteps(const glm::vec3& edge1, const glm::vec3& edge2, const glm::vec3& direction, float metres)
{
    const glm::vec3 normal = glm::cross(edge1, edge2);
    const float area2 = glm::dot(normal, normal);
    const float fall = glm::dot(normal, direction);
    if (!(area2 > 0) || fall == 0) return {};
    const glm::vec3 aside = std::abs(direction.y) < 0.99f ? glm::vec3{0, 1, 0} : glm::vec3{1, 0, 0};
    const glm::vec3 right = glm::normalize(glm::cross(direction, aside)) * metres;
    PixelSteps steps;
    for (std::size_t i = 0; i < 2; ++i) {
        const glm::vec3 across = i == 0 ? right : glm::cross(right, direction);
        const glm::vec3 onPlane = across - direction * (glm::dot(normal, across) / fall);
        steps[i] = {glm::dot(glm::cross(onPlane, edge2), normal) / area2,
                    glm::dot(glm::cross(edge1, onPlane), normal) / area2};
    }
    return steps;
}

bool seenAt(const PartOfModel& part, std::size_t triangle, glm::vec2 at, const PixelSteps& steps)
{
    const io::Material& material = *part.material;
    if (material.alphaMode == io::AlphaMode::Opaque) return true;
    const io::Model& model = *part.model;
    const std::size_t first = part.firstIndex + 3 * triangle;
    const io::Vertex& a = model.vertices[model.indices[first]];
    const io::Vertex& b = model.vertices[model.indices[first + 1]];
    const io::Vertex& c = model.vertices[model.indices[first + 2]];
    const auto mixed = [&](auto x, auto y, auto z) { return x * (1 - at.x - at.y) + y * at.x + z * at.y; };
    float alpha = material.baseColour.a * mixed(float(a.colour.a), float(b.colour.a), float(c.colour.a)) / 255.0f;

    if (part.mips) {
        const io::TextureUse& use = material.baseColourTexture;
        const auto uv = use.uvSet == 1 ? std::array{a.uv1, b.uv1, c.uv1} : std::array{a.uv0, b.uv0, c.uv0};
        const glm::vec2 size = part.mips->size();
        float texels = 0; // that a pixel covers along its longer side
        for (const glm::vec2 step : steps) {
            const glm::vec2 moved = turned(use, (uv[1] - uv[0]) * step.x + (uv[2] - uv[0]) * step.y);
            texels = std::max(texels, glm::length(moved * size));
        }
        alpha *= part.mips->sample(use, mixed(uv[0], uv[1], uv[2]), texels > 1 ? std::log2(texels) : 0);
    }
    return alpha >= (material.alphaMode == io::AlphaMode::Mask ? material.alphaCutoff : kClear);
}

} // namespace editor
