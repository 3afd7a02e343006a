#include "renderer/shadow_constants.h"

#include "renderer/gl/machine.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr float kNever = 1e30f; // m

glsl::ShadowCascade constantsOf(const Cascade& c, float blend, bool last)
{
    glsl::ShadowCascade constants{};
    constants.textureFromRelative = glm::mat4{c.textureFromRelative};
    constants.texel = float(c.texel);
    constants.depthRange = float(c.depthRange);
    const double width = (c.end - c.begin) * blend;
    const bool blends = !last && width > 0;
    constants.blendFrom = blends ? float(c.end - width) : kNever;
    constants.blendScale = blends ? float(1 / width) : 0.0f;
    constants.penumbra = float(c.penumbra);
    constants.contactReach = float(c.contactReach);
    const glm::dvec2 low = glm::dvec2{c.low} / double(c.resolution);
    constants.low = glm::vec2{low - glm::floor(low)};
    return constants;
}

} // namespace

glsl::Shadows shadowConstants(const io::Shadows& shadows, std::span<const Cascade> cascades, const glm::dvec3& towardLight)
{
    glsl::Shadows constants{};
    constants.ends = glm::vec4{kNever};
    constants.fifthEnd = kNever;
    constants.reach = filterReach(shadows);
    constants.bias = shadows.bias;
    constants.depthBias = shadows.depthBias;
    constants.cascades = int(cascades.size());
    constants.towardLight = glm::vec3{towardLight};
    constants.climb = float(towardLight.y / std::max(std::hypot(towardLight.x, towardLight.z), 1e-4));
    if (cascades.empty()) return constants;
    constants.resolution = float(cascades.front().resolution);
    for (std::size_t i = 0; i < cascades.size(); ++i) {
        const bool last = i + 1 == cascades.size();
        constants.cascade[i] = constantsOf(cascades[i], cascadeBlend(shadows), last);
        if (!last) (i < 4 ? constants.ends[int(i)] : constants.fifthEnd) = float(cascades[i].end);
    }
    const double end = cascades.back().end, width = std::max(end * double(glm::clamp(shadows.fade, 0.0f, 1.0f)), 1e-3);
    constants.fadeFrom = float(end - width);
    constants.fadeScale = float(1 / width);
    return constants;
}

std::vector<std::string> shadowDefines(const glsl::Shadows& shadows)
{
    if (shadows.cascades == 0) return {};
    std::vector<std::string> defines{"SHADOWS"};
    const int taps = std::min(int(std::ceil(shadows.reach)), MOST_TAPS);
    if (shadows.cascade[0].penumbra > 0) defines.emplace_back("CONTACT_SHADOWS");
    else defines.push_back("SHADOW_TAPS " + std::to_string(taps));
    if (gl::drawsInSoftware()) defines.emplace_back("NOISE_BLEND");
    return defines;
}

} // namespace renderer
