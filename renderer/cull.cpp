#include "renderer/cull.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace renderer {
namespace {

constexpr std::size_t kBlock = 512;

struct Block {
    std::array<float, kBlock> inside; // negative: outside
};

void testPlanes(const Spheres& s, const Volume& volume, std::size_t first, std::size_t count, Block& block)
{
    const float* x = s.x.data() + first;
    const float* y = s.y.data() + first;
    const float* z = s.z.data() + first;
    const float* r = s.radius.data() + first;
    for (const glm::dvec4& plane : volume.planes) {
        const glm::vec4 p{plane};
        for (std::size_t i = 0; i < count; ++i)
            block.inside[i] = std::min(block.inside[i], p.x * x[i] + p.y * y[i] + p.z * z[i] + p.w + r[i]);
    }
}

void testSize(const Spheres& s, const CullRequest& request, std::size_t first, std::size_t count, Block& block)
{
    const float* x = s.x.data() + first;
    const float* y = s.y.data() + first;
    const float* z = s.z.data() + first;
    const float* r = s.radius.data() + first;
    const glm::vec3 eye{request.eye};
    const float k = request.smallestAngle * request.smallestAngle;
    for (std::size_t i = 0; i < count; ++i) {
        const float dx = x[i] - eye.x, dy = y[i] - eye.y, dz = z[i] - eye.z;
        const float large = r[i] * r[i] - k * (dx * dx + dy * dy + dz * dz);
        block.inside[i] = std::min(block.inside[i], std::min(large, r[i] - request.smallestRadius));
    }
}

} // namespace

void Spheres::resize(std::size_t count)
{
    for (std::vector<float>* values : {&x, &y, &z, &radius})
        values->resize(count);
    flags.resize(count);
}

void Spheres::set(std::size_t at, const glm::dvec3& centre, double sphereRadius, std::uint8_t sphereFlags)
{
    x[at] = float(centre.x);
    y[at] = float(centre.y);
    z[at] = float(centre.z);
    const double rounding = 1e-6 * (std::abs(centre.x) + std::abs(centre.y) + std::abs(centre.z));
    radius[at] = float(sphereRadius * 1.0001 + rounding);
    flags[at] = sphereFlags;
}

void Spheres::move(std::size_t to, std::size_t from)
{
    for (std::vector<float>* values : {&x, &y, &z, &radius})
        (*values)[to] = (*values)[from];
    flags[to] = flags[from];
}

void cull(const Spheres& spheres, const CullRequest& request, std::vector<std::uint32_t>& visible)
{
    visible.clear();
    Block block;
    for (std::size_t first = 0; first < spheres.size(); first += kBlock) {
        const std::size_t count = std::min(kBlock, spheres.size() - first);
        block.inside.fill(0);
        if (request.volume) testPlanes(spheres, *request.volume, first, count, block);
        testSize(spheres, request, first, count, block);
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint8_t flags = spheres.flags[first + i];
            const bool wanted = (flags & request.required) == request.required && (flags & request.refused) == 0;
            if (block.inside[i] >= 0 && wanted) visible.push_back(std::uint32_t(first + i));
        }
    }
}

} // namespace renderer
