// Rain and snow around the eye.
#pragma once

#include "renderer/passes/lighting.h"
#include "renderer/shaders/shared/precipitation.h"

namespace renderer {

// Of rain, or of snow; no drops where none falls. `most` in each of the two boxes.
struct Falling {
    float rate = 0; // mm an hour
    bool snow = false;
};
glsl::Precipitation precipitationOf(Falling falling, const io::Wind& wind, const glm::dvec3& eye, double time, int most);

class PrecipitationPass {
public:
    explicit PrecipitationPass(ShaderLibrary& shaders);
    void render(GpuFrame& gpu, Radiance& radiance, const GBuffer& surfaces, const io::Environment& environment,
                const Viewpoint& viewpoint, const Settings& settings);

private:
    ShaderLibrary& m_shaders;
    gl::VertexArray m_none;
};

} // namespace renderer
