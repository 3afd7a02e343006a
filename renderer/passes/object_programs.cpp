#include "renderer/passes/object_programs.h"

#include "renderer/shaders/shared/bindings.h"

namespace renderer {

ObjectPrograms::ObjectPrograms(ShaderLibrary& shaders, std::string fragment, std::vector<std::string> defines,
                               unsigned relevant)
    : m_shaders{shaders}, m_fragment{std::move(fragment)}, m_defines{std::move(defines)}, m_relevant{relevant}
{
    of({}); // the plain one at once, so that a faulty text shows at the start
}

const gl::Program& ObjectPrograms::of(const Batch& batch, bool fading, bool swaying)
{
    const unsigned features = batch.features & m_relevant;
    const gl::Program*& program = m_programs[features + (fading ? unsigned(kFeatureEnd) : 0u) + (swaying ? 2u * kFeatureEnd : 0u)];
    if (!program) {
        std::vector<std::string> defines = definesOf(features);
        if (fading) defines.emplace_back("FADE");
        if (swaying) defines.emplace_back("WIND");
        defines.insert(defines.end(), m_defines.begin(), m_defines.end());
        const bool impostor = features & kFeatureImpostor;
        const std::string vertex = impostor ? "impostors" : "objects";
        const bool own = impostor && (m_fragment == "objects" || m_fragment == "shadow");
        const std::string fragment = !own ? m_fragment : m_fragment == "objects" ? "impostors" : "impostors_shadow";
        program = &m_shaders.program({.label = fragment,
                                      .stages = {vertex + ".vert.glsl", fragment + ".frag.glsl"},
                                      .defines = std::move(defines)});
    }
    return *program;
}

void bindArrays(GpuFrame& gpu, const ModelLibrary& models, const Batch& batch)
{
    if (batch.features & kFeatureImpostor)
        return gpu.bind({{BASE_COLOUR_UNIT, &models.impostors().colours()}, {NORMAL_UNIT, &models.impostors().surfaces()}});
    for (int unit = 0; unit < MATERIAL_TEXTURES; ++unit)
        gpu.bind({{unit, &models.textures().array(batch.arrays[std::size_t(unit)])}});
}

} // namespace renderer
