// A 2D texture or an array of them: storage fixed at birth, labelled, with its sampling state.
#pragma once

#include "renderer/gl/handle.h"

#include <glm/glm.hpp>
#include <string_view>

namespace renderer::gl {

struct DeleteTexture {
    void operator()(GLuint id) const { glDeleteTextures(1, &id); }
};

struct TextureDesc {
    std::string_view label;      // what a debugger shows
    glm::ivec2 size{1};
    int layers = 0;              // 0: a plain 2D texture, else an array
    GLenum format = GL_RGBA8;
    int mips = 1;
    GLenum filter = GL_LINEAR;   // between mips too, where there are any
    GLenum wrap = GL_CLAMP_TO_EDGE;
    bool target = false;         // passes draw into it at each frame: for the memory's statistics
    bool compare = false;        // a shadow map: sampled by comparing, lit when nearer or equal
    bool nearestMip = false;     // of two that would be mixed
    bool anisotropic = false;    // a surface's: filtered as well as the machine can bear
    float lodBias = 0;           // negative: sharper mips
};

class Texture {
public:
    Texture() = default;
    explicit Texture(const TextureDesc& desc);

    GLuint id() const { return m_handle.get(); }
    glm::ivec2 size(int mip = 0) const // 0 when empty
    {
        return id() ? glm::max(m_size >> mip, glm::ivec2{1}) : glm::ivec2{0};
    }
    int layers() const { return m_layers; }
    int mips() const { return m_mips; }
    GLenum format() const { return m_format; }
    explicit operator bool() const { return id() != 0; }

    // Whole mip of one layer, rows tightly packed.
    void upload(const void* pixels, GLenum format, GLenum type, int mip = 0, int layer = 0) const;
    // A part of a mip of one layer; its rows lie `stride` pixels apart, 0: tightly packed.
    void uploadPart(glm::ivec2 low, glm::ivec2 extent, const void* pixels, GLenum format, GLenum type, int mip = 0, int layer = 0,
                    int stride = 0) const;

private:
    Handle<DeleteTexture> m_handle;
    Footprint m_footprint;
    glm::ivec2 m_size{0};
    int m_layers = 0;
    int m_mips = 1;
    GLenum m_format = GL_RGBA8;
};

int fullMipCount(glm::ivec2 size);

} // namespace renderer::gl
