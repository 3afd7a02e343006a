// Small pictures of templates: the model on a plain ground in studio light, made once and kept.
#pragma once

#include "renderer/passes/object_programs.h"
#include "renderer/passes/passing_objects.h"
#include "renderer/passes/picture.h"
#include "renderer/scenery.h"

#include <map>

namespace renderer {

class Thumbnails {
public:
    explicit Thumbnails(ShaderLibrary& shaders);

    // The picture as it was made before, or an empty one.
    Picture kept(io::TemplateId id, int pixels) const;
    Picture make(GpuFrame& gpu, const World& world, io::TemplateId id, int pixels);
    void forget(io::TemplateId id) { m_kept.erase(id); }
    void forgetAll() { m_kept.clear(); }

private:
    struct Kept {
        gl::Texture texture;
        int pixels = 0;
    };
    void resize(int pixels);
    void drawModel(GpuFrame& gpu, const World& world, io::TemplateId id);

    ObjectPrograms m_programs;
    const gl::Program &m_backdrop, &m_develop;
    gl::VertexArray m_objects;
    gl::Texture m_colour, m_depth; // twice the size of the picture, for smooth edges
    gl::Framebuffer m_framebuffer;
    gl::Buffer m_skyLight;
    std::map<io::TemplateId, Kept> m_kept;
};

} // namespace renderer
