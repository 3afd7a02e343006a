// Asks the shadow maps of the shared renderer about places of the world, whatever a picture's pixels show.
#pragma once

#include "renderer/cascades.h"
#include "renderer/shader_library.h"
#include "renderer/shadow_constants.h"
#include "tests/gl/support/shared_renderer.h"

#include <span>
#include <vector>

namespace test {

struct GroundPoint {
    glm::dvec3 place{0};
    glm::vec3 normal{0, 1, 0};
};

class ShadowProbe {
public:
    ShadowProbe();
    // Renders a frame and answers the share of light at each point, 0 to 1.
    std::vector<float> ask(const io::Environment& environment, const io::Camera& camera, std::span<const GroundPoint> points);
    // Of the last frame.
    const std::vector<renderer::Cascade>& cascades() const { return m_cascades; }
    int cascadeAt(const glm::dvec3& place) const; // -1: beyond them, or where one turns into the next
    bool seen(const glm::dvec3& place) const;

    renderer::Settings settings; // of frames
    bool mixes = false; // cascades where they turn into one another, also where noise picks one of them

private:
    renderer::ShaderLibrary m_shaders;
    renderer::Eye m_eye;
    glsl::Shadows m_constants{};
    std::vector<renderer::Cascade> m_cascades;
};

// The depths of a shadow map, of any renderer in the context.
std::vector<float> shadowMapDepths(int layer);

} // namespace test
