#include "renderer/passes/precipitation.h"

#include "renderer/passes/shafts.h"
#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr int kMost = 16000, kMostWhereCheap = 6000; // in each box
constexpr double kFlutterPeriod = 1024;             // s, a whole number of each flake's turns

// Where a box that falls is under an eye that moves, wrapped into it.
glm::vec3 movedIn(const glm::dvec3& moved, double side)
{
    return glm::vec3{moved - glm::floor(moved / side) * side};
}

} // namespace

// Drops that are seen grow in number less than the rain does, as they grow in size too (Marshall and Palmer, "The Distribution of
// Raindrops with Size", 1948). Their speed is that of some 2 mm (Gunn and Kinzer, 1949).
glsl::Precipitation precipitationOf(Falling falling, const io::Wind& wind, const glm::dvec3& eye, double time, int most)
{
    const double rate = std::isfinite(falling.rate) ? std::max(double(falling.rate), 0.0) : 0;
    const double direction = glm::radians(double(wind.direction)), speed = double(wind.speed) * (falling.snow ? 0.8 : 0.5); // near the ground wind is slower, and drops are heavy
    const double down = falling.snow ? 1.1 : 5.5 + 1.2 * std::min(std::pow(rate, 0.21), 3.0);
    const glm::dvec3 fall{std::sin(direction) * speed, -down, -std::cos(direction) * speed};
    const glm::dvec3 moved = fall * time - eye;
    glsl::Precipitation p{};
    p.fall = glm::vec3{fall};
    p.exposure = falling.snow ? 1 / 120.0f : 1 / 60.0f; // a film's
    p.movedNear = {movedIn(moved, PRECIPITATION_NEAR), float(time - std::floor(time / kFlutterPeriod) * kFlutterPeriod)};
    p.movedWide = {movedIn(moved, PRECIPITATION_WIDE), 0};
    const double share = falling.snow ? std::sqrt(rate / 5) : std::pow(rate / 20, 0.6);
    p.drops = rate > 0 ? std::clamp(int(std::lround(share * most)), 1, most) : 0;
    p.snow = falling.snow ? 1 : 0;
    p.size = falling.snow ? 0.015f : 0.003f;
    p.opacity = falling.snow ? 0.9f : 0.3f;
    return p;
}

PrecipitationPass::PrecipitationPass(ShaderLibrary& shaders) : m_shaders{shaders} {}

void PrecipitationPass::render(GpuFrame& gpu, Radiance& radiance, const GBuffer& surfaces, const io::Environment& environment,
                               const Viewpoint& viewpoint, const Settings& settings)
{
    const io::Weather& weather = environment.weather;
    const bool under = environment.water.on && settings.water && viewpoint.eye.position.y < double(environment.water.level);
    if (!settings.particles || (weather.rain <= 0 && weather.snow <= 0) || under) return;
    const auto scope = gpu.scope("rain and snow");
    if (!m_none.id()) m_none = gl::VertexArray{"rain and snow"};
    std::vector<std::string> defines = lightingDefines(viewpoint, settings);
    addHaze(defines, viewpoint);
    const gl::Program& program = m_shaders.program(
        {.label = "rain and snow", .stages = {"precipitation.vert.glsl", "precipitation.frag.glsl"}, .defines = std::move(defines)});
    radiance.framebuffer.bind();
    surfaces.bind(gpu);
    if (!gpu.use(program)) return;
    gl::apply({.depthTest = GL_GREATER, .blend = gl::Blend::Over});
    glBindVertexArray(m_none.id());
    for (const Falling falling : {Falling{weather.rain, false}, Falling{weather.snow, true}}) {
        const glsl::Precipitation block = precipitationOf(falling, environment.wind, viewpoint.eye.position, viewpoint.time,
                                                          settings.skyPixels > 1 ? kMostWhereCheap : kMost);
        if (block.drops == 0) continue;
        gpu.constants(PARTICLES_BINDING, block);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, block.drops * 2);
        gpu.count(1, std::uint64_t(block.drops) * 4);
    }
}

} // namespace renderer
