// Takes the pictures that impostors show: all frames of a model in one draw, then smaller and smaller. What changes them
// raises kBaking in kept_impostors.cpp.
#pragma once

#include "renderer/impostors.h"
#include "renderer/kept_impostors.h"
#include "renderer/passes/object_programs.h"
#include "renderer/shaders/shared/impostor.h"

namespace renderer {

class ImpostorBaker {
public:
    ImpostorBaker(ShaderLibrary& shaders, std::shared_ptr<io::KeptBytes> kept);

    // Fills the layers that are still empty, in their order, with what is kept where that is known. Leaves the view and the records bound anew.
    void render(GpuFrame& gpu, const ModelLibrary& models, ImpostorAtlas& atlas);

private:
    struct Sheet { // all frames of one model at one size
        gl::Texture colour, surface;
        gl::Framebuffer framebuffer;
    };
    static Sheet makeSheet(int side, const gl::Texture* depth);
    void makeSheets();
    void bake(GpuFrame& gpu, const ModelLibrary& models, int model);
    void shrink(GpuFrame& gpu, const ImpostorAtlas& atlas, int layer);

    KeptImpostors m_kept;
    ObjectPrograms m_programs;
    const gl::Program& m_shrink;
    gl::VertexArray m_objects;
    gl::Texture m_depth;
    std::array<Sheet, IMPOSTOR_MIPS + 1> m_sheets; // the first is twice as large as what is kept
};

} // namespace renderer
