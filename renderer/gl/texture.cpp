#include "renderer/gl/texture.h"

#include "io/base/contract.h"
#include "renderer/gl/machine.h"

#include <algorithm>
#include <bit>

namespace renderer::gl {
namespace {

std::uint64_t bytesPerTexel(GLenum format)
{
    switch (format) {
    case GL_R8: return 1;
    case GL_RG8: return 2;
    case GL_RGBA16F: return 8;
    case GL_RGBA32F: return 16;
    default: return 4;
    }
}

std::uint64_t bytesOf(const TextureDesc& desc)
{
    std::uint64_t texels = 0;
    for (int mip = 0; mip < desc.mips; ++mip) {
        const glm::ivec2 size = glm::max(desc.size >> mip, glm::ivec2{1});
        texels += std::uint64_t(size.x) * size.y;
    }
    return texels * bytesPerTexel(desc.format) * std::max(desc.layers, 1);
}

MemoryKind kindOf(const TextureDesc& desc)
{
    if (desc.compare) return MemoryKind::ShadowMaps;
    return desc.target ? MemoryKind::Targets : MemoryKind::Textures;
}

// Software GL pays for every sample: it goes without anisotropy, and takes the nearest mip.
float anisotropy()
{
    static const float best = [] {
        if (drawsInSoftware() || !epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic")) return 1.0f;
        GLfloat most = 1;
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
        return std::min(most, 8.0f);
    }();
    return best;
}

void setSampling(GLuint id, const TextureDesc& desc)
{
    const bool linear = desc.filter == GL_LINEAR;
    const GLenum smooth = desc.nearestMip || (desc.anisotropic && drawsInSoftware()) ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR;
    const GLenum mipped = linear ? smooth : GL_NEAREST_MIPMAP_NEAREST;
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GLint(desc.mips > 1 ? mipped : desc.filter));
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GLint(desc.filter));
    glTextureParameteri(id, GL_TEXTURE_WRAP_S, GLint(desc.wrap));
    glTextureParameteri(id, GL_TEXTURE_WRAP_T, GLint(desc.wrap));
    if (desc.compare) {
        glTextureParameteri(id, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glTextureParameteri(id, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    }
    if (desc.lodBias != 0) glTextureParameterf(id, GL_TEXTURE_LOD_BIAS, desc.lodBias);
    if (desc.anisotropic && anisotropy() > 1) glTextureParameterf(id, GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy());
}

} // namespace

int fullMipCount(glm::ivec2 size)
{
    return std::bit_width(unsigned(std::max({size.x, size.y, 1})));
}

Texture::Texture(const TextureDesc& desc)
    : m_footprint{kindOf(desc), bytesOf(desc)}, m_size{desc.size}, m_layers{desc.layers}, m_mips{desc.mips}, m_format{desc.format}
{
    EXPECTS(desc.size.x > 0 && desc.size.y > 0);
    GLuint id = 0;
    glCreateTextures(desc.layers ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D, 1, &id);
    m_handle = Handle<DeleteTexture>{id};
    if (desc.layers) {
        glTextureStorage3D(id, desc.mips, desc.format, desc.size.x, desc.size.y, desc.layers);
    } else {
        glTextureStorage2D(id, desc.mips, desc.format, desc.size.x, desc.size.y);
    }
    expectMemory();
    setSampling(id, desc);
    glObjectLabel(GL_TEXTURE, id, GLsizei(desc.label.size()), desc.label.data());
}

void Texture::upload(const void* pixels, GLenum format, GLenum type, int mip, int layer) const
{
    const glm::ivec2 extent = size(mip);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    if (m_layers) {
        glTextureSubImage3D(id(), mip, 0, 0, layer, extent.x, extent.y, 1, format, type, pixels);
    } else {
        glTextureSubImage2D(id(), mip, 0, 0, extent.x, extent.y, format, type, pixels);
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void Texture::uploadPart(glm::ivec2 low, glm::ivec2 extent, const void* pixels, GLenum format, GLenum type, int mip, int layer,
                         int stride) const
{
    EXPECTS(glm::all(glm::greaterThanEqual(low, glm::ivec2{0})) && glm::all(glm::lessThanEqual(low + extent, size(mip))));
    if (extent.x <= 0 || extent.y <= 0) return;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, stride);
    if (m_layers) {
        glTextureSubImage3D(id(), mip, low.x, low.y, layer, extent.x, extent.y, 1, format, type, pixels);
    } else {
        glTextureSubImage2D(id(), mip, low.x, low.y, extent.x, extent.y, format, type, pixels);
    }
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

} // namespace renderer::gl
