// The programs that draw placed objects, one for each combination of features that a batch asks for.
#pragma once

#include "renderer/draw_list.h"
#include "renderer/shader_library.h"

#include <array>
#include <string>
#include <vector>

namespace renderer {

class ObjectPrograms {
public:
    // `relevant`: the features that this kind of drawing cares about; the others share a program.
    ObjectPrograms(ShaderLibrary& shaders, std::string fragment, std::vector<std::string> defines, unsigned relevant);
    const gl::Program& of(const Batch& batch, bool fading = false, bool swaying = false);

private:
    ShaderLibrary& m_shaders;
    std::string m_fragment;
    std::vector<std::string> m_defines;
    unsigned m_relevant;
    std::array<const gl::Program*, 4 * std::size_t(kFeatureEnd)> m_programs{}; // by features, whole and fading, still and swaying
};

// The texture arrays of a batch at their units; an impostor's pictures.
void bindArrays(GpuFrame& gpu, const ModelLibrary& models, const Batch& batch);

} // namespace renderer
