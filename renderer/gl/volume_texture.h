// A texture in space: storage fixed at birth, labelled, filtered linearly and repeated.
#pragma once

#include "renderer/gl/handle.h"
#include "renderer/gl/texture.h"

#include <glm/glm.hpp>
#include <string_view>

namespace renderer::gl {

struct VolumeTextureDesc {
    std::string_view label; // what a debugger shows
    glm::ivec3 size{1};
    GLenum format = GL_RG8;
    int mips = 1;
};

class VolumeTexture {
public:
    VolumeTexture() = default;
    explicit VolumeTexture(const VolumeTextureDesc& desc);

    GLuint id() const { return m_handle.get(); }
    glm::ivec3 size(int mip = 0) const { return glm::max(m_size >> mip, glm::ivec3{1}); }
    int mips() const { return m_mips; }
    explicit operator bool() const { return id() != 0; }

    void bind(int unit) const { glBindTextureUnit(GLuint(unit), id()); }
    void bindImage(int unit) const; // for writing, mip 0

private:
    Handle<DeleteTexture> m_handle;
    Footprint m_footprint;
    glm::ivec3 m_size{0};
    int m_mips = 1;
    GLenum m_format = GL_RG8;
};

} // namespace renderer::gl
