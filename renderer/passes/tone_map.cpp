#include "renderer/passes/tone_map.h"

#include "renderer/shaders/shared/bindings.h"

namespace renderer {
namespace {

// Only what differs from neutral: the rest is the identity because it is not there.
std::vector<std::string> definesOf(const ToneMapPass::Input& in, const Settings& settings)
{
    static_assert(int(ToneMap::Agx) == TONE_AGX && int(ToneMap::Reinhard) == TONE_REINHARD);
    const glsl::Film& film = in.film;
    std::vector<std::string> defines{"CURVE " + std::to_string(int(settings.toneMap))};
    const glm::mat3 white{glm::vec3{film.white[0]}, glm::vec3{film.white[1]}, glm::vec3{film.white[2]}};
    const auto add = [&](bool wanted, const char* define) {
        if (wanted) defines.emplace_back(define);
    };
    add(in.bloom, "BLOOM");
    add(in.chosenExposure, "CHOSEN_EXPOSURE");
    add(film.vignette > 0, "VIGNETTE");
    add(white != glm::mat3{1}, "WHITE_BALANCE");
    add(film.contrast != 1, "CONTRAST");
    add(film.saturation != 1, "SATURATION");
    add(film.grain > 0, "GRAIN");
    add(settings.dither, "DITHER");
    return defines;
}

} // namespace

ToneMapPass::ToneMapPass(ShaderLibrary& shaders) : m_shaders{shaders}
{
    shaders.fullScreen("tone_map", {"CURVE 0", "BLOOM", "VIGNETTE", "DITHER"});
}

void ToneMapPass::render(GpuFrame& gpu, PictureTarget& canvas, const Input& in, const Settings& settings)
{
    const auto scope = gpu.scope("tone map");
    const gl::Program& program = m_shaders.fullScreen("tone_map", definesOf(in, settings));
    canvas.framebuffer.bind();
    if (in.chosenExposure) in.surfaces.bind(gpu);
    gpu.constants(PASS_BINDING, in.film);
    gpu.fullScreen(program, {}, {{IMAGE_UNIT, &in.radiance}, {BLOOM_UNIT, in.bloom}});
}

} // namespace renderer
