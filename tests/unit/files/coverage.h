// How much of a picture a model's triangles cover, seen from six sides without perspective; alpha masks cut holes.
#pragma once

#include "io/scene/model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace io {

inline bool opaqueAt(const Model& model, const Material& material, const glm::vec2& uv)
{
    if (material.alphaMode == AlphaMode::Opaque) return true;
    const int number = material.baseColourTexture.image;
    const Image* image = number < 0 ? nullptr : model.images[std::size_t(number)].get();
    if (!image || image->channels != 4 || image->type != PixelType::U8) return true;
    const glm::vec2 at = (uv - glm::floor(uv)) * glm::vec2{image->size};
    const glm::ivec2 texel = glm::min(glm::ivec2{at}, image->size - 1);
    return float(image->row<std::uint8_t>(texel.y)[texel.x * 4 + 3]) / 255 * material.baseColour.a >=
           material.alphaCutoff;
}

// The six counts of covered pixels, in a square of `pixels` that holds the model's bounds.
inline std::array<int, 6> coverage(const Model& model, std::span<const std::uint32_t> indices,
                                   std::span<const Part> parts, int pixels)
{
    std::array<int, 6> result{};
    const glm::vec3 middle = model.bounds.centre();
    const float scale = float(pixels) / (glm::length(model.bounds.size()) * 1.05f);
    for (std::size_t side = 0; side < 6; ++side) {
        // Around the model at 0, 60 ... degrees, a little from above; the last from high above.
        const float turn = float(side) * 1.0472f, tilt = side == 5 ? 1.2f : 0.2f;
        const glm::vec3 right{std::cos(turn), 0, std::sin(turn)};
        const glm::vec3 up{std::sin(turn) * std::sin(tilt), std::cos(tilt), -std::cos(turn) * std::sin(tilt)};
        std::vector<bool> covered(std::size_t(pixels) * std::size_t(pixels));
        for (const Part& part : parts) {
            const Material& material = model.materials[std::size_t(part.material)];
            for (std::uint32_t i = part.firstIndex; i < part.firstIndex + part.indexCount; i += 3) {
                std::array<glm::vec2, 3> p;
                std::array<glm::vec2, 3> uv;
                for (std::size_t c = 0; c < 3; ++c) {
                    const Vertex& vertex = model.vertices[indices[i + c]];
                    const glm::vec3 from = vertex.position - middle;
                    p[c] = glm::vec2{glm::dot(from, right), glm::dot(from, up)} * scale + float(pixels) / 2;
                    uv[c] = material.baseColourTexture.uvSet == 1 ? vertex.uv1 : vertex.uv0;
                }
                const auto cross = [](glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; };
                const float area = cross(p[1] - p[0], p[2] - p[0]);
                if (std::abs(area) < 1e-6f) continue;
                const glm::ivec2 low = glm::max(glm::ivec2{glm::min(glm::min(p[0], p[1]), p[2])}, 0);
                const glm::ivec2 high = glm::min(glm::ivec2{glm::max(glm::max(p[0], p[1]), p[2])}, pixels - 1);
                for (int y = low.y; y <= high.y; ++y)
                    for (int x = low.x; x <= high.x; ++x) {
                        const glm::vec2 at{float(x) + 0.5f, float(y) + 0.5f};
                        const float b = cross(at - p[0], p[2] - p[0]) / area, c = cross(p[1] - p[0], at - p[0]) / area;
                        if (b < 0 || c < 0 || b + c > 1) continue;
                        if (opaqueAt(model, material, uv[0] * (1 - b - c) + uv[1] * b + uv[2] * c))
                            covered[std::size_t(y) * std::size_t(pixels) + std::size_t(x)] = true;
                    }
            }
        }
        result[side] = int(std::count(covered.begin(), covered.end(), true));
    }
    return result;
}

} // namespace io
