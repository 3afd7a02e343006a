#include "renderer/gl/volume_texture.h"

#include "io/base/contract.h"

namespace renderer::gl {
namespace {

std::uint64_t bytesOf(const VolumeTextureDesc& desc)
{
    const std::uint64_t texel = desc.format == GL_R8 ? 1 : desc.format == GL_RG8 ? 2 : desc.format == GL_RGBA16F ? 8 : 4;
    std::uint64_t texels = 0;
    for (int mip = 0; mip < desc.mips; ++mip) {
        const glm::ivec3 size = glm::max(desc.size >> mip, glm::ivec3{1});
        texels += std::uint64_t(size.x) * size.y * size.z;
    }
    return texels * texel;
}

} // namespace

VolumeTexture::VolumeTexture(const VolumeTextureDesc& desc)
    : m_footprint{MemoryKind::Textures, bytesOf(desc)}, m_size{desc.size}, m_mips{desc.mips}, m_format{desc.format}
{
    EXPECTS(glm::all(glm::greaterThan(desc.size, glm::ivec3{0})));
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_3D, 1, &id);
    m_handle = Handle<DeleteTexture>{id};
    glTextureStorage3D(id, desc.mips, desc.format, desc.size.x, desc.size.y, desc.size.z);
    expectMemory();
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, desc.mips > 1 ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTextureParameteri(id, axis, GL_REPEAT);
    glObjectLabel(GL_TEXTURE, id, GLsizei(desc.label.size()), desc.label.data());
}

void VolumeTexture::bindImage(int unit) const
{
    glBindImageTexture(GLuint(unit), id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, m_format);
}

} // namespace renderer::gl
