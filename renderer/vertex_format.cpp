#include "renderer/vertex_format.h"

#include <cmath>

namespace renderer {
namespace {

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& otherwise)
{
    const float length = glm::length(v);
    return length > 1e-12f && std::isfinite(length) ? v / length : otherwise;
}

std::uint32_t snorm(float value, int bits)
{
    const float top = float((1 << (bits - 1)) - 1);
    const auto integer = std::int32_t(std::lround(glm::clamp(value, -1.0f, 1.0f) * top));
    return std::uint32_t(integer) & ((1u << bits) - 1);
}

} // namespace

// Meyer et al., "On Floating-Point Normal Vectors" (2010).
glm::vec2 octahedral(const glm::vec3& unit)
{
    const glm::vec2 p = glm::vec2{unit} / (std::abs(unit.x) + std::abs(unit.y) + std::abs(unit.z));
    if (unit.z >= 0) return p;
    return (1.0f - glm::abs(glm::vec2{p.y, p.x})) * glm::vec2{p.x >= 0 ? 1 : -1, p.y >= 0 ? 1 : -1};
}

glm::vec3 fromOctahedral(const glm::vec2& point)
{
    glm::vec3 v{point, 1 - std::abs(point.x) - std::abs(point.y)};
    const float fold = glm::max(-v.z, 0.0f);
    v.x += v.x >= 0 ? -fold : fold;
    v.y += v.y >= 0 ? -fold : fold;
    return glm::normalize(v);
}

PackedVertex pack(const io::Vertex& vertex, std::uint32_t material)
{
    const glm::vec2 normal = octahedral(unitOr(vertex.normal, {0, 1, 0}));
    const glm::vec2 tangent = octahedral(unitOr(glm::vec3{vertex.tangent}, {1, 0, 0}));
    return {.position = vertex.position,
            .normal = snorm(normal.x, 16) | snorm(normal.y, 16) << 16,
            .tangent = snorm(tangent.x, 16) | snorm(tangent.y, 15) << 16 | (vertex.tangent.w < 0 ? 1u << 31 : 0u),
            .colour = vertex.colour,
            .uv0 = vertex.uv0,
            .uv1 = vertex.uv1,
            .material = material};
}

} // namespace renderer
