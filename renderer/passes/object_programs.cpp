#include "renderer/passes/object_programs.h"

namespace renderer {

ObjectPrograms::ObjectPrograms(ShaderLibrary& shaders, std::string fragment, std::vector<std::string> defines,
                               unsigned relevant)
    : m_shaders{shaders}, m_fragment{std::move(fragment)}, m_defines{std::move(defines)}, m_relevant{relevant}
{
    of({}); // the plain one at once, so that a faulty text shows at the start
}

const gl::Program& ObjectPrograms::of(const Batch& batch, bool fading)
{
    const unsigned features = batch.features & m_relevant;
    const gl::Program*& program = m_programs[features + (fading ? 16 : 0)];
    if (!program) {
        std::vector<std::string> defines = definesOf(features);
        if (fading) defines.emplace_back("FADE");
        defines.insert(defines.end(), m_defines.begin(), m_defines.end());
        program = &m_shaders.program({.label = m_fragment,
                                      .stages = {"objects.vert.glsl", m_fragment + ".frag.glsl"},
                                      .defines = std::move(defines)});
    }
    return *program;
}

void bindArrays(GpuFrame& gpu, const ModelLibrary& models, const Batch& batch)
{
    for (int unit = 0; unit < MATERIAL_TEXTURES; ++unit)
        gpu.bind({{unit, &models.textures().array(batch.arrays[std::size_t(unit)])}});
}

} // namespace renderer
